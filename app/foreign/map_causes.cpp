// A shadow map that covers a part of the scene only: outside of it all is lit, or all is dark.
//
// A map is a rectangle across the light's view. How it is turned about the view's axis is not known, so some turns are tried; of each, the
// rectangle is the least one that holds all that is right.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"
#include "techniques/foundation/math/perpendicular.h"

namespace shadowlab::foreign {

namespace {

struct MapView {
    dvec3 forward{0.0}, right{0.0}, up{0.0};
};

/// Where the sample lies across the light's view: metres of a directional light, else tangents. Behind the view's plane: infinitely far.
dvec2 placeAcross(const Evidence& evidence, const Sample& sample, const MapView& view) {
    const scene::Light& source = evidence.source();
    const bool directional = source.type == scene::LightType::directional;
    const dvec3 from = evidence.tracer.positionWorld(sample.point) - (directional ? evidence.camera.targetWorld : source.positionWorld);
    const double depth = directional ? 1 : glm::dot(from, view.forward);
    if (depth <= 0) return dvec2(HUGE_VAL);
    return dvec2(glm::dot(from, view.right), glm::dot(from, view.up)) / depth;
}

/// What a map of that view predicts, which holds as much as it must so that the samples `kept` lie in it; outside all are `isLit`.
Predictions outsideMap(const Evidence& evidence, const MapView& view, bool isLit) {
    std::vector<dvec2> places;
    std::array<std::vector<double>, 2> kept;
    for (const Sample& sample : evidence.samples) {
        const bool faces = evidence.tracer.facesLight(sample.point, evidence.light);
        places.push_back(faces ? placeAcross(evidence, sample, view) : dvec2(0.0));
        if (!faces || sample.isWrong() || sample.shouldBeLit == isLit || !std::isfinite(places.back().x)) continue;
        kept[0].push_back(places.back().x), kept[1].push_back(places.back().y);
    }
    Predictions predictions(places.size(), Prediction::none);
    constexpr std::size_t kEnough = 20; // of right samples inside
    if (kept[0].size() < kEnough) return predictions;
    constexpr double kStray = 0.002; // of them: on the rectangle's edge
    dvec2 least, most;
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<double>& values = kept[static_cast<std::size_t>(axis)];
        std::ranges::sort(values);
        const std::size_t strays = static_cast<std::size_t>(kStray * static_cast<double>(values.size()));
        least[axis] = values[strays], most[axis] = values[values.size() - 1 - strays];
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Sample& sample = evidence.samples[i];
        if (!evidence.tracer.facesLight(sample.point, evidence.light)) continue;
        const bool inside = places[i].x >= least.x && places[i].x <= most.x && places[i].y >= least.y && places[i].y <= most.y;
        if (!inside) predictions[i] = predicted(isLit);
    }
    return predictions;
}

} // namespace

void addMapCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const scene::Light& source = evidence.source();
    const dvec3 forward = source.type == scene::LightType::point ? glm::normalize(evidence.camera.targetWorld - source.positionWorld) : source.directionWorld;
    constexpr double kUpright = 0.99; // looking straight down, there is no upright
    const dvec3 first = std::abs(forward.y) < kUpright ? glm::normalize(glm::cross(forward, dvec3(0, 1, 0))) : perpendicularTo(forward), second = glm::cross(first, forward);
    for (const bool isLit : {false, true}) {
        Cause best{"outside-map", "", "let the map cover all that casts and receives shadows in the picture, or treat what lies outside as lit", {}};
        double most = 0;
        constexpr int kTurns = 18; // of a quarter
        for (int turn = 0; turn < kTurns; ++turn) {
            const double angle = glm::radians(90.0 * turn / kTurns);
            const MapView view{forward, std::cos(angle) * first + std::sin(angle) * second, std::cos(angle) * second - std::sin(angle) * first};
            Predictions tried = outsideMap(evidence, view, isLit);
            if (const double found = explained(evidence, tried); found > most) most = found, best.predictions = std::move(tried);
        }
        if (most <= 0) continue;
        best.likelihood = 0.9; // rarer than a bias, and a rectangle holds much by chance
        best.what = "the shadow map covers a part only: " + percentText(most) + " of the wrong pixels lie outside of a rectangle across the light's view, where all is " + (isLit ? "lit" : "dark");
        addIfExplains(evidence, std::move(best), causes);
    }
}

} // namespace shadowlab::foreign
