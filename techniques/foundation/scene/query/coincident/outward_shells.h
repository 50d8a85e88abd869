// Closed surfaces among faces that are written twice, once for each side: the outer skin of a house whose inner skin lies at the same
// place. The mesh as a whole is not closed, four faces meet at an edge. Either skin by itself is.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// For each triangle: does it belong to a closed skin whose fronts face outward (outward_parts.h)? Across an edge a skin goes on with the
/// triangle that is wound alike and does not coincide with the one before, `areTogether`.
std::vector<bool> inOutwardShell(const Mesh& mesh, const std::function<bool(std::uint32_t, std::uint32_t)>& areTogether);

} // namespace shadowlab::scene
