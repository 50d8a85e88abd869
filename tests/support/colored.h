// Objects whose surfaces have not the same colour all over, for tests.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// A floor with an image of four colours laid on it, repeated, scaled and moved; a box with the same image, clamped; a ball with colours
/// at its vertices, and one whose colours a material of the scene replaces; a grey box. One point light.
scene::Scene coloredScene();

/// An image of these colours, rows from the top, two columns.
std::shared_ptr<const scene::ColorImage> imageOf(const std::vector<vec3>& encoded);

} // namespace shadowlab::testing
