// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/light_maps.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
    dmat4 clipFromView(0.0);
    clipFromView[0][0] = clipFromView[1][1] = 1.0 / tanHalf;
    clipFromView[2][2] = -(far + near) / (far - near);
    clipFromView[2][3] = -1.0;
    clipFromView[3][2] = -2.0 * far * near / (far - near);
    return clipFromView;
}

dmat4 parallelProjection(const dvec3& lower, const dvec3& upper) {
    dmat4 clipFromView(1.0);
    const dvec3 extent = upper - lower;
    clipFromView[0][0] = 2.0 / extent.x;
    clipFromView[1][1] = 2.0 / extent.y;
    clipFromView[2][2] = -2.0 / extent.z;
    clipFromView[3] =
        dvec4(-(lower.x + upper.x) / extent.x, -(lower.y + upper.y) / extent.y, (lower.z + upper.z) / extent.z, 1.0);
    return clipFromView;
}

/// Nearest point of the box to the origin of light-relative space, and its farthest corner, as distances.
std::pair<double, double> distanceRange(const scene::Bounds& box, const dvec3& originWorld) {
    const dvec3 nearest = glm::clamp(originWorld, box.lowerWorld, box.upperWorld) - originWorld;
    double farthest = 0;
    for (int i = 0; i < 8; ++i)
        farthest = std::max(farthest, glm::length(box.corner(i) - originWorld));
    return {glm::length(nearest), farthest};
}

/// Range of the boxes' corners in the light's view space.
scene::Bounds boundsInView(std::span<const scene::Bounds> boxes, const dvec3& originWorld,
                           const dmat4& lightViewFromLightRelative) {
    scene::Bounds range;
    for (const scene::Bounds& box : boxes)
        for (int i = 0; i < 8; ++i)
            range.include(transformPoint(lightViewFromLightRelative, box.corner(i) - originWorld));
    return range;
}

void fitParallel(LightMaps& maps, const scene::Light& light, std::span<const scene::Bounds> casters,
                 std::span<const scene::Bounds> all, int resolution, int guardTexels) {
    const dmat4 lightViewFromLightRelative = lookAlong(light.directionWorld);
    scene::Bounds range = boundsInView(casters, maps.originWorld, lightViewFromLightRelative);
    const scene::Bounds whole = boundsInView(all, maps.originWorld, lightViewFromLightRelative);
    range.lowerWorld.z = whole.lowerWorld.z;
    range.upperWorld.z = whole.upperWorld.z;
    // The guard band, and half a texel against rounding; never empty, even for a caster seen edge-on.
    const dvec3 extent = range.upperWorld - range.lowerWorld;
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-6});
    const double share = (guardTexels + 0.5) / std::max(1, resolution - 2 * guardTexels - 1);
    // Square texels: the longer side decides for both.
    const double side = std::max({extent.x, extent.y, 1e-3 * largest});
    const dvec3 margin(0.5 * (side - extent.x) + share * side, 0.5 * (side - extent.y) + share * side, 1e-3 * largest);
    range.lowerWorld -= margin;
    range.upperWorld += margin;
    maps.parallel = true;
    maps.nearest = -range.upperWorld.z;
    maps.farthest = -range.lowerWorld.z;
    maps.lightViewFromLightRelative = {lightViewFromLightRelative};
    maps.lightClipFromLightView = {parallelProjection(range.lowerWorld, range.upperWorld)};
}

/// The camera that sees all casters in one square picture: where it looks, and half its width at distance 1.
struct Aim {
    dmat4 lightViewFromLightRelative;
    double tanHalf;
};

/// Looks at the middle of the casters. Nothing when they are all around, or spread wider than one map serves well.
std::optional<Aim> aimAt(std::span<const scene::Bounds> casters, const dvec3& originWorld) {
    scene::Bounds together;
    for (const scene::Bounds& box : casters)
        together.include(box);
    const dvec3 middle = 0.5 * (together.lowerWorld + together.upperWorld) - originWorld;
    if (!(glm::length(middle) > 0)) return std::nullopt;
    Aim aim{lookAlong(glm::normalize(middle)), 1e-6};
    for (const scene::Bounds& box : casters)
        for (int i = 0; i < 8; ++i) {
            const dvec3 cornerView = transformPoint(aim.lightViewFromLightRelative, box.corner(i) - originWorld);
            if (cornerView.z >= 0) return std::nullopt;
            aim.tanHalf =
                std::max({aim.tanHalf, std::abs(cornerView.x / cornerView.z), std::abs(cornerView.y / cornerView.z)});
        }
    const double widest = std::tan(kWidestSingleConeDegrees * glm::pi<double>() / 360.0);
    return aim.tanHalf <= widest ? std::optional(aim) : std::nullopt;
}

void fitPerspective(LightMaps& maps, const scene::Light& light, std::span<const scene::Bounds> casters,
                    std::span<const scene::Bounds> all, int resolution, int guardTexels) {
    double nearest = 1e300, farthest = 0;
    for (const scene::Bounds& box : all) {
        const auto [boxNearest, boxFarthest] = distanceRange(box, maps.originWorld);
        nearest = std::min(nearest, boxNearest);
        farthest = std::max(farthest, boxFarthest);
    }
    // The distance along one of the six axes is at least 1/sqrt(3) of the distance itself; in a single wide picture,
    // half.
    maps.farthest = std::max(1.001 * farthest, 1e-6);
    maps.nearest = std::max(0.49 * nearest, kLeastNearShare * maps.farthest);

    const double guard = 1.0 + 2.0 * (guardTexels + 1) / std::max(1, resolution - 2 * guardTexels - 2);
    const auto add = [&](const dmat4& lightViewFromLightRelative, double tanHalf) {
        maps.lightViewFromLightRelative.push_back(lightViewFromLightRelative);
        maps.lightClipFromLightView.push_back(perspective(tanHalf * guard, maps.nearest, maps.farthest));
    };
    if (light.type == scene::LightType::spot && light.coneDegrees <= kWidestSingleConeDegrees) {
        add(lookAlong(light.directionWorld), std::tan(light.coneDegrees * glm::pi<double>() / 360.0));
    } else if (const std::optional<Aim> aim = aimAt(casters, maps.originWorld)) {
        add(aim->lightViewFromLightRelative, aim->tanHalf);
    } else {
        for (const dvec3& axis :
             {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)})
            add(lookAlong(axis), 1.0);
    }
}

} // namespace

LightMaps fitLightMaps(const scene::Scene& scene, const scene::Light& light, std::span<const std::size_t> casters,
                       int resolution, int guardTexels, const scene::Bounds& region) {
    std::vector<scene::Bounds> all = scene::objectBounds(scene), casterBounds;
    scene::Bounds whole;
    for (const scene::Bounds& box : all)
        whole.include(box);
    for (const std::size_t caster : casters)
        casterBounds.push_back(all[caster]);
    if (!region.isEmpty()) casterBounds.push_back(region);
    if (casterBounds.empty()) casterBounds = all; // an empty map, but a map

    LightMaps maps;
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
    dmat4 relativeFromMesh = scene::worldFromMesh(object);
    relativeFromMesh[3] -= dvec4(maps.originWorld, 0.0);
    return relativeFromMesh;
}

} // namespace shadowlab::shadow_map
