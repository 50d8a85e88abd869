// Mistakes of distances along the light's rays.
//
// A depth bias d lets a point be lit whose casters all lie within d of it; a near plane those that lie within d of the light; a range
// what lies beyond it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What stands in the light's way, in metres from the point.
struct Obstacles {
    double farthestFromPoint = kNever; ///< of the obstacle nearest to the light; none: nothing stands there
    double nearestToPoint = kNever;    ///< from the point
    bool ofOthers = false;             ///< does any belong to another object than the point's?
};

std::vector<Obstacles> obstaclesOf(const Evidence& evidence) {
    const std::vector<std::uint8_t> casts = castingTriangles(evidence);
    std::vector<Obstacles> all(evidence.samples.size());
    forSamples(evidence, [&](std::size_t i) {
        const Sample& sample = evidence.samples[i];
        if (!evidence.tracer.facesLight(sample.point, evidence.light)) return;
        const trace::Ray ray = rayToLight(evidence.tracer, sample.point, evidence.source());
        const std::vector<Crossing> met = crossings(evidence.tracer, ray, sample.point.primitive, casts);
        if (met.empty()) return;
        Obstacles& own = all[i];
        const double metres = metresPerT(ray, evidence.source());
        own.farthestFromPoint = met.back().t * metres;
        const std::vector<std::uint32_t>& objects = evidence.tracer.world().objects;
        own.ofOthers = std::ranges::any_of(met, [&](const Crossing& one) { return objects[one.primitive] != objects[sample.point.primitive]; });
        own.nearestToPoint = met.front().t * metres;
    });
    return all;
}

/// Metres that a pixel is wide on the surface that it shows.
double footprint(const Evidence& evidence, const Sample& sample) {
    const double away = glm::length(evidence.tracer.positionWorld(sample.point) - evidence.camera.positionWorld);
    return 2 * away * std::tan(glm::radians(evidence.camera.fovYDegrees) / 2) / evidence.size().y;
}

void addBias(const Evidence& evidence, const std::vector<Obstacles>& obstacles, std::vector<Cause>& causes) {
    std::vector<double> values;
    for (const Obstacles& one : obstacles)
        values.push_back(one.farthestFromPoint);
    Threshold best = bestThreshold(evidence, values);
    if (best.explained < kLeastExplained) return;
    double farthest = 0, pixels = 0, count = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]) && !evidence.samples[i].shouldBeLit) {
            farthest = std::max(farthest, values[i]);
            pixels += footprint(evidence, evidence.samples[i]);
            ++count;
        }
    if (best.value >= farthest) return; // all shadows are missing: there is no distance to be found
    const double metresPerPixel = pixels / std::max(count, 1.0);
    const bool narrow = best.value < 2.5 * metresPerPixel; // no gap that the eye sees, but a line of light
    Cause cause{narrow ? "leak-at-contact" : "peter-panning", "", "", std::move(best.predictions)};
    cause.what = (narrow ? std::string("light leaks in where caster and receiver touch: ")
                         : std::string("the shadow is detached from its caster: ")) +
                 percentText(best.explained) + " of the wrong pixels are lit because everything that shades them lies within " + metresText(best.value) +
                 " of them; beyond, shadows are there";
    cause.remedy = "the depth bias, or the offset at which shadow rays start, is about " + metresText(best.value) + "; make it smaller, or let it follow slope and texel";
    addIfExplains(evidence, std::move(cause), causes);
}

void addRange(const Evidence& evidence, const std::vector<Obstacles>& obstacles, std::vector<Cause>& causes) {
    std::vector<double> nearLight, fromLight, fromEye, fromCaster;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const Sample& sample = evidence.samples[i];
        const bool shaded = std::isfinite(obstacles[i].farthestFromPoint);
        const dvec3 positionWorld = shaded ? evidence.tracer.positionWorld(sample.point) : dvec3(0.0);
        const bool hasPlace = evidence.source().type != scene::LightType::directional;
        const double fromLightM = shaded && hasPlace ? glm::length(positionWorld - evidence.source().positionWorld) : kNever;
        nearLight.push_back(std::isfinite(fromLightM) ? fromLightM - obstacles[i].nearestToPoint : kNever);
        // Negative: the farthest are lit first.
        fromLight.push_back(std::isfinite(fromLightM) ? -fromLightM : kNever);
        fromCaster.push_back(shaded ? -obstacles[i].nearestToPoint : kNever);
        fromEye.push_back(shaded ? -glm::length(positionWorld - evidence.camera.positionWorld) : kNever);
    }
    const auto add = [&](const std::vector<double>& values, const char* id, const char* before, const char* after, const char* remedy) {
        Threshold best = bestThreshold(evidence, values);
        if (best.explained < kLeastExplained) return;
        const bool all = std::ranges::none_of(values, [&](double value) { return std::isfinite(value) && value > best.value; });
        if (all) return;
        Cause cause{id, "", remedy, std::move(best.predictions)};
        cause.what = std::string(before) + metresText(std::abs(best.value)) + after + ": this explains " + percentText(best.explained) + " of the wrong pixels";
        cause.likelihood = 0.9; // rarer than a bias
        addIfExplains(evidence, std::move(cause), causes);
    };
    add(nearLight, "near-plane-of-light", "casters within ", " of the light cast no shadow", "move the near plane of the shadow map nearer to the light");
    add(fromLight, "range-of-light", "nothing farther than ", " from the light is in shadow", "move the far plane of the shadow map, or end the volumes at infinity");
    add(fromCaster, "volumes-end", "no shadow is longer than ", " behind its caster", "extend the volumes to infinity, or at least as far as the receivers");
    add(fromEye, "range-of-view", "nothing farther than ", " from the eye is in shadow", "raise the distance up to which shadows are drawn");
}

void addSelfShadows(const Evidence& evidence, const std::vector<Obstacles>& obstacles, std::vector<Cause>& causes) {
    Cause cause{"self-shadows-missing", "", "test each surface against all casters, its own object included, and leave out nothing but the triangle itself", {}};
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const Sample& sample = evidence.samples[i];
        const bool isOwn = std::isfinite(obstacles[i].farthestFromPoint) && !obstacles[i].ofOthers;
        cause.predictions.push_back(predicted(sample.shouldBeLit || isOwn));
    }
    cause.what = "objects cast no shadow on themselves: this explains " + percentText(explained(evidence, cause.predictions)) + " of the wrong pixels";
    addIfExplains(evidence, std::move(cause), causes);
}

/// A spot whose cone is another than the scene's, or none: found as the angle that explains most.
void addCone(const Evidence& evidence, std::vector<Cause>& causes) {
    const scene::Light& source = evidence.source();
    if (source.type != scene::LightType::spot) return;
    scene::Light everywhere = source; // the same place, without a cone
    everywhere.type = scene::LightType::point;
    const Predictions withoutCone = withLight(evidence, everywhere, castingTriangles(evidence));
    std::vector<double> degrees; // from the cone's axis
    for (const Sample& sample : evidence.samples) {
        const dvec3 fromLight = evidence.tracer.positionWorld(sample.point) - source.positionWorld;
        degrees.push_back(glm::degrees(std::acos(std::clamp(glm::dot(glm::normalize(fromLight), source.directionWorld), -1.0, 1.0))));
    }
    double best = 180, most = -kNever;
    Cause cause{"cone", "", "coneDegrees is the whole angle between opposite sides of the cone: the cosine to compare with is that of its half", {}};
    constexpr double kStepDegrees = 0.5;
    for (double half = 180; half > 0; half -= half > 90 ? 90 : kStepDegrees) {
        Predictions tried = withoutCone;
        // Outside of it neither picture of a pair has the light, so they are the same there, as where there is no surface.
        for (std::size_t i = 0; i < tried.size(); ++i)
            if (degrees[i] > half) tried[i] = ofBackground(evidence, evidence.samples[i]);
        if (const double found = explained(evidence, tried); found > most) most = found, best = half, cause.predictions = std::move(tried);
    }
    cause.what = (best > 90 ? std::string("the spot shines in all directions, without its cone") : "the spot's cone is another: " + picture::fixed(2 * best, 0) + " degrees wide instead of " + picture::fixed(source.coneDegrees, 0)) +
                 ": this explains " + percentText(most) + " of the wrong pixels";
    addIfExplains(evidence, std::move(cause), causes);
}

} // namespace

void addLightCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const std::vector<Obstacles> obstacles = obstaclesOf(evidence);
    addBias(evidence, obstacles, causes);
    addRange(evidence, obstacles, causes);
    addSelfShadows(evidence, obstacles, causes);
    addCone(evidence, causes);
}

} // namespace shadowlab::foreign
