// The techniques of this folder: the shadow map with its filters, the map that rays make exact, and the visible points tested in
// the light's picture without a map.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/shared_info.h"

namespace shadowlab::shadow_map {

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo info[] = {shadowMapInfo(), exactMapInfo(), aliasFreeMapInfo()};
    return info;
}

} // namespace shadowlab::shadow_map
