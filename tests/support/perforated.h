// Objects with holes, for tests: what an image does to them, without an image file.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// A mask as it is written down: rows from the top, '#' for surface and anything else for a hole.
using Pattern = std::vector<std::string>;
std::shared_ptr<const scene::AlphaMask> maskOf(const Pattern& pattern);

/// The mesh with its texture coordinates multiplied: the image repeated so many times.
scene::Mesh withRepeats(scene::Mesh mesh, vec2 times);

/// Gives an object of the scene a material of its own that cuts these holes.
void perforate(scene::Scene& scene, std::size_t object, const Pattern& pattern);

/// Does anything cast a shadow that has holes? Shadow volumes take it for solid.
bool castsThroughHoles(const scene::Scene& scene);

/// Floor, a perforated fence, a perforated hollow ball (of which the inside shows through its holes), a mirrored ring with
/// the image repeated on it, and a solid box; a point light and a sun.
scene::Scene perforatedScene();

} // namespace shadowlab::testing
