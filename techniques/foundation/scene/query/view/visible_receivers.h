// The visible parts of the receivers: a shadow that falls elsewhere need not be drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::scene {

/// For each object that receives shadows and may be seen in that part of the picture a box around what may be seen of it; at
/// most that many boxes, then of several objects each.
/// `bounds` are the scene's objectBounds.
std::vector<Bounds> visibleReceivers(const Scene& scene, std::span<const Bounds> bounds, const dmat4& clipFromWorld,
                                     const PicturePart& part, std::size_t most);

} // namespace shadowlab::scene
