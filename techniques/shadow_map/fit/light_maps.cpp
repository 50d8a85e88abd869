// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/light_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shadowlab::shadow_map {

dmat4 LightMaps::lightViewFromLightClip(int layer) const {
    return glm::inverse(lightClipFromLightView[static_cast<std::size_t>(layer)]);
}

dmat4 lightRelativeFromMesh(const LightMaps& maps, const scene::Object& object) {
    dmat4 relativeFromMesh = scene::worldFromMesh(object);
    relativeFromMesh[3] -= dvec4(maps.originWorld, 0.0);
    return relativeFromMesh;
}

std::optional<int> layerOf(const LightMaps& maps, const dvec3& pointLightRelative, double eyeDepth) {
    if (maps.layers() == 0) return std::nullopt;
    if (maps.layout == Layout::one) return 0;
    if (maps.layout == Layout::cube) {
        const dvec3 size = glm::abs(pointLightRelative);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        return 2 * axis + (pointLightRelative[axis] > 0 ? 0 : 1);
    }
    int layer = 0;
    while (layer < maps.layers() - 1 && eyeDepth > maps.cascadeEnds[static_cast<std::size_t>(layer)])
        ++layer;
    return layer;
}

bool mayDrawInto(const LightMaps& maps, int layer, const scene::Bounds& bounds) {
    const dmat4 lightClipFromLightRelative = maps.lightClipFromLightRelative(layer);
    // Left, right, bottom, top, far, and behind the light: beyond which of them are all corners?
    std::array<bool, 6> beyond;
    beyond.fill(true);
    for (int i = 0; i < 8; ++i) {
        const dvec4 p = lightClipFromLightRelative * dvec4(bounds.corner(i) - maps.originWorld, 1.0);
        const double distances[6] = {p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.w - p.z, p.w};
        for (std::size_t plane = 0; plane < beyond.size(); ++plane)
            beyond[plane] = beyond[plane] && distances[plane] < 0;
    }
    return std::ranges::none_of(beyond, [](bool all) { return all; });
}

dmat4 lookAlong(const dvec3& forward, const dvec3& up) {
    const dvec3 right = glm::normalize(glm::cross(forward, up));
    return dmat4(glm::transpose(dmat3(right, glm::cross(right, forward), -forward)));
}

dmat4 lookAlong(const dvec3& forward) {
    return lookAlong(forward, std::abs(forward.y) > 0.99 ? dvec3(0, 0, 1) : dvec3(0, 1, 0));
}

dmat4 parallelProjection(const Box& box) {
    dmat4 clipFromView(1.0);
    const dvec3 extent = box.upper - box.lower, sum = box.upper + box.lower;
    clipFromView[0][0] = 2.0 / extent.x;
    clipFromView[1][1] = 2.0 / extent.y;
    clipFromView[2][2] = -2.0 / extent.z;
    clipFromView[3] = dvec4(-sum.x / extent.x, -sum.y / extent.y, sum.z / extent.z, 1.0);
    return clipFromView;
}

dmat4 perspectiveProjection(const dvec2& lowerTangent, const dvec2& upperTangent, double nearest, double farthest) {
    dmat4 clipFromView(0.0);
    for (int axis = 0; axis < 2; ++axis) {
        const double extent = upperTangent[axis] - lowerTangent[axis];
        clipFromView[axis][axis] = 2.0 / extent;
        clipFromView[2][axis] = (upperTangent[axis] + lowerTangent[axis]) / extent;
    }
    clipFromView[2][2] = -(farthest + nearest) / (farthest - nearest);
    clipFromView[2][3] = -1.0;
    clipFromView[3][2] = -2.0 * farthest * nearest / (farthest - nearest);
    return clipFromView;
}

namespace {

// A step of the coarsest format, of 16 bits. What is twice as far from the near plane is kept as a step at least.
constexpr double kStep = 0x1p-16;

/// Has the box no corner before that layer's near plane?
bool isBeyondPlane(const LightMaps& maps, int layer, const scene::Bounds& box) {
    const dmat4 lightClipFromLightRelative = maps.lightClipFromLightRelative(layer);
    for (int i = 0; i < 8; ++i) {
        const dvec4 p = lightClipFromLightRelative * dvec4(box.corner(i) - maps.originWorld, 1.0);
        if (!(p.w > 0 && p.z >= (4 * kStep - 1) * p.w)) return false; // a depth of two steps, in -1..1
    }
    return true;
}

/// Is it farther from the light than all of that layer's near rectangle? What is in one of several maps may be beside another.
bool isBeyondRectangle(const LightMaps& maps, int layer, const scene::Bounds& box) {
    if (maps.parallel) return false;
    const dmat4& lightClip = maps.lightClipFromLightView[static_cast<std::size_t>(layer)];
    const dvec2 widest = (1.0 + glm::abs(dvec2(lightClip[2]))) / dvec2(lightClip[0][0], lightClip[1][1]);
    const double rim = maps.nearest * std::sqrt(1.0 + glm::dot(widest, widest));
    const dvec3 closest = glm::clamp(maps.originWorld, box.lowerWorld, box.upperWorld);
    return glm::length(closest - maps.originWorld) > 1.001 * rim; // a thousandth farther: many steps in depth
}

} // namespace

double minReferenceDepth(const LightMaps& maps, const scene::Bounds& objectWorld) {
    for (int layer = 0; layer < maps.layers(); ++layer)
        if (!isBeyondPlane(maps, layer, objectWorld) && !isBeyondRectangle(maps, layer, objectWorld))
            return -std::numeric_limits<float>::max();
    return kStep;
}

} // namespace shadowlab::shadow_map
