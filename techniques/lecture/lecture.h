// The lecture's own algorithms, one in each file of this folder. Start with any of them: none needs another.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::lecture {

const TechniqueInfo& planar();    // planar.cpp: direct projection method
const TechniqueInfo& shadowMap(); // shadow_map.cpp: shadow map method
const TechniqueInfo& zPass();     // zpass.cpp: shadow volumes, counted between eye and point
const TechniqueInfo& zFail();     // zfail.cpp: shadow volumes, counted behind the point

} // namespace shadowlab::lecture
