// Which lights can light anything that is in view: one that shines elsewhere need not be drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::scene {

/// False when the light certainly leaves dark all that may be seen in that part of the picture: it lies outside the cone of
/// a spot, or behind a rect. Other lights shine everywhere. `bounds` are the scene's objectBounds.
/// Simplified: what is turned away from the light, or lies in a shadow as a whole, is not looked for.
bool mayLight(const Scene& scene, const Light& light, std::span<const Bounds> bounds, const dvec3& eyeWorld,
              const dmat4& clipFromWorld, const PicturePart& part);

} // namespace shadowlab::scene
