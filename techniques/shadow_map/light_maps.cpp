// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/light_maps.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::shadow_map {

namespace {

// A cone wider than this is better served by six maps than by one whose texels grow with 1/cos^2 of the angle.
constexpr double kWidestSingleConeDegrees = 120.0;

// Near over far. With 24 bits of depth the last step is then far / (0.001 * 2^24) = 6e-5 far: a fraction of a texel.
// Casters nearer than that are kept by the depth clamp.
constexpr double kLeastNearShare = 1e-3;

/// Rotation whose rows are right, up and backward for a camera that looks along `forward`.
dmat4 lookAlong(const dvec3& forward) {
    const dvec3 helper = std::abs(forward.y) > 0.99 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    const dvec3 right = glm::normalize(glm::cross(forward, helper));
    const dvec3 up = glm::cross(right, forward);
    return dmat4(glm::transpose(dmat3(right, up, -forward)));
}

dmat4 perspective(double tanHalf, double near, double far) {
    dmat4 m(0.0);
    m[0][0] = m[1][1] = 1.0 / tanHalf;
    m[2][2] = -(far + near) / (far - near);
    m[2][3] = -1.0;
    m[3][2] = -2.0 * far * near / (far - near);
    return m;
}

dmat4 parallelProjection(const dvec3& lower, const dvec3& upper) {
    dmat4 m(1.0);
    const dvec3 extent = upper - lower;
    m[0][0] = 2.0 / extent.x;
    m[1][1] = 2.0 / extent.y;
    m[2][2] = -2.0 / extent.z;
    m[3] = dvec4(-(lower.x + upper.x) / extent.x, -(lower.y + upper.y) / extent.y, (lower.z + upper.z) / extent.z, 1.0);
    return m;
}

/// Nearest point of the box to the origin of light-relative space, and its farthest corner, as distances.
std::pair<double, double> distanceRange(const scene::Bounds& box, const dvec3& originWorld) {
    const dvec3 nearest = glm::clamp(originWorld, box.lowerWorld, box.upperWorld) - originWorld;
    double farthest = 0;
    for (int i = 0; i < 8; ++i) farthest = std::max(farthest, glm::length(box.corner(i) - originWorld));
    return {glm::length(nearest), farthest};
}

/// Range of the boxes' corners in the light's view space.
scene::Bounds boundsInView(std::span<const scene::Bounds> boxes, const dvec3& originWorld, const dmat4& lightView) {
    scene::Bounds range;
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i) range.include(transformPoint(lightView, box.corner(i) - originWorld));
    return range;
}

void fitParallel(LightMaps& maps, const scene::Light& light, std::span<const scene::Bounds> casters,
                 std::span<const scene::Bounds> all, int resolution, int guardTexels) {
    const dmat4 lightView = lookAlong(light.directionWorld);
    scene::Bounds range = boundsInView(casters, maps.originWorld, lightView);
    // The guard band, and half a texel against rounding; never empty, even for a caster seen edge-on.
    const dvec3 extent = range.upperWorld - range.lowerWorld;
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-6});
    const double share = (guardTexels + 0.5) / std::max(1, resolution - 2 * guardTexels - 1);
    const dvec3 margin(std::max(share * extent.x, 1e-3 * largest), std::max(share * extent.y, 1e-3 * largest), 1e-3 * largest);
    range.lowerWorld -= margin;
    range.upperWorld += margin;
    const scene::Bounds sceneRange = boundsInView(all, maps.originWorld, lightView);
    maps.parallel = true;
    maps.nearest = -range.upperWorld.z;
    maps.farthest = -range.lowerWorld.z;
    maps.sceneNearest = -sceneRange.upperWorld.z;
    maps.sceneFarthest = -sceneRange.lowerWorld.z;
    maps.lightViewFromLightRelative = {lightView};
    maps.lightClipFromLightView = {parallelProjection(range.lowerWorld, range.upperWorld)};
}

void fitPerspective(LightMaps& maps, const scene::Light& light, std::span<const scene::Bounds> casters,
                    std::span<const scene::Bounds> all, int resolution, int guardTexels) {
    double nearest = 1e300, farthest = 0;
    for (const scene::Bounds& box : casters) {
        const auto [boxNearest, boxFarthest] = distanceRange(box, maps.originWorld);
        nearest = std::min(nearest, boxNearest);
        farthest = std::max(farthest, boxFarthest);
    }
    for (const scene::Bounds& box : all) {
        const auto [boxNearest, boxFarthest] = distanceRange(box, maps.originWorld);
        maps.sceneNearest = std::min(maps.sceneNearest, boxNearest);
        maps.sceneFarthest = std::max(maps.sceneFarthest, boxFarthest);
    }
    // Distance along an axis is at least 1/sqrt(3) of the distance itself.
    maps.farthest = std::max(1.001 * farthest, 1e-6);
    maps.nearest = std::max(0.99 * nearest / std::sqrt(3.0), kLeastNearShare * maps.farthest);

    const double guard = 1.0 + 2.0 * (guardTexels + 1) / std::max(1, resolution - 2 * guardTexels - 2);
    const bool single = light.type == scene::LightType::spot && light.coneDegrees <= kWidestSingleConeDegrees;
    const double tanHalf = single ? std::tan(light.coneDegrees * glm::pi<double>() / 360.0) : 1.0;
    const std::vector<dvec3> axes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const dvec3& axis : single ? std::vector<dvec3>{light.directionWorld} : axes) {
        maps.lightViewFromLightRelative.push_back(lookAlong(axis));
        maps.lightClipFromLightView.push_back(perspective(tanHalf * guard, maps.nearest, maps.farthest));
    }
}

} // namespace

LightMaps fitLightMaps(const scene::Scene& scene, const scene::Light& light, std::span<const std::size_t> casters,
                       int resolution, int guardTexels) {
    std::vector<scene::Bounds> all, casterBounds;
    scene::Bounds whole;
    for (const scene::Object& object : scene.objects) {
        all.push_back(scene::boundsWorld(object));
        whole.include(all.back());
    }
    for (const std::size_t caster : casters) casterBounds.push_back(all[caster]);
    if (casterBounds.empty()) casterBounds = all; // an empty map, but a map

    LightMaps maps;
    maps.sceneNearest = 1e300;
    maps.sceneFarthest = 0;
    if (light.type == scene::LightType::directional) {
        maps.originWorld = whole.isEmpty() ? dvec3(0.0) : 0.5 * (whole.lowerWorld + whole.upperWorld);
        if (casterBounds.empty()) casterBounds = all = {scene::Bounds{dvec3(-1), dvec3(1)}};
        fitParallel(maps, light, casterBounds, all, resolution, guardTexels);
    } else {
        maps.originWorld = light.positionWorld;
        fitPerspective(maps, light, casterBounds, all, resolution, guardTexels);
    }
    return maps;
}

dmat4 lightRelativeFromMesh(const LightMaps& maps, const scene::Object& object) {
    dmat4 matrix = scene::worldFromMesh(object);
    matrix[3] -= dvec4(maps.originWorld, 0.0);
    return matrix;
}

} // namespace shadowlab::shadow_map
