// SPDX-License-Identifier: MIT
#include "app/judge/verdict.h"

#include <cmath>
#include <stdexcept>

namespace shadowlab::judge {

namespace {

using trace::Visibility;

Verdict verdictOf(Visibility truth, bool covered, bool lit) {
    if (truth == Visibility::noSurface) return covered ? Verdict::stray : Verdict::background;
    const bool shouldBeLit = truth == Visibility::lit;
    if (covered && lit == shouldBeLit) return Verdict::correct;
    return shouldBeLit ? Verdict::falseShadow : Verdict::falseLit;
}

} // namespace

Region shownPart(const Region& region, ivec2 size) {
    if (region.size.x <= 0 || region.size.y <= 0) return {ivec2(0), size};
    const ivec2 corner = glm::max(region.corner, ivec2(0)), end = glm::min(region.corner + region.size, size);
    return {corner, glm::max(end - corner, ivec2(0))};
}

bool isWrong(Verdict verdict) {
    return verdict == Verdict::falseLit || verdict == Verdict::falseShadow || verdict == Verdict::stray;
}

Judgement judge(const Truth& truth, std::span<const std::uint8_t> greyAlpha, const Region& region) {
    const auto [corner, size] = shownPart(region, truth.size);
    if (greyAlpha.size() != 2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))
        throw std::logic_error("a visibility image of another size than the region it is judged in");
    Judgement judgement;
    judgement.verdicts.assign(truth.visibility.size(), Verdict::background);
    Counts& counts = judgement.counts;
    double squares = 0;
    const std::uint8_t* pixel = greyAlpha.data();
    for (int y = corner.y; y < corner.y + size.y; ++y)
        for (int x = corner.x; x < corner.x + size.x; ++x, pixel += 2) {
            const std::size_t i = truth.index(x, y);
            const Visibility expected = truth.visibility[i];
            const std::uint8_t grey = pixel[0];
            const bool covered = pixel[1] == 255;
            const bool surface = expected != Visibility::noSurface, tie = truth.ties[i] != 0;
            const Verdict verdict = tie ? Verdict::tie : verdictOf(expected, covered, grey > 127);
            judgement.verdicts[i] = verdict;
            counts.pixels += surface;
            counts.stray += verdict == Verdict::stray;
            counts.falseLit += verdict == Verdict::falseLit;
            counts.falseShadow += verdict == Verdict::falseShadow;
            if (!surface) continue;
            if (tie) {
                ++counts.ties;
                continue;
            }
            counts.lit += expected == Visibility::lit;
            counts.shadowed += expected == Visibility::shadowed;
            counts.turnedAway += expected == Visibility::turnedAway;
            const double error = grey / 255.0 - truth.share(i);
            squares += error * error;
        }
    const int judged = counts.lit + counts.shadowed + counts.turnedAway;
    counts.rmse = judged > 0 ? std::sqrt(squares / judged) : 0.0;
    return judgement;
}

} // namespace shadowlab::judge
