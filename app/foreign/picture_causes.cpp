// Mistakes of the whole picture. What another view would show is first looked up in the truth of this one, to the nearest pixel, and
// then asked with rays.
// SPDX-License-Identifier: MIT

#include "app/foreign/calibration_words.h"
#include "app/foreign/causes.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

using trace::Visibility;

/// A view that is placed otherwise: what belongs at `from` the middle of the picture is seen at scale * from + shift.
struct OtherView {
    dvec2 scale{1.0}, shiftPx{0.0};
    [[nodiscard]] dvec2 source(const Evidence& evidence, const dvec2& place) const {
        const dvec2 middle = 0.5 * dvec2(evidence.size());
        return middle + (place - middle - shiftPx) / scale;
    }
};

Prediction predictedBy(const Evidence& evidence, const Sample& sample, Visibility visibility) {
    return visibility == Visibility::noSurface ? ofBackground(evidence, sample) : predicted(visibility == Visibility::lit);
}

Prediction lookedUp(const Evidence& evidence, const Sample& sample, const dvec2& place) {
    const ivec2 pixel(glm::floor(place));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= evidence.size().x || pixel.y >= evidence.size().y) return Prediction::none;
    return predictedBy(evidence, sample, evidence.truth.visibility[evidence.truth.index(pixel.x, pixel.y)]);
}

Predictions lookedUp(const Evidence& evidence, const OtherView& view) {
    Predictions predictions;
    for (const Sample& sample : evidence.samples)
        predictions.push_back(lookedUp(evidence, sample, view.source(evidence, dvec2(sample.pixel) + 0.5)));
    return predictions;
}

Predictions traced(const Evidence& evidence, const OtherView& view) {
    const trace::EyeRays rays = evidence.tracer.eyeRays(evidence.camera, evidence.size());
    return predictAll(evidence, [&](const Sample& sample) {
        const trace::SurfacePoint point = evidence.tracer.eyePoint(rays, view.source(evidence, dvec2(sample.pixel) + 0.5));
        return predictedBy(evidence, sample, point ? evidence.tracer.visibility(point, evidence.light) : Visibility::noSurface);
    });
}

/// A cause is worth rays only if what is looked up explains this share.
constexpr double kWorthRays = 0.25;

/// Two kinds of evidence count for more than one.
constexpr double kSeenInShading = 1.3;

void addOfPicture(const Evidence& evidence, Cause cause, std::vector<Cause>& causes) {
    cause.isOfPicture = true;
    addIfExplains(evidence, std::move(cause), causes);
}

void addFlips(const Evidence& evidence, std::vector<Cause>& causes) {
    for (const Orientation& orientation :
         {Orientation{false, true, false}, Orientation{false, false, true}, Orientation{false, true, true}}) {
        // Where the shading of a reference says how it lies, shadows are not asked.
        if (evidence.reference && *evidence.reference != orientation) continue;
        Cause cause{"flipped", "", orientationFault(orientation).remedy, {}};
        if (evidence.reference) cause.likelihood = kSeenInShading;
        const OtherView view{{orientation.mirrorsX ? -1 : 1, orientation.mirrorsY ? -1 : 1}, {}};
        cause.predictions = traced(evidence, view);
        cause.what = "the picture is " + toText(orientation) + ": put upright, it agrees with the truth in " +
                     percentText(explained(evidence, cause.predictions)) + " of the pixels that are wrong now";
        if (evidence.reference) cause.what += ", and the shading of the reference lies so, too";
        addOfPicture(evidence, std::move(cause), causes);
    }
}

void addShift(const Evidence& evidence, std::vector<Cause>& causes) {
    constexpr int kMostPx = 8;
    const Evidence some = thinned(evidence);
    OtherView best;
    double most = 0;
    for (int y = -kMostPx; y <= kMostPx; ++y)
        for (int x = -kMostPx; x <= kMostPx; ++x) {
            const OtherView view{dvec2(1.0), dvec2(x, y)};
            if (const double found = explained(some, lookedUp(some, view)); found > most) most = found, best = view;
        }
    if (glm::length(best.shiftPx) > 1.5 && most < kWorthRays) return;
    const auto costOf = [&](const std::vector<double>& shift) { return -explained(some, traced(some, {dvec2(1.0), {shift[0], shift[1]}})); };
    // Half a pixel to each side is where the usual mistakes lie, and a saddle between two whole ones.
    std::vector<double> start{best.shiftPx.x, best.shiftPx.y};
    for (const dvec2 half : {dvec2(0.5, 0.5), dvec2(-0.5, -0.5), dvec2(0.5, 0), dvec2(0, 0.5), dvec2(-0.5, 0), dvec2(0, -0.5), dvec2(0.5, -0.5), dvec2(-0.5, 0.5)})
        if (costOf({half.x, half.y}) < costOf(start)) start = {half.x, half.y};
    constexpr double kLeastStepPx = 0.03;
    const std::vector<double> shift = patternSearch(start, 0.25, kLeastStepPx, costOf);
    best.shiftPx = {shift[0], shift[1]};
    if (glm::length(best.shiftPx) < 0.1) return; // no less is measured: it is none
    Cause cause{"shift", "", shiftRemedy(best.shiftPx), traced(evidence, best)};
    cause.what = "the picture is shifted by " + shiftText(best.shiftPx) + ": so moved, rays of the scene explain " +
                 percentText(explained(evidence, cause.predictions)) + " of the wrong pixels";
    addOfPicture(evidence, std::move(cause), causes);
}

void addScale(const Evidence& evidence, std::vector<Cause>& causes) {
    constexpr int kSteps = 24; // to an octave
    const Evidence some = thinned(evidence);
    OtherView best;
    double most = 0;
    for (int y = -kSteps; y <= kSteps; ++y)
        for (int x = -kSteps; x <= kSteps; ++x) {
            if (x == 0 && y == 0) continue;
            const OtherView view{glm::exp2(dvec2(x, y) / static_cast<double>(kSteps)), dvec2(0.0)};
            if (const double found = explained(some, lookedUp(some, view)); found > most) most = found, best = view;
        }
    const auto costOf = [&](const std::vector<double>& scale) { return -explained(some, traced(some, {{scale[0], scale[1]}, dvec2(0.0)})); };
    // A step that is too long or too short by one pixel over the whole picture is the likeliest of small ones.
    for (const double pixels : {-1.0, 1.0}) {
        const dvec2 scale = 1.0 + pixels / dvec2(evidence.size());
        if (const double found = -costOf({scale.x, scale.y}); found > most) most = found, best = {scale, dvec2(0.0)};
    }
    if (most < kWorthRays) return;
    const std::vector<double> scale = patternSearch({best.scale.x, best.scale.y}, 0.02, 0.0005, costOf);
    best.scale = {scale[0], scale[1]};
    Calibration seen;
    seen.scale = best.scale;
    seen.shiftPx = dvec2(0.0);
    const auto fault = viewFault(seen, evidence.camera, evidence.size());
    if (!fault) return;
    Cause cause{"view", "", fault->remedy, traced(evidence, best)};
    cause.what = "the picture " + fault->what + ": seen so, rays of the scene explain " +
                 percentText(explained(evidence, cause.predictions)) + " of the wrong pixels";
    addOfPicture(evidence, std::move(cause), causes);
}

void addOtherLights(const Evidence& evidence, std::vector<Cause>& causes) {
    const scene::Scene& scene = evidence.tracer.scene();
    for (int other = 0; other < static_cast<int>(scene.lights.size()); ++other) {
        if (other == evidence.light) continue;
        const std::string name = "'" + scene.light(other).name + "'";
        const auto seenBy = [&](const Sample& sample, int light) { return evidence.tracer.visibility(sample.point, light) == Visibility::lit; };
        Cause instead{"other-light", "", "judge it with --light " + scene.light(other).name, {}};
        instead.predictions = predictAll(evidence, [&](const Sample& sample) { return predicted(seenBy(sample, other)); });
        instead.what = "these are the shadows of the light " + name + ": they explain " + percentText(explained(evidence, instead.predictions)) +
                       " of the wrong pixels";
        addOfPicture(evidence, std::move(instead), causes);
        Cause both{"shadows-of-other-lights", "", "draw the picture and its reference with the same shadows of all other lights", {}};
        both.predictions = predictAll(evidence, [&](const Sample& sample) {
            return predicted(sample.shouldBeLit && evidence.tracer.visibility(sample.point, other) != Visibility::shadowed);
        });
        both.what = "the picture has the shadows of the light " + name + ", too: they explain " +
                    percentText(explained(evidence, both.predictions)) + " of the wrong pixels";
        addOfPicture(evidence, std::move(both), causes);
    }
}

} // namespace

void addPictureCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    addFlips(evidence, causes);
    addShift(evidence, causes);
    addScale(evidence, causes);
    addOtherLights(evidence, causes);
}

} // namespace shadowlab::foreign
