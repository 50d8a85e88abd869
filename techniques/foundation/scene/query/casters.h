// Which objects can shadow anything at all: a technique builds nothing that cannot change a pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Indices of the casting objects whose shadow can fall on something. Left out is a flat object (a floor, a wall) with
/// the whole scene on the light's side of its plane: behind it there is nothing to be shadowed.
std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light);

/// The same for who has the objects' boxes at hand (objectBounds), and so need not look at every vertex again.
std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light, std::span<const Bounds> bounds);

/// Indices of all casting objects.
std::vector<std::size_t> allCasters(const Scene& scene);

} // namespace shadowlab::scene
