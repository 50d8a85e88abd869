// The list of the lecture's algorithms, in the order of the lecture.
// SPDX-License-Identifier: MIT
#include "techniques/lecture/lecture.h"

namespace shadowlab::lecture {

std::span<const TechniqueInfo> techniques() {
    static const TechniqueInfo infos[] = {planar(), shadowMap(), zPass(), zFail(), rayTracing(), radiosity()};
    return infos;
}

} // namespace shadowlab::lecture
