// The list of the lecture's algorithms, in the order of the lecture.
// SPDX-License-Identifier: MIT
#include "techniques/lecture/lecture.h"

namespace shadowlab::lecture {

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo info[] = {
        planar(),
        shadowMap(),
        zPass(),
        zFail(),
    };
    return info;
}

} // namespace shadowlab::lecture
