// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/cascades.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::shadow_map {

namespace {

/// Half the picture's width and height at distance 1.
dvec2 tangents(const FitEye& eye) {
    const double tangent = std::tan(eye.camera.fovYDegrees * glm::pi<double>() / 360.0);
    return {tangent * eye.aspect, tangent};
}

/// Metres along the eye's axis to the nearest and the farthest corner of the boxes.
dvec2 depthsOf(std::span<const scene::Bounds> boxes, const dmat4& viewFromWorld) {
    dvec2 range(1e300, 0);
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i) {
            const double depth = -transformPoint(viewFromWorld, box.corner(i)).z;
            range = dvec2(std::min(range.x, depth), std::max(range.y, depth));
        }
    return range;
}

/// The same of a part of the light's view.
dvec2 depthsOf(const Box& region, const LightMaps& maps, const dmat4& lightView, const dmat4& viewFromWorld) {
    const dmat4 lightRelativeFromLightView = glm::inverse(lightView);
    dvec2 range(1e300, 0);
    for (int i = 0; i < 8; ++i) {
        const dvec3 cornerWorld = maps.originWorld + transformPoint(lightRelativeFromLightView, region.corner(i));
        const double depth = -transformPoint(viewFromWorld, cornerWorld).z;
        range = dvec2(std::min(range.x, depth), std::max(range.y, depth));
    }
    return range;
}

/// The range of distances that the cascades share out: at most where a shadow can fall.
dvec2 depthBounds(const FitRequest& request, const Box& region, const LightMaps& maps, const dmat4& lightView) {
    using enum ProjectionParams::DepthBounds;
    const dmat4 viewFromWorld = scene::viewFromWorld(request.eye.camera);
    const dvec2 all = depthsOf(request.all, viewFromWorld);
    dvec2 bounds(request.eye.camera.near, all.y);
    const auto narrowTo = [&](const dvec2& other) {
        bounds = dvec2(std::max(bounds.x, other.x), std::min(bounds.y, other.y));
    };
    if (request.params.depthBounds != camera) {
        if (!request.receivers.empty()) narrowTo(depthsOf(request.receivers, viewFromWorld));
        narrowTo(depthsOf(region, maps, lightView, viewFromWorld));
    }
    if (request.params.depthBounds == picture && request.eye.visibleDepth) narrowTo(*request.eye.visibleDepth);
    bounds.y = std::max(bounds.y, 1.001 * bounds.x);
    if (!request.params.stable) return bounds;
    // In quarters of a power of two of the scene's own size: as long as the eye moves little the slices stay what they are,
    // and with them the size of their texels.
    scene::Bounds whole;
    for (const scene::Bounds& box : request.all)
        whole.include(box);
    const double unit = std::max(glm::length(whole.upperWorld - whole.lowerWorld), 1e-30);
    const auto quarters = [unit](double value) { return 4 * std::log2(value / unit); };
    const auto metres = [unit](double value) { return unit * std::exp2(value / 4); };
    return {metres(std::floor(quarters(bounds.x))), metres(std::ceil(quarters(bounds.y)))};
}

/// The slice of the view between two distances, as the light sees its corners.
Box boxAroundSlice(const FitRequest& request, double nearest, double farthest, const LightMaps& maps,
                   const dmat4& lightView) {
    Box box;
    for (const double depth : {nearest, farthest})
        for (const dvec3& corner : scene::viewCorners(request.eye.camera, request.eye.aspect, depth))
            box.include(transformPoint(lightView, corner - maps.originWorld));
    return box;
}

/// The same for the ball around the slice, its middle moved to a whole number of texels of this map.
Box boxAroundBall(const FitRequest& request, double nearest, double farthest, const LightMaps& maps,
                  const dmat4& lightView) {
    const SliceBall ball = ballAround(request.eye, nearest, farthest);
    const dvec3 middleWorld =
        transformPoint(glm::inverse(scene::viewFromWorld(request.eye.camera)), dvec3(0, 0, -ball.distance));
    const dvec3 middle = transformPoint(lightView, middleWorld - maps.originWorld);
    // The map will be larger than the ball by the guard band on both sides, and is a texel larger for the moving.
    const double share = guardShare(request.resolution, request.guardTexels);
    const double side = 2 * ball.radius * (1 + 1.0 / request.resolution);
    const double texel = side * (1 + 2 * share) / request.resolution;
    const dvec2 moved = glm::floor(dvec2(middle) / texel + 0.5) * texel;
    return {dvec3(moved - 0.5 * side, middle.z - ball.radius), dvec3(moved + 0.5 * side, middle.z + ball.radius)};
}

bool isBoxWithin(const Box& inner, const Box& outer) {
    const dvec2 innerExtent(inner.upper - inner.lower), outerExtent(outer.upper - outer.lower);
    return std::max(innerExtent.x, innerExtent.y) <= std::max(outerExtent.x, outerExtent.y);
}

} // namespace

std::vector<double> splitDistances(double nearest, double farthest, int count, double mix) {
    std::vector<double> ends;
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        ends.push_back(mix * nearest * std::pow(farthest / nearest, share) +
                       (1 - mix) * (nearest + share * (farthest - nearest)));
    }
    return ends;
}

SliceBall ballAround(const FitEye& eye, double nearest, double farthest) {
    // As far from the slice's near corners as from its far ones, unless those of the far rectangle alone need more.
    const double corner = glm::dot(tangents(eye), tangents(eye)); // squared, at distance 1
    const double distance = std::min(farthest, 0.5 * (nearest + farthest) * (1 + corner));
    return {distance, std::sqrt((farthest - distance) * (farthest - distance) + corner * farthest * farthest)};
}

std::vector<Box> cascadeParts(const FitRequest& request, const Box& region, const dmat4& lightViewFromLightRelative,
                              LightMaps& maps) {
    const ProjectionParams& params = request.params;
    const dvec2 bounds = depthBounds(request, region, maps, lightViewFromLightRelative);
    maps.layout = Layout::cascades;
    maps.cascadeEnds = splitDistances(bounds.x, bounds.y, params.cascades, params.splitMix);
    std::vector<Box> parts;
    double start = bounds.x, overlap = 0;
    for (const double end : maps.cascadeEnds) {
        // It begins where the one before begins to fade.
        const double from = std::max(start - overlap, 0.5 * start);
        overlap = params.cascadeBlend * (end - start);
        maps.fadeStarts.push_back(end - overlap);
        Box part;
        if (params.stable) {
            part = boxAroundBall(request, from, end, maps, lightViewFromLightRelative);
            if (isBoxWithin(region, part)) part = region; // all that matters fits into less
        } else {
            part = boxAroundSlice(request, from, end, maps, lightViewFromLightRelative);
            const Box shared{glm::max(part.lower, region.lower), glm::min(part.upper, region.upper)};
            const bool any = shared.lower.x <= shared.upper.x && shared.lower.y <= shared.upper.y;
            part = any ? shared : Box{region.lower, region.lower}; // no caster's shadow falls here
        }
        part.lower.z = region.lower.z;
        part.upper.z = region.upper.z;
        parts.push_back(part);
        start = end;
    }
    maps.fadeStarts.back() = bounds.y; // nothing comes after the last
    return parts;
}

} // namespace shadowlab::shadow_map
