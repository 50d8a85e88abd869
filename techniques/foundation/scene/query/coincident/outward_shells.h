// Closed surfaces among faces that are written twice, once for each side: the outer skin of a house whose inner skin lies at the same
// place. The mesh as a whole is not closed, four faces meet at an edge. Either skin by itself is.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// For each triangle: does it belong to a closed skin whose fronts face outward (outward_parts.h), and does the skin lie at the place of
/// another one? Across an edge a skin goes on with the triangle that is wound alike and does not coincide with the one before.
/// `coinciding`: pairs of triangles, in any order.
std::vector<bool> inOutwardShell(const Mesh& mesh, std::span<const std::pair<std::uint32_t, std::uint32_t>> coinciding);

} // namespace shadowlab::scene
