// Random scenes that break careless shadow volumes, one class for each way to be careless.
// All coordinates lie on a grid of 2^-12 so that the signs of determinants are exact in double.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

enum class HardClass { soup, torus, nonManifold, lightInMesh, lightOnVertexOrPlane, eyeInSoup };
inline constexpr HardClass kHardClasses[] = {HardClass::soup,
                                             HardClass::torus,
                                             HardClass::nonManifold,
                                             HardClass::lightInMesh,
                                             HardClass::lightOnVertexOrPlane,
                                             HardClass::eyeInSoup};
std::string toText(HardClass hardClass);

/// The scene of that class and number: same number, same scene. `directional` turns the light into one at infinity.
scene::Scene hardScene(HardClass hardClass, unsigned number, bool directional);

} // namespace shadowlab::testing
