// Culling of lights that light nothing in view.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::scene {

/// False if everything that may be seen in that part of the picture certainly lies outside of the cone of a spot, or behind
/// a rect. Conservative. Other lights shine everywhere. `bounds` are the scene's objectBounds. Simplified: surfaces that
/// face away from the light or lie in shadow are not considered.
bool mayLight(const Scene& scene, const Light& light, std::span<const Bounds> bounds, const dvec3& eyeWorld,
              const dmat4& clipFromWorld, const PicturePart& part);

} // namespace shadowlab::scene
