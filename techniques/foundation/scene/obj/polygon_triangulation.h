// Splits a polygon in space into triangles, convex or not.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// Triangles as indices into `corners`, n - 2 of them, turning the same way as the polygon. Corners may be concave or lie
/// on a straight edge; triangles without area are made only where the polygon leaves no alternative. Method: ear clipping
/// (Meisters, "Polygons have ears", 1975) on the projection along the largest axis of the normal.
void triangulate(std::span<const dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace shadowlab::scene
