// View culling: what cannot touch the drawn part of the picture, and the planes around that part.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// A rectangle of the picture in normalised device coordinates: from (-1, -1), lower left, to (1, 1).
struct PicturePart {
    dvec2 lower{-1.0}, upper{1.0};
};

/// An empty one; around() it and another is the other.
inline constexpr PicturePart kNowhere{dvec2(1e300), dvec2(-1e300)};

/// The smallest rectangle that holds both.
inline PicturePart around(const PicturePart& a, const PicturePart& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

/// The part that covers pixels `corner` to `corner + size`, counted from the upper left, of a picture of `pictureSize`; an
/// empty size means all of it. One pixel wider on each side than that: the rasteriser rounds, and may touch a pixel that
/// exact arithmetic would not.
PicturePart picturePart(ivec2 corner, ivec2 size, ivec2 pictureSize);

/// False when the convex hull of these points certainly touches nothing in that part: all lie beyond one of its sides, or
/// before the near plane. The points are clip coordinates; w = 0 stands for a direction.
bool mayTouch(std::span<const dvec4> pointsClip, const PicturePart& part);

/// True when all of the box certainly lies behind the near plane, as seen from the eye, which then is outside the box.
bool isBeyondNearPlane(const Bounds& bounds, const dmat4& clipFromWorld);

/// Whether a box may touch that part.
bool mayTouch(const Bounds& bounds, const dmat4& clipFromWorld, const PicturePart& part);

/// Left, right, bottom, top and near plane of that part of the view, in the world: positive inside. The far plane is at infinity.
inline std::array<dvec4, 5> planesWorld(const dmat4& clipFromWorld, const PicturePart& part) {
    const dmat4 transposed = glm::transpose(clipFromWorld);
    return {transposed * dvec4(1, 0, 0, -part.lower.x), transposed * dvec4(-1, 0, 0, part.upper.x),
            transposed * dvec4(0, 1, 0, -part.lower.y), transposed * dvec4(0, -1, 0, part.upper.y),
            transposed * dvec4(0, 0, 1, 1)};
}

} // namespace shadowlab::scene
