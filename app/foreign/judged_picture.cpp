// SPDX-License-Identifier: MIT
#include "app/foreign/judged_picture.h"

#include <algorithm>

#include "app/foreign/foreign_picture.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::foreign {

namespace {

/// Of a light without area: a shaded picture has hardly anything else; filtered acne leaves some pixels black or white.
constexpr double kMostGreys = 0.9;

void requireVisibilityImage(const image::Image& picture, const judge::Truth& truth, bool hasArea) {
    constexpr const char* kRemedy = "; name the picture without shadows with --reference";
    if (!isGrey(picture)) throw Error(ExitStatus::badInput, std::string("has colours, so it is a shaded picture and no visibility image") + kRemedy);
    if (!hasArea && greyShare(picture, truth) > kMostGreys)
        throw Error(ExitStatus::badInput, std::string("consists of greys between black and white, so it is a shaded picture and no visibility image of a light without area") + kRemedy);
}

/// Pixels with a surface, those of them that are brighter in the picture than in its reference, and those that are darker.
struct PairOrder {
    int brighter = 0, darker = 0;
};
PairOrder orderOf(const image::Image& picture, const image::Image& reference, const judge::Truth& truth) {
    PairOrder order;
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        if (truth.visibility[i] == trace::Visibility::noSurface) continue;
        const int p = picture.rgba[image::kChannels * i + 1], r = reference.rgba[image::kChannels * i + 1];
        if (p >= r + kLeastLevels) ++order.brighter;
        if (r >= p + kLeastLevels) ++order.darker;
    }
    return order;
}

/// Pixels with a surface that the picture says has none.
int transparentIn(const image::Image& picture, const judge::Truth& truth, int& surfaces) {
    int transparent = 0;
    surfaces = 0;
    for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
        if (truth.visibility[i] == trace::Visibility::noSurface) continue;
        ++surfaces;
        transparent += picture.rgba[image::kChannels * i + 3] < 128;
    }
    return transparent;
}

/// What the pictures are wrong in as a whole. Throws Error where they cannot be judged so.
std::string remarkOn(const image::Image& picture, const image::Image* reference, const judge::Truth& truth) {
    constexpr double kMost = 0.5, kMany = 0.02;
    constexpr int kFewest = 16; // pixels: fewer are noise
    if (reference) {
        const auto [brighter, darker] = orderOf(picture, *reference, truth);
        if (brighter < kFewest) return "";
        const std::string what = "is brighter than its reference at " + std::to_string(brighter) + " pixels, and darker at " + std::to_string(darker) +
                                 "; shadows only take light away: the two may be exchanged, or the reference may lack ambient light or another light";
        if (brighter > kMost * (brighter + darker)) throw Error(ExitStatus::badInput, what);
        return brighter > kMany * (brighter + darker) ? "the picture " + what : "";
    }
    int surfaces = 0;
    const int transparent = transparentIn(picture, truth, surfaces);
    if (surfaces == 0 || transparent < kFewest) return "";
    if (transparent == surfaces) throw Error(ExitStatus::badInput, "is transparent at every pixel where the scene has a surface; write it without alpha, or with alpha 255 on surfaces");
    if (transparent < kMany * surfaces) return "";
    return "the picture is transparent at " + std::to_string(transparent) + " of " + std::to_string(surfaces) + " pixels where the scene has a surface: alpha 0 says that there is none";
}

/// The grey that stands for white in a visibility image of black and one other grey; nothing where that is 255, or where there are more.
std::optional<int> darkWhite(const image::Image& picture) {
    constexpr int kNearlyWhite = 250; // more is rounding
    constexpr double kAlmostAll = 0.98; // the rest are edges
    int most = 0;
    for (std::size_t i = 1; i < picture.rgba.size(); i += image::kChannels)
        most = std::max(most, static_cast<int>(picture.rgba[i]));
    if (most == 0 || most >= kNearlyWhite) return std::nullopt;
    std::size_t ends = 0, blacks = 0;
    for (std::size_t i = 1; i < picture.rgba.size(); i += image::kChannels)
        ends += picture.rgba[i] == 0 || picture.rgba[i] == most, blacks += picture.rgba[i] == 0;
    if (blacks == 0 && most > 1) return std::nullopt; // one grey all over is no visibility
    if (static_cast<double>(ends) < kAlmostAll * static_cast<double>(picture.rgba.size()) / image::kChannels) return std::nullopt;
    return most;
}

image::Image brightenedTo255(const image::Image& picture, int white) {
    image::Image bright = picture;
    for (std::size_t i = 0; i < bright.rgba.size(); ++i)
        if (i % image::kChannels != 3) bright.rgba[i] = static_cast<std::uint8_t>(std::min(255, (bright.rgba[i] * 255 + white / 2) / white));
    return bright;
}

/// What cannot be judged counts as a tie while pixels are compared.
void excludeNotJudged(const FoundVisibility& found, judge::Truth& truth) {
    for (std::size_t i = 0; i < truth.ties.size(); ++i)
        if (!found.isJudged[i]) truth.ties[i] = 1;
}

int tiesOf(const judge::Truth& truth) {
    int ties = 0;
    for (std::size_t i = 0; i < truth.ties.size(); ++i)
        ties += truth.ties[i] != 0 && truth.visibility[i] != trace::Visibility::noSurface;
    return ties;
}

} // namespace

JudgedPicture judgePicture(const scene::Snapshot& scene, int light, judge::TruthOf truthOf, const image::Image& picture,
                           const image::Image* reference) {
    JudgedPicture judged;
    std::optional<Orientation> orientation;
    const ivec2 size(picture.width, picture.height);
    trace::SceneTracer tracer;
    tracer.advance(scene, std::chrono::steady_clock::time_point::max());
    judged.truthOf = truthOf;
    // No rasteriser of this program has a say: another one's rounding is not known.
    judged.truth = judge::exactTruth(tracer, scene->camera, size, light, judge::Rasterised{}, {}, judged.truthOf);
    judged.remark = remarkOn(picture, reference, judged.truth);
    if (reference) {
        const ExpectedLight expected = expectedLight(tracer, scene->camera, size, light);
        orientation = orientationOf(*reference, expected, scene->background);
        judged.encoding = wrongEncodingOf(putUpright(*reference, orientation.value_or(Orientation{})), expected);
        judged.found = fromPair(picture, *reference, judged.truth, expected, judged.encoding ? judged.encoding->curve : ToneCurve::srgb);
    } else {
        judged.white = darkWhite(picture);
        const image::Image read = judged.white ? brightenedTo255(picture, *judged.white) : picture;
        requireVisibilityImage(read, judged.truth, judged.truthOf == judge::TruthOf::area);
        judged.encoding = wrongEncodingOf(read, judged.truth);
        judged.found = fromVisibilityImage(read, judged.truth);
    }
    const int ties = tiesOf(judged.truth);
    excludeNotJudged(judged.found, judged.truth);
    judged.found.notJudged = tiesOf(judged.truth) - ties;

    const std::vector<judge::BoundaryEdge> boundary = judge::trueBoundary(judged.truth);
    judged.errors = judge::slotErrors(judged.truth, boundary, judged.found.image.greyAlpha);
    judged.errors.judgement.counts.ties = ties;
    const judge::Grid<float> boundaryPx = judge::distanceToBoundary(boundary, size);
    judged.core = judge::coreErrors(judged.truth, judged.errors.judgement, boundaryPx, std::nullopt);
    judged.boundaryPx = judge::displacement(judged.truth, boundary, judged.found.image.greyAlpha);
    if (judged.errors.judgement.counts.wrong() > 0) {
        Evidence evidence{tracer, scene->camera, judged.truth, judged.found, judged.errors.judgement, boundary, boundaryPx, light, orientation};
        judged.diagnosis = diagnose(evidence);
    }
    return judged;
}

} // namespace shadowlab::foreign
