// All pairs of boxes that touch, among boxes of any sizes.
//
// Each box is entered into a grid whose cells are larger than it: one grid for each power of two. Boxes of about one size meet in
// their own grid; a small box also looks into the grids of all larger ones, never the other way round. So each box looks at no more
// than eight cells of each grid, however much the sizes differ. (Ericson, "Real-Time Collision Detection", 2005, 7.2: hierarchical
// grids.)
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Do two boxes share a point?
inline bool touch(const Bounds& a, const Bounds& b) {
    return a.lowerWorld.x <= b.upperWorld.x && b.lowerWorld.x <= a.upperWorld.x && a.lowerWorld.y <= b.upperWorld.y &&
           b.lowerWorld.y <= a.upperWorld.y && a.lowerWorld.z <= b.upperWorld.z && b.lowerWorld.z <= a.upperWorld.z;
}

/// `visit(i, j)` for each two of them that touch, i < j, once.
void forEachTouchingPair(std::span<const Bounds> boxes, const std::function<void(std::uint32_t, std::uint32_t)>& visit);

} // namespace shadowlab::scene
