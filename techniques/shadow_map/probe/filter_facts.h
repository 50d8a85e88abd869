// What a filter read, in words, and as shapes in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

/// How the answer came about: facts that stand before the decision.
void tellFilter(Probe& probe, const FilterAnswer& answer);

/// Every comparison, a line each: facts that stand last.
void tellTaps(Probe& probe, const FilterAnswer& answer);

/// Where on the receiver's plane the comparisons lie, as crosses, and the depths that a search took for blockers.
std::vector<SceneShape> tapShapes(const FilterAnswer& answer, double texelMetres);

} // namespace shadowlab::shadow_map
