// The parts of a probe as JSON: what decided on the shadow at the pixel, spread rays, structures and equations. Each is null where the probe has none.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/json/json_values.h"
#include "techniques/probe.h"

namespace shadowlab::cli {

// What decided on the shadow: faces of volumes, a texel of a map, triangles above a plane. What is infinite is null, too: JSON has
// no such number.
Json decisionJson(const Probe& probe);
Json volumeJson(const Probe& probe);
Json mapJson(const Probe& probe);
Json planeJson(const Probe& probe);
Json passesJson(const Probe& probe);

// Of rays: their samples, the structure that they went through, and the equations of radiosity.
Json samplesJson(const Probe& probe);
Json structureJson(const Probe& probe);
Json equationsJson(const Probe& probe);

} // namespace shadowlab::cli
