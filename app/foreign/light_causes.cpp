// Mistakes of the light's place, and of distances along its rays.
//
// A light in the wrong place moves each boundary by its own amount: the further the receiver is behind its caster, the more. So rays
// to a light that is moved predict every pixel, and the place that agrees best is found by search.
// A depth bias d lets a point be lit whose casters all lie within d of it; a near plane those that lie within d of the light; a range
// what lies beyond it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/foreign/causes.h"
#include "app/foreign/rays_of_causes.h"
#include "app/picture/verdict_reasons.h"
#include "techniques/foundation/math/perpendicular.h"

namespace shadowlab::foreign {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::string shareText(double share) { return picture::fixed(100 * share, 0) + " %"; }

std::string metresText(double metres) {
    return metres < 0.1 ? picture::fixed(100 * metres, metres < 0.01 ? 2 : 1) + " cm" : picture::fixed(metres, 2) + " m";
}

Predictions withLight(const Evidence& evidence, const scene::Light& moved, std::span<const std::uint8_t> casts) {
    return predictAll(evidence, [&](const Sample& sample) {
        if (!sample.point || !evidence.tracer.facesLight(sample.point, evidence.light)) return Prediction::none;
        if (!evidence.tracer.objectOf(sample.point).receivesShadow) return Prediction::lit;
        return predicted(!isBlockedBy(evidence.tracer, rayToLight(evidence.tracer, sample.point, moved), sample.point.primitive, casts));
    });
}

void addMovedLight(const Evidence& evidence, std::vector<Cause>& causes) {
    const scene::Light& source = evidence.source();
    const bool directional = source.type == scene::LightType::directional;
    const std::vector<std::uint8_t> casts = castingTriangles(evidence);
    const double distance = glm::length(source.positionWorld - evidence.camera.targetWorld);
    const dvec3 aside = perpendicularTo(source.directionWorld), across = glm::cross(source.directionWorld, aside);
    // Metres, or of a direction radians about two axes.
    const auto movedBy = [&](const std::vector<double>& by) {
        scene::Light moved = source;
        if (directional)
            moved.directionWorld = glm::normalize(source.directionWorld + by[0] * aside + by[1] * across);
        else
            moved.positionWorld += dvec3(by[0], by[1], by[2]);
        return moved;
    };
    const Evidence some = thinned(evidence);
    const auto costOf = [&](const std::vector<double>& by) { return -explained(some, withLight(some, movedBy(by), casts)); };
    // From a sixteenth of the distance, by which shadows move visibly, to what moves them by less than a hundredth of a pixel.
    const double unit = directional ? 1.0 : std::max(distance, 1e-6);
    const std::vector<double> by = patternSearch(std::vector<double>(directional ? 2 : 3, 0.0), unit / 16, unit / 8192, costOf);
    Cause cause{"light-displaced", "", "", withLight(evidence, movedBy(by), casts)};
    const double found = explained(evidence, cause.predictions);
    // A light far away from its place explains much by chance, and one behind a wall makes all dark.
    constexpr double kPlausible = 0.1; // of the distance
    cause.likelihood = std::hypot(by[0], by[1], by.back()) < kPlausible * unit ? 0.98 : 0.75;
    if (std::ranges::none_of(cause.predictions, [](Prediction one) { return one == Prediction::lit; })) return;
    if (directional) {
        const double degrees = glm::degrees(std::hypot(by[0], by[1]));
        const dvec3 way = movedBy(by).directionWorld;
        cause.what = "the light comes from the wrong direction: turned by " + picture::fixed(degrees, 2) + " degrees, to (" + picture::fixed(way.x, 3) + ", " +
                     picture::fixed(way.y, 3) + ", " + picture::fixed(way.z, 3) + "), it explains " + shareText(found) +
                     " of the wrong pixels, boundaries far from their casters moved most";
        cause.remedy = "check the light's direction and its normalisation";
    } else {
        const dvec3 offset(by[0], by[1], by[2]);
        cause.what = "the light stands in the wrong place: " + metresText(glm::length(offset)) + " away, moved by (" + picture::fixed(offset.x, 3) + ", " +
                     picture::fixed(offset.y, 3) + ", " + picture::fixed(offset.z, 3) + ") m, it explains " + shareText(found) +
                     " of the wrong pixels, boundaries far from their casters moved most";
        cause.remedy = "check the light's position, its units, and in which space it is given";
    }
    addIfExplains(evidence, std::move(cause), causes);
}

/// What stands in the light's way, in metres from the point and from the light.
struct Obstacles {
    double farthestFromPoint = kNever; ///< of the obstacle nearest to the light; none: nothing stands there
    double nearestToPoint = kNever;    ///< from the point
    bool ofOthers = false;             ///< does any belong to another object than the point's?
    double nearestToLight = kNever;    ///< from the light, of the obstacle nearest to the point
};

std::vector<Obstacles> obstaclesOf(const Evidence& evidence) {
    const std::vector<std::uint8_t> casts = castingTriangles(evidence);
    std::vector<Obstacles> all(evidence.samples.size());
    predictAll(evidence, [&](const Sample& sample) {
        Obstacles& own = all[static_cast<std::size_t>(&sample - evidence.samples.data())];
        if (!sample.point || !evidence.tracer.facesLight(sample.point, evidence.light)) return Prediction::none;
        const trace::Ray ray = rayToLight(evidence.tracer, sample.point, evidence.source());
        const std::vector<Crossing> met = crossings(evidence.tracer, ray, sample.point.primitive, casts);
        if (met.empty()) return Prediction::none;
        const double metres = metresPerT(ray, evidence.source());
        own.farthestFromPoint = met.back().t * metres;
        const std::vector<std::uint32_t>& objects = evidence.tracer.world().objects;
        own.ofOthers = std::ranges::any_of(met, [&](const Crossing& one) { return objects[one.primitive] != objects[sample.point.primitive]; });
        own.nearestToPoint = met.front().t * metres;
        if (std::isfinite(ray.farthest)) own.nearestToLight = (1 - met.front().t) * metres;
        return Prediction::none;
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
                         : std::string("the shadow is detached from its caster (peter-panning): ")) +
                 shareText(best.explained) + " of the wrong pixels are lit because everything that shades them lies within " + metresText(best.value) +
                 " of them; beyond, shadows are there";
    cause.remedy = "the depth bias, or the offset at which shadow rays start, is about " + metresText(best.value) + "; make it smaller, or let it follow slope and texel";
    addIfExplains(evidence, std::move(cause), causes);
}

void addRange(const Evidence& evidence, const std::vector<Obstacles>& obstacles, std::vector<Cause>& causes) {
    std::vector<double> nearLight, fromLight, fromEye, fromCaster;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const Sample& sample = evidence.samples[i];
        nearLight.push_back(obstacles[i].nearestToLight);
        fromCaster.push_back(std::isfinite(obstacles[i].nearestToPoint) ? -obstacles[i].nearestToPoint : kNever);
        const bool shaded = sample.point && std::isfinite(obstacles[i].farthestFromPoint);
        const dvec3 positionWorld = shaded ? evidence.tracer.positionWorld(sample.point) : dvec3(0.0);
        // Negative: the farthest are lit first.
        const bool directional = evidence.source().type == scene::LightType::directional;
        fromLight.push_back(shaded && !directional ? -glm::length(positionWorld - evidence.source().positionWorld) : kNever);
        fromEye.push_back(shaded ? -glm::length(positionWorld - evidence.camera.positionWorld) : kNever);
    }
    const auto add = [&](const std::vector<double>& values, const char* id, const char* before, const char* after, const char* remedy) {
        Threshold best = bestThreshold(evidence, values);
        if (best.explained < kLeastExplained) return;
        const bool all = std::ranges::none_of(values, [&](double value) { return std::isfinite(value) && value > best.value; });
        if (all) return;
        Cause cause{id, "", remedy, std::move(best.predictions)};
        cause.what = std::string(before) + metresText(std::abs(best.value)) + after + ": this explains " + shareText(best.explained) + " of the wrong pixels";
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
    cause.what = "objects cast no shadow on themselves: this explains " + shareText(explained(evidence, cause.predictions)) + " of the wrong pixels";
    addIfExplains(evidence, std::move(cause), causes);
}

} // namespace

void addLightCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    addMovedLight(evidence, causes);
    const std::vector<Obstacles> obstacles = obstaclesOf(evidence);
    addBias(evidence, obstacles, causes);
    addRange(evidence, obstacles, causes);
    addSelfShadows(evidence, obstacles, causes);
}

} // namespace shadowlab::foreign
