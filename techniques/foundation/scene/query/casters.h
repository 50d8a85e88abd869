// The objects that can shadow anything at all, so that techniques build nothing for the others.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Indices of the casting objects whose shadow can fall on something. Left out is a flat object (a floor, a wall) with
/// the whole scene on the light's side of its plane: behind it there is nothing to be shadowed.
std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light);

/// The same with the boxes of the objects (objectBounds), which saves a pass over all vertices.
std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light, std::span<const Bounds> bounds);

/// Indices of all casting objects.
std::vector<std::size_t> allCasters(const Scene& scene);

} // namespace shadowlab::scene
