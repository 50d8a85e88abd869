// The techniques of this folder: the two ways to count the faces of a shadow volume, and the choice between them.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/shared_info.h"

namespace shadowlab::shadow_volume {

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo info[] = {zpassInfo(), zfailInfo(), automaticInfo()};
    return info;
}

} // namespace shadowlab::shadow_volume
