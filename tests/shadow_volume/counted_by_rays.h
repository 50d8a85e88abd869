// What a stencil would count, found with rays and without a graphics card: for volumes that are built wrongly on purpose,
// and that no technique draws. The same count of rightly built ones is right, so that the fault is in the building.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "tests/support/truth_comparison.h"

namespace shadowlab::testing {

/// A face of a volume in world space, counter-clockwise seen from outside; a corner with w = 0 is at infinity.
struct VolumeFace {
    dvec4 a, b, c;
    std::uint32_t object = ~0u, triangle = ~0u; ///< of a top cap: which triangle it is
};
using VolumeFaces = std::vector<VolumeFace>;

/// On which side of a triangle the light is (+1, -1, 0), asked once for each use: 0, 1, 2 for the side at the edge that
/// begins at that corner, kCaps for both caps.
using SideOf = std::function<int(std::size_t object, std::uint32_t triangle, int use)>;
inline constexpr int kCaps = 3;

/// Where a point of the world is pushed to.
using Far = std::function<dvec4(const dvec3& positionWorld)>;

/// As the techniques decide: one exact sign for each triangle, whoever asks.
SideOf oneSign(const scene::Scene& scene, const scene::Light& light);
/// In float and by the edges that meet at the corner at hand: another opinion for each use of a triangle.
SideOf signsInFloat(const scene::Scene& scene, const scene::Light& light);
/// v * l.w - l.xyz at infinity, for point and directional lights alike.
Far awayFrom(const scene::Light& light);

/// The volumes of all casters: a prism behind each triangle, turned toward the light. What cancels between neighbours cancels
/// in the count.
VolumeFaces prisms(const scene::Scene& scene, const SideOf& sideOf, const Far& far);
/// The classical ones: caps of the triangles that face the light by their winding, sides where an edge has one that does and
/// one that does not. Right for closed, consistently wound meshes.
VolumeFaces betweenTwoFaces(const scene::Scene& scene, const SideOf& sideOf, const Far& far);

struct RayCounts {
    int lit = 0, shadowed = 0, wrong = 0;
};

/// Every fourth pixel of every fourth row that is lit or shadowed and no tie, counted as depth fail does: along the eye ray,
/// from the point on.
RayCounts countedBehind(const JudgedPicture& picture, const VolumeFaces& faces);
/// The same as depth pass does, from the eye to the point, starting with `start`. Sides alone.
RayCounts countedBefore(const JudgedPicture& picture, const VolumeFaces& faces, int start);

} // namespace shadowlab::testing
