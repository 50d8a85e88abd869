// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/picture_part.h"

#include <algorithm>
#include <array>

namespace shadowlab::scene {

namespace {

// Conservative: rounding must not cull what grazes a plane.
constexpr double kMargin = 1e-6;

double sizeOf(const dvec4& point) {
    return std::abs(point.x) + std::abs(point.y) + std::abs(point.z) + std::abs(point.w);
}

std::array<dvec4, 8> cornersClip(const Bounds& bounds, const dmat4& clipFromWorld) {
    std::array<dvec4, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[static_cast<std::size_t>(i)] = clipFromWorld * dvec4(bounds.corner(i), 1.0);
    return corners;
}

} // namespace

PicturePart picturePart(ivec2 corner, ivec2 size, ivec2 pictureSize) {
    if (size.x <= 0 || size.y <= 0) return picturePart(ivec2(0), pictureSize, pictureSize);
    const dvec2 pixel = 2.0 / dvec2(pictureSize);
    const ivec2 fromBelow(corner.x, pictureSize.y - corner.y - size.y);
    return {dvec2(-1.0) + dvec2(fromBelow - 1) * pixel, dvec2(-1.0) + dvec2(fromBelow + size + 1) * pixel};
}

bool mayTouch(std::span<const dvec4> pointsClip, const PicturePart& part) {
    // Left, right, bottom, top, near: inside where the product is positive. The far plane is at infinity.
    const std::array<dvec4, 5> planes = {dvec4(1, 0, 0, -part.lower.x), dvec4(-1, 0, 0, part.upper.x),
                                         dvec4(0, 1, 0, -part.lower.y), dvec4(0, -1, 0, part.upper.y),
                                         dvec4(0, 0, 1, 1)};
    return std::ranges::none_of(planes, [&](const dvec4& plane) {
        return std::ranges::all_of(
            pointsClip, [&](const dvec4& point) { return glm::dot(plane, point) < -kMargin * sizeOf(point); });
    });
}

bool isBeyondNearPlane(const Bounds& bounds, const dmat4& clipFromWorld) {
    return std::ranges::all_of(cornersClip(bounds, clipFromWorld),
                               [](const dvec4& corner) { return corner.z + corner.w > kMargin * sizeOf(corner); });
}

bool mayTouch(const Bounds& bounds, const dmat4& clipFromWorld, const PicturePart& part) {
    return mayTouch(cornersClip(bounds, clipFromWorld), part);
}

} // namespace shadowlab::scene
