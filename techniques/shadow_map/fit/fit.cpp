// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/fit.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/shadow_map/fit/cascades.h"
#include "techniques/shadow_map/fit/light_space_perspective.h"
#include "techniques/shadow_map/fit/shared_region.h"

namespace shadowlab::shadow_map {

namespace {

// A cone wider than this is better served by six maps than by one whose texels grow with 1/cos^2 of the angle.
constexpr double kWidestSingleConeDegrees = 120.0;

// Near over far. With 24 bits of depth the last step is then far / (0.001 * 2^24) = 6e-5 far: a fraction of a texel.
// Casters nearer than that are kept by the depth clamp.
constexpr double kLeastNearShare = 1e-3;

// What a program takes that never looks at its scene (depth-range=wide), in metres.
constexpr double kWideNear = 0.01, kWideFar = 1000;

/// Nearest point of the box to the origin of light-relative space, and its farthest corner, as distances.
dvec2 distanceRange(std::span<const scene::Bounds> boxes, const dvec3& originWorld) {
    dvec2 range(1e300, 0);
    for (const scene::Bounds& box : boxes) {
        range.x = std::min(range.x, glm::length(glm::clamp(originWorld, box.lowerWorld, box.upperWorld) - originWorld));
        for (int i = 0; i < 8; ++i)
            range.y = std::max(range.y, glm::length(box.corner(i) - originWorld));
    }
    return range;
}

/// The same for a penumbra: of a map that is for `side`, sideways, when a kernel may reach `reach` beyond the point.
double penumbraShare(const FitRequest& request, double side, double reach) {
    const double ofMap = std::min(reach / (side + 2 * reach), request.widestShare);
    return std::max(guardShare(request.resolution, request.guardTexels), ofMap / (1 - 2 * ofMap));
}

LightMaps fitParallel(const FitRequest& request) {
    const ProjectionParams& params = request.params;
    LightMaps maps;
    maps.parallel = true;
    maps.towardLight = -request.light.directionWorld;
    scene::Bounds whole;
    for (const scene::Bounds& box : request.all)
        whole.include(box);
    maps.originWorld = whole.isEmpty() ? dvec3(0.0) : 0.5 * (whole.lowerWorld + whole.upperWorld);
    const bool warped = params.warp == ProjectionParams::Warp::lispsm;
    const dmat4 lightView = warped ? lookAlongForWarp(request.light.directionWorld, request.eye.camera)
                                   : lookAlong(request.light.directionWorld);
    const Box casters = boxInView(request.casters, maps.originWorld, lightView);
    const std::span<const scene::Bounds> receivers = request.receivers.empty() ? request.all : request.receivers;
    Box region = request.cover == FitRequest::Cover::shown
                     ? around(casters, boxInView(receivers, maps.originWorld, lightView))
                     : sharedRegion(casters, receivers, maps.originWorld, lightView);
    if (region.isEmpty()) return maps;
    if (request.castersInDepth) region.upper.z = std::max(region.upper.z, casters.upper.z);
    const std::vector<Box> parts =
        params.cascades > 1 ? cascadeParts(request, region, lightView, maps) : std::vector{region};
    for (Box part : parts) {
        if (params.depthRange == ProjectionParams::DepthRange::wide) {
            part.upper.z = std::max(part.upper.z, 0.5 * kWideFar);
            part.lower.z = std::min(part.lower.z, -0.5 * kWideFar);
        }
        // A little around it; never empty, even for a caster seen edge-on. Square texels: the longer side decides for both.
        const dvec3 extent = part.upper - part.lower;
        const double largest = std::max({extent.x, extent.y, extent.z, 1e-6});
        const double side = std::max({extent.x, extent.y, 1e-3 * largest});
        const double share = penumbraShare(request, side, request.lightReach * extent.z);
        dvec3 margin(0.5 * (side - extent.x) + share * side, 0.5 * (side - extent.y) + share * side, 1e-3 * largest);
        if (warped) margin = dvec3(1e-6 * largest, 1e-6 * largest, 1e-3 * largest);
        part.lower -= margin;
        part.upper += margin;
        maps.lightViewFromLightRelative.push_back(lightView);
        maps.lightClipFromLightView.push_back(warped ? warpedProjection(part, request.light, request.eye, share)
                                                     : parallelProjection(part));
        maps.nearest = -part.upper.z;
        maps.farthest = -part.lower.z;
    }
    return maps;
}

/// A part of the light's picture, as tangents.
struct Cone {
    dvec2 lower{-1e300}, upper{1e300};
    [[nodiscard]] bool isEmpty() const { return !glm::all(glm::lessThanEqual(lower, upper)); }
    [[nodiscard]] double widest() const { return std::max({-lower.x, -lower.y, upper.x, upper.y}); }
    [[nodiscard]] Cone sharedWith(const Cone& other) const {
        return {glm::max(lower, other.lower), glm::min(upper, other.upper)};
    }
    [[nodiscard]] Cone around(const Cone& other) const {
        return {glm::min(lower, other.lower), glm::max(upper, other.upper)};
    }
};

/// The least distance of the boxes along the camera's axis; negative where one reaches behind it.
double axialDistance(std::span<const scene::Bounds> boxes, const dvec3& originWorld, const dmat4& lightView) {
    double least = 1e300;
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i)
            least = std::min(least, -transformPoint(lightView, box.corner(i) - originWorld).z);
    return least;
}

/// Where the boxes lie in the light's picture; without bounds where one is beside the light or behind it.
Cone coneOf(std::span<const scene::Bounds> boxes, const dvec3& originWorld, const dmat4& lightView) {
    Cone cone{dvec2(1e300), dvec2(-1e300)};
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i) {
            const dvec3 p = transformPoint(lightView, box.corner(i) - originWorld);
            if (p.z >= 0) return {};
            cone.lower = glm::min(cone.lower, dvec2(p) / -p.z);
            cone.upper = glm::max(cone.upper, dvec2(p) / -p.z);
        }
    return cone;
}

/// Looks at the middle of the boxes, if all lie to one side and not too wide for one map.
std::optional<dmat4> aimAt(std::span<const scene::Bounds> boxes, const dvec3& originWorld) {
    scene::Bounds together;
    for (const scene::Bounds& box : boxes)
        together.include(box);
    const dvec3 middle = 0.5 * (together.lowerWorld + together.upperWorld) - originWorld;
    if (!(glm::length(middle) > 0)) return std::nullopt;
    const dmat4 lightView = lookAlong(glm::normalize(middle));
    const double widest = std::tan(kWidestSingleConeDegrees * glm::pi<double>() / 360.0);
    return coneOf(boxes, originWorld, lightView).widest() <= widest ? std::optional(lightView) : std::nullopt;
}

/// The narrower of what both share and, for the shown map, of both together.
Cone coneFor(const FitRequest& request, std::span<const scene::Bounds> receivers, const dmat4& lightView) {
    const dvec3& origin = request.light.positionWorld;
    const Cone casters = coneOf(request.casters, origin, lightView), seen = coneOf(receivers, origin, lightView);
    if (request.cover == FitRequest::Cover::needed) return casters.sharedWith(seen);
    const Cone both = casters.around(seen);
    return both.widest() < 4 ? both : casters; // what lies far aside, or behind, is not worth a picture
}

LightMaps fitPerspective(const FitRequest& request) {
    LightMaps maps;
    maps.originWorld = request.light.positionWorld;
    const std::span<const scene::Bounds> receivers = request.receivers.empty() ? request.all : request.receivers;
    const dvec2 distances = distanceRange(receivers, maps.originWorld);
    // The distance along one of the six axes is at least 1/sqrt(3) of the distance itself; in a single wide picture, half.
    // Rounded to the casters' own distance times a power of two in eighths, so that it seldom changes.
    const double unit = std::max(distanceRange(request.casters, maps.originWorld).y, 1e-30);
    const auto rounded = [unit](double value, auto round) {
        return unit * std::exp2(round(8 * std::log2(value / unit)) / 8);
    };
    maps.farthest = rounded(std::max(1.001 * distances.y, 1e-6 * unit), [](double v) { return std::ceil(v); });
    // What is nearer to the light than all casters is lit: before the near plane, too.
    const double distance = request.castersInDepth ? distanceRange(request.casters, maps.originWorld).x : distances.x;
    const double nearest = 0.49 * distance;
    maps.nearest = std::max(nearest > 0 ? rounded(nearest, [](double v) { return std::floor(v); }) : 0.0,
                            kLeastNearShare * maps.farthest);
    if (request.params.depthRange == ProjectionParams::DepthRange::wide) {
        maps.nearest = kWideNear;
        maps.farthest = std::max(maps.farthest, kWideFar);
    }

    const auto add = [&](const dmat4& lightView, Cone cone) {
        const dvec2 extent = cone.upper - cone.lower;
        const double side = std::max({extent.x, extent.y, 1e-6});
        // A point at the far end, and what blocks the light at the near one: as tangents, that the map counts in.
        const double reach = request.lightReach * (1 / maps.nearest - 1 / maps.farthest);
        const bool isBare =
            maps.layout == Layout::cube && request.params.cubeSeams == ProjectionParams::CubeSeams::bare;
        const double share = isBare ? 0 : penumbraShare(request, side, reach);
        const dvec2 margin = 0.5 * (side - extent) + share * side;
        maps.lightViewFromLightRelative.push_back(lightView);
        maps.lightClipFromLightView.push_back(
            perspectiveProjection(cone.lower - margin, cone.upper + margin, maps.nearest, maps.farthest));
    };
    const scene::Light& light = request.light;
    std::optional<dmat4> aim;
    Cone within;
    if (light.type == scene::LightType::spot && light.coneDegrees <= kWidestSingleConeDegrees) {
        aim = lookAlong(light.directionWorld);
        const double tangent = std::tan(light.coneDegrees * glm::pi<double>() / 360.0);
        within = {dvec2(-tangent), dvec2(tangent)};
    } else {
        aim = aimAt(request.casters, maps.originWorld);
        if (!aim && request.cover == FitRequest::Cover::needed) aim = aimAt(receivers, maps.originWorld);
    }
    if (aim) {
        Cone cone = coneFor(request, receivers, *aim);
        if (request.cover == FitRequest::Cover::needed && !cone.isEmpty()) {
            const dvec2 extent = cone.upper - cone.lower;
            const double step = std::exp2(std::ceil(std::log2(std::max({extent.x, extent.y, 1e-9})))) / kRegionSteps;
            const Cone rounded{glm::floor(cone.lower / step) * step, glm::ceil(cone.upper / step) * step};
            cone = coneOf(request.casters, maps.originWorld, *aim).sharedWith(rounded);
        }
        cone = cone.sharedWith(within);
        if (request.castersInDepth) {
            // How far a filter searches for what blocks the light depends on how near that may be: no nearer than it is.
            const double least = axialDistance(request.casters, maps.originWorld, *aim);
            if (least > maps.nearest) maps.nearest = rounded(least, [](double v) { return std::floor(v); });
        }
        if (!cone.isEmpty()) add(*aim, cone);
        return maps;
    }
    maps.layout = Layout::cube;
    for (const dvec3& axis :
         {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)})
        add(lookAlong(axis), {dvec2(-1), dvec2(1)});
    return maps;
}

} // namespace

double guardShare(int resolution, int guardTexels) {
    // Half a texel more than the guard band, against rounding.
    return (guardTexels + 0.5) / std::max(1, resolution - 2 * guardTexels - 1);
}

LightMaps fitLightMaps(const FitRequest& request) {
    if (request.casters.empty() && request.cover == FitRequest::Cover::needed) {
        LightMaps none;
        none.parallel = request.light.type == scene::LightType::directional;
        return none;
    }
    return request.light.type == scene::LightType::directional ? fitParallel(request) : fitPerspective(request);
}

} // namespace shadowlab::shadow_map
