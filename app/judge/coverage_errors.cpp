// SPDX-License-Identifier: MIT
#include "app/judge/coverage_errors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shadowlab::judge {

namespace {

/// Adds one error; finish() turns the sums into means.
void addError(ShareErrors& sums, double error) {
    ++sums.pixels;
    sums.rmse += error * error;
    sums.mean += error;
    sums.largest = std::max(sums.largest, error);
}

void finish(ShareErrors& sums) {
    if (sums.pixels == 0) return;
    sums.rmse = std::sqrt(sums.rmse / sums.pixels);
    sums.mean /= sums.pixels;
}

} // namespace

PixelAnswers meansOfSamples(std::span<const std::uint8_t> greyAlpha, std::span<const std::uint8_t> facing, ivec2 size,
                            int samples) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    if (facing.size() != pixels * static_cast<std::size_t>(samples * samples) || greyAlpha.size() != 2 * facing.size())
        throw std::logic_error("a visibility image of another size than its samples");
    PixelAnswers answers{std::vector<float>(pixels, 0.0f), std::vector<std::uint8_t>(pixels, 0)};
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::size_t row = static_cast<std::size_t>(size.x), side = static_cast<std::size_t>(samples);
        const std::size_t corner = (i / row) * side * row * side + (i % row) * side; // the first sample of the pixel
        double sum = 0;
        int count = 0;
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t sample = corner + y * row * side + x;
                if (!facing[sample]) continue;
                sum += greyAlpha[2 * sample] / 255.0;
                ++count;
            }
        answers.answered[i] = count > 0;
        if (count > 0) answers.visibility[i] = static_cast<float>(sum / count);
    }
    return answers;
}

CoverageErrors coverageErrors(const Coverage& coverage, const PixelAnswers& answers, std::span<const std::uint8_t> ties,
                              int samples) {
    CoverageErrors errors{.points = coverage.points, .samples = samples, .all = {}, .edge = {}, .outline = {}};
    for (std::size_t i = 0; i < coverage.kinds.size(); ++i) {
        const PixelKind kind = coverage.kinds[i];
        if (kind == PixelKind::none || !answers.answered[i]) continue;
        if (kind == PixelKind::whole && ties[i]) continue;
        const double error =
            std::abs(static_cast<double>(answers.visibility[i]) - static_cast<double>(coverage.shares[i]));
        addError(errors.all, error);
        if (kind == PixelKind::edge) addError(errors.edge, error);
        if (kind == PixelKind::outline) addError(errors.outline, error);
    }
    for (ShareErrors* const part : {&errors.all, &errors.edge, &errors.outline})
        finish(*part);
    return errors;
}

} // namespace shadowlab::judge
