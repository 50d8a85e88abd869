// SPDX-License-Identifier: MIT
#include "app/foreign/judged_picture.h"

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
    if (reference) {
        const ExpectedLight expected = expectedLight(tracer, scene->camera, size, light);
        orientation = orientationOf(*reference, expected, scene->background);
        judged.encoding = wrongEncodingOf(putUpright(*reference, orientation.value_or(Orientation{})), expected);
        judged.found = fromPair(picture, *reference, judged.truth, expected, judged.encoding ? judged.encoding->curve : ToneCurve::srgb);
    } else {
        requireVisibilityImage(picture, judged.truth, judged.truthOf == judge::TruthOf::area);
        judged.encoding = wrongEncodingOf(picture, judged.truth);
        judged.found = fromVisibilityImage(picture, judged.truth);
    }
    const int ties = tiesOf(judged.truth);
    excludeNotJudged(judged.found, judged.truth);
    judged.found.notJudged = tiesOf(judged.truth) - ties;

    const std::vector<judge::BoundaryEdge> boundary = judge::trueBoundary(judged.truth);
    judged.errors = judge::slotErrors(judged.truth, boundary, judged.found.image.greyAlpha);
    judged.errors.judgement.counts.ties = ties;
    Evidence evidence{tracer, scene->camera, judged.truth, judged.found, judged.errors.judgement, judge::distanceToBoundary(boundary, size), light, orientation};
    judged.core = judge::coreErrors(judged.truth, judged.errors.judgement, evidence.boundaryPx, std::nullopt);
    judged.boundaryPx = judge::displacement(judged.truth, boundary, judged.found.image.greyAlpha);
    if (judged.errors.judgement.counts.wrong() > 0) judged.diagnosis = diagnose(evidence);
    return judged;
}

} // namespace shadowlab::foreign
