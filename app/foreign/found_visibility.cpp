// SPDX-License-Identifier: MIT
#include "app/foreign/found_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "app/foreign/foreign_picture.h"
#include "app/foreign/statistics.h"

namespace shadowlab::foreign {

namespace {

using trace::Visibility;

using LinearOfByte = std::array<double, 256>;

/// What two pixels say of the light, in the channel that shows it best.
struct PairedPixel {
    double darker = 0;   ///< (R - P) / R
    double expected = 0; ///< D / R in the scene's own shading
    double levels = 0;   ///< of 255, that D is worth
    bool isClipped = false;
};

PairedPixel paired(image::Color8 shaded, image::Color8 reference, const vec3& ofLight, const vec3& remaining, ToneCurve curve, const LinearOfByte& linear) {
    // Of a reference that is white, brighter light would look the same: then the darker picture says nothing of how much is missing.
    const std::array p{shaded.r, shaded.g, shaded.b}, r{reference.r, reference.g, reference.b};
    PairedPixel best;
    best.isClipped = r[0] == 255 && r[1] == 255 && r[2] == 255;
    for (int channel = 0; channel < 3; ++channel) {
        const std::size_t c = static_cast<std::size_t>(channel);
        const double whole = static_cast<double>(ofLight[channel] + remaining[channel]);
        if (whole <= 0) continue;
        const double share = static_cast<double>(ofLight[channel]) / whole, full = linear[r[c]];
        const double levels = r[c] - 255 * encodedWith(curve, full * (1 - share));
        if (levels <= best.levels || r[c] == 255) continue;
        const double seen = linear[p[c]];
        best.levels = levels;
        best.expected = share;
        best.darker = full > 0 ? (full - seen) / full : 0;
    }
    return best;
}

picture::VisibilityImage emptyImage(ivec2 size) {
    picture::VisibilityImage image;
    image.width = size.x;
    image.height = size.y;
    image.greyAlpha.assign(2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 0);
    return image;
}

/// The middle of (R - P) / R over D / R among pixels that have lost a good part of the light; 1 where there are too few.
double strengthOf(const std::vector<PairedPixel>& pixels, const judge::Truth& truth) {
    // Less is a pixel that is lit, or whose noise would decide; a foreign renderer's share is not half or twice that of the scene.
    constexpr double kClearlyDarker = 0.4, kMost = 2;
    constexpr std::size_t kEnough = 16;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (facesTheLight(truth.visibility[i]) && pixels[i].levels >= 2 * kLeastLevels &&
            pixels[i].darker > kClearlyDarker * pixels[i].expected)
            ratios.push_back(pixels[i].darker / pixels[i].expected);
    if (ratios.size() < kEnough) return 1;
    return std::clamp(middleOf(std::move(ratios)), 1 / kMost, kMost);
}

/// R over the radiance of the scene's own shading: the middle of all pixels that face the light and are not black.
double exposureOf(const image::Image& reference, const judge::Truth& truth, const ExpectedLight& expected, const LinearOfByte& linear) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        const double whole = static_cast<double>(expected.ofLight[i].g + expected.remaining[i].g);
        const std::uint8_t seen = reference.rgba[image::kChannels * i + 1];
        if (facesTheLight(truth.visibility[i]) && whole > 0 && seen > kLeastLevels && seen < 255) ratios.push_back(linear[seen] / whole);
    }
    return ratios.empty() ? 1 : middleOf(std::move(ratios));
}

/// Of the light, 0 to 1. `strength`: see strengthOf().
double seenShare(const PairedPixel& pixel, double strength) {
    const double added = std::min(strength * pixel.expected, 1.0);
    return added > 0 ? std::clamp(1 - pixel.darker / added, 0.0, 1.0) : 1.0;
}

/// Is the reference as dark as if the light did not reach it? `exposure`: see exposureOf().
bool lacksLight(double referenceGreen, const vec3& ofLight, const vec3& remaining, double exposure) {
    // Where most of the scene's light is the judged one, shading that differs by less than three is not taken for none.
    constexpr double kLeastShare = 0.5, kGone = 0.75;
    const double whole = static_cast<double>(ofLight.g + remaining.g), share = whole > 0 ? static_cast<double>(ofLight.g) / whole : 0;
    return share >= kLeastShare && referenceGreen < exposure * whole * (1 - kGone * share);
}

/// The objects of which the reference lacks the light nearly everywhere: they are not drawn, or not lit. In other places shading differs.
std::map<std::uint32_t, bool> objectsThatLackLight(const std::vector<std::uint8_t>& lacks, const judge::Truth& truth) {
    constexpr double kNearlyAll = 0.9;
    constexpr int kFewest = 16;
    std::map<std::uint32_t, std::pair<int, int>> counts; // that lack it, and all
    for (std::size_t i = 0; i < lacks.size(); ++i)
        if (facesTheLight(truth.visibility[i])) counts[truth.objects[i]].first += lacks[i], ++counts[truth.objects[i]].second;
    std::map<std::uint32_t, bool> lacking;
    for (const auto& [object, count] : counts)
        lacking[object] = count.first >= kFewest && count.first > kNearlyAll * count.second;
    return lacking;
}

} // namespace

FoundVisibility fromVisibilityImage(const image::Image& picture, const judge::Truth& truth) {
    FoundVisibility found{emptyImage(truth.size), std::vector<std::uint8_t>(truth.visibility.size(), 1)};
    const bool saysWhere = hasTransparency(picture);
    constexpr int kHalf = 128; // a pixel that is half covered may have its centre on either side
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        const std::uint8_t* const pixel = picture.rgba.data() + image::kChannels * i;
        const bool covered = saysWhere ? pixel[3] >= kHalf : truth.visibility[i] != Visibility::noSurface;
        found.image.greyAlpha[2 * i] = pixel[1];
        found.image.greyAlpha[2 * i + 1] = covered ? 255 : 0;
    }
    return found;
}

FoundVisibility fromPair(const image::Image& shaded, const image::Image& reference, const judge::Truth& truth,
                         const ExpectedLight& expected, ToneCurve curve) {
    FoundVisibility found{emptyImage(truth.size), std::vector<std::uint8_t>(truth.visibility.size(), 0)};
    LinearOfByte linear{};
    for (std::size_t byte = 0; byte < linear.size(); ++byte)
        linear[byte] = linearFrom(curve, static_cast<double>(byte) / 255.0);
    std::vector<PairedPixel> pixels(truth.visibility.size()), flat(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int x = static_cast<int>(i % static_cast<std::size_t>(truth.size.x)), y = static_cast<int>(i / static_cast<std::size_t>(truth.size.x));
        pixels[i] = paired(shaded.at(x, y), reference.at(x, y), expected.ofLight[i], expected.remaining[i], curve, linear);
        flat[i] = paired(shaded.at(x, y), reference.at(x, y), expected.ofLightFlat[i], expected.remaining[i], curve, linear);
    }
    found.isSame.assign(pixels.size(), 0);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t byte = image::kChannels * i;
        bool same = true;
        for (std::size_t channel = 0; channel < 3; ++channel)
            same = same && std::abs(shaded.rgba[byte + channel] - reference.rgba[byte + channel]) < kLeastLevels / 2;
        found.isSame[i] = same ? 1 : 0;
    }
    found.strength = strengthOf(pixels, truth);
    const double exposure = exposureOf(reference, truth, expected, linear);
    std::vector<std::uint8_t> lacks(pixels.size(), 0);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const vec3 least = glm::min(expected.ofLight[i], expected.ofLightFlat[i]);
        const std::uint8_t green = reference.rgba[image::kChannels * i + 1]; // of white, there may be any light more
        lacks[i] = found.isSame[i] && green < 255 && lacksLight(linear[green], least, expected.remaining[i], exposure) ? 1 : 0;
    }
    const std::map<std::uint32_t, bool> lackingObjects = objectsThatLackLight(lacks, truth);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const bool surface = truth.visibility[i] != Visibility::noSurface;
        found.image.greyAlpha[2 * i + 1] = surface ? 255 : 0;
        if (!facesTheLight(truth.visibility[i])) {
            found.isJudged[i] = 1; // no light to find: a pair cannot be wrong there
            continue;
        }
        if (pixels[i].isClipped) ++found.clipped;
        if (lacks[i] && lackingObjects.at(truth.objects[i])) {
            found.isJudged[i] = 1; // grey stays 0
            continue;
        }
        const double visible = seenShare(pixels[i], found.strength), visibleFlat = seenShare(flat[i], found.strength);
        // Smooth or flat: the pictures do not say which normals their program has, so both must lead to the same.
        // Nor is the light's share of a pixel known exactly, which depends on how bright the rest is in that program: less so of faint light.
        constexpr double kFaintLevels = 4 * kLeastLevels, kClearly = 0.1, kClearlyFaint = 0.25;
        const double clearly = std::min(pixels[i].levels, flat[i].levels) < kFaintLevels ? kClearlyFaint : kClearly;
        const bool isUndecided = (visible > 0.5) != (visibleFlat > 0.5) || std::abs(visible - 0.5) < clearly || std::abs(visibleFlat - 0.5) < clearly;
        // Where the same is seen and hardly any light was there to be lost, the pictures do not say whether it is seen.
        if (lacks[i] || isUndecided || std::min(pixels[i].levels, flat[i].levels) < kLeastLevels) {
            ++found.notJudged;
            continue;
        }
        found.isJudged[i] = 1;
        found.image.greyAlpha[2 * i] = static_cast<std::uint8_t>(std::lround(255 * visible));
    }
    return found;
}

double greyShare(const image::Image& picture, const judge::Truth& truth) {
    constexpr int kFromEnds = 13; // a twentieth
    int greys = 0, all = 0;
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        if (!facesTheLight(truth.visibility[i])) continue;
        const std::uint8_t* const pixel = picture.rgba.data() + image::kChannels * i;
        if (pixel[3] < 128) continue;
        ++all;
        greys += pixel[1] > kFromEnds && pixel[1] < 255 - kFromEnds;
    }
    return all > 0 ? static_cast<double>(greys) / all : 0;
}

} // namespace shadowlab::foreign
