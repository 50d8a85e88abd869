// SPDX-License-Identifier: MIT
#include "app/foreign/seen_encoding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "app/foreign/statistics.h"

namespace shadowlab::foreign {

namespace {

struct Brightness {
    double expected = 0; ///< linear
    double number = 0;   ///< of the picture, 0 to 1
};

/// The middle of the differences in levels of 255, at the exposure that fits best.
double levelsOff(const std::vector<Brightness>& seen, ToneCurve curve, bool anyExposure) {
    std::vector<double> ratios, differences;
    for (const Brightness& one : seen)
        ratios.push_back(linearFrom(curve, one.number) / one.expected);
    const double exposure = anyExposure ? middleOf(ratios) : 1;
    for (const Brightness& one : seen)
        differences.push_back(255 * std::abs(encodedWith(curve, exposure * one.expected) - one.number));
    return middleOf(differences);
}

/// One for each step of brightness, so that a large floor does not outweigh all else.
std::vector<Brightness> steps(const std::vector<Brightness>& pixels) {
    constexpr double kToAnOctave = 8;
    constexpr std::size_t kEnough = 12; // pixels of a step
    std::map<int, std::vector<Brightness>> byStep;
    for (const Brightness& one : pixels)
        byStep[static_cast<int>(std::floor(kToAnOctave * std::log2(one.expected)))].push_back(one);
    std::vector<Brightness> middles;
    for (auto& [step, all] : byStep) {
        if (all.size() < kEnough) continue;
        middles.push_back(middleOf(std::move(all), [](const Brightness& one) { return one.number / one.expected; }));
    }
    return middles;
}

std::optional<SeenEncoding> wrongEncoding(const std::vector<Brightness>& pixels, ToneCurve rightCurve) {
    const bool anyExposure = rightCurve != ToneCurve::linear; // the white of a visibility image is 1
    constexpr std::size_t kEnoughSteps = 5;
    constexpr double kLeastRange = 2.5; // of brightness: curves then differ by some levels
    const std::vector<Brightness> seen = steps(pixels);
    if (seen.size() < kEnoughSteps || seen.back().expected < kLeastRange * seen.front().expected) return std::nullopt;
    SeenEncoding best;
    best.levels = 1e300;
    for (const ToneCurve curve : kToneCurves) {
        const double levels = levelsOff(seen, curve, anyExposure);
        if (curve == rightCurve) best.levelsOfRight = levels;
        if (levels < best.levels) best.levels = levels, best.curve = curve;
    }
    // Rounding leaves half a level; where another curve is to be believed, it is right within a few and clearly better.
    constexpr double kMostLevels = 4, kClearly = 0.5, kLeastDifference = 2;
    // A curve that leaves nothing but rounding, in so many steps, is believed for less.
    constexpr double kRounding = 0.75, kMoreThanRounding = 1.25;
    const bool exactly = best.levels < kRounding && best.levelsOfRight > kMoreThanRounding;
    const bool clearly = best.levels < kMostLevels && best.levels < kClearly * best.levelsOfRight && best.levelsOfRight - best.levels > kLeastDifference;
    if (best.curve == rightCurve || !(clearly || exactly)) return std::nullopt;
    return best;
}

} // namespace

std::optional<SeenEncoding> wrongEncodingOf(const image::Image& reference, const ExpectedLight& expected) {
    // A program may draw the judged light alone: then the others are not in its reference.
    const auto seenWith = [&](bool others, bool dullOnly) {
        std::vector<Brightness> seen;
        for (std::size_t i = 0; i < expected.ofLight.size(); ++i) {
            const std::uint8_t* const pixel = reference.rgba.data() + image::kChannels * i;
            const double light = static_cast<double>(expected.ofLight[i].g + expected.remaining[i].g - (others ? 0.0f : expected.ofOthers[i].g));
            // Where smooth and flat normals give the same, so that it does not matter which the other program has.
            constexpr float kAlike = 0.03f;
            const bool isAlike = std::abs(expected.ofLight[i].g - expected.ofLightFlat[i].g) <= kAlike * expected.ofLight[i].g;
            const bool counts = !dullOnly || (isAlike && expected.isDull[i] != 0);
            if (counts && expected.ofLight[i].g > 0 && pixel[1] > 0 && pixel[1] < 255) seen.push_back({light, pixel[1] / 255.0});
        }
        return seen;
    };
    const auto all = wrongEncoding(seenWith(true, false), ToneCurve::srgb);
    if (all) return all;
    // sRGB is right if it fits either.
    const auto alone = wrongEncoding(seenWith(false, true), ToneCurve::srgb);
    constexpr double kFits = 4; // levels, as where another curve is to be believed
    if (alone && levelsOff(steps(seenWith(true, true)), ToneCurve::srgb, true) > kFits) return alone;
    return std::nullopt;
}

std::optional<Orientation> orientationOf(const image::Image& reference, const ExpectedLight& expected, const vec3& background) {
    std::vector<double> shading; // as sRGB encodes it
    for (std::size_t i = 0; i < expected.ofLight.size(); ++i) {
        const float light = expected.ofLight[i].g + expected.remaining[i].g;
        shading.push_back(encodedWith(ToneCurve::srgb, static_cast<double>(light > 0 ? light : background.g)));
    }
    const auto likeness = [&](const Orientation& orientation) {
        Correlation correlation;
        for (int y = 0; y < reference.height; ++y)
            for (int x = 0; x < reference.width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width) + static_cast<std::size_t>(x);
                const double seen = reference.at(orientation.mirrorsX ? reference.width - 1 - x : x, orientation.mirrorsY ? reference.height - 1 - y : y).g / 255.0;
                correlation.add(shading[i], seen);
            }
        return correlation.value();
    };
    std::optional<Orientation> best;
    double most = -1, second = -1;
    for (const Orientation& orientation : {Orientation{}, Orientation{false, true, false}, Orientation{false, false, true}, Orientation{false, true, true}}) {
        const double found = likeness(orientation);
        if (found > most)
            second = most, most = found, best = orientation;
        else
            second = std::max(second, found);
    }
    // A picture of the scene agrees with its shading; mirrored it does so by chance, or where the scene is symmetric.
    constexpr double kAgrees = 0.6, kClearly = 0.1;
    if (most < kAgrees || most - second < kClearly) return std::nullopt;
    return best;
}

std::optional<SeenEncoding> wrongEncodingOf(const image::Image& visibility, const judge::Truth& truth) {
    if (truth.shares.empty()) return std::nullopt;
    std::vector<Brightness> seen;
    for (std::size_t i = 0; i < truth.shares.size(); ++i) {
        const double share = static_cast<double>(truth.shares[i]);
        constexpr double kFromEnds = 0.02;
        if (share > kFromEnds && share < 1 - kFromEnds) seen.push_back({share, visibility.rgba[image::kChannels * i + 1] / 255.0});
    }
    return wrongEncoding(seen, ToneCurve::linear);
}

} // namespace shadowlab::foreign
