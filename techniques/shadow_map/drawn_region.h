// The part of a picture that is drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

/// The view's region, or all of the picture where it has none.
inline Region drawnRegion(const View& view) {
    const bool all = view.region.size.x <= 0 || view.region.size.y <= 0;
    return all ? Region{ivec2(0), view.size} : view.region;
}

} // namespace shadowlab::shadow_map
