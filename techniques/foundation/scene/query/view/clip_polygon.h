// Cutting a polygon at a plane.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// One of the six faces of a box (0..5) as such a polygon, its corners in order around it, w = 1.
std::vector<dvec4> boxFaceWorld(const Bounds& box, int face);

/// The part of a convex polygon, in homogeneous coordinates, on the side of a plane where the product of the two is positive
/// (Sutherland and Hodgman, 1974). Coordinates may be those of clip space, or of the world with w = 1.
std::vector<dvec4> clippedPolygon(const std::vector<dvec4>& polygon, const dvec4& plane);

} // namespace shadowlab::scene
