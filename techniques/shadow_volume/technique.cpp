// The techniques of this folder: z-pass and z-fail, and the one that chooses between them for each caster.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/shared_info.h"

namespace shadowlab::shadow_volume {

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo info[] = {zpassInfo(), zfailInfo(), automaticInfo()};
    return info;
}

} // namespace shadowlab::shadow_volume
