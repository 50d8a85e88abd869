// What decided on the shadow at a pixel, as JSON: faces of volumes, a texel of a map, triangles above a plane.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/json/json_values.h"
#include "techniques/probe.h"

namespace shadowlab::cli {

/// null where the probe has no such thing. What is infinite is null, too: JSON has no such number.
Json decisionJson(const Probe& probe);
Json volumeJson(const Probe& probe);
Json mapJson(const Probe& probe);
Json planeJson(const Probe& probe);
Json passesJson(const Probe& probe);

} // namespace shadowlab::cli
