// What decided on the shadow at a pixel, as JSON: faces of volumes, a texel of a map, triangles above a plane.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "techniques/probe.h"

namespace shadowlab::commands {

/// null where the probe has no such thing. What is infinite is null, too: JSON has no such number.
nlohmann::ordered_json decisionJson(const Probe& probe);
nlohmann::ordered_json volumeJson(const Probe& probe);
nlohmann::ordered_json mapJson(const Probe& probe);
nlohmann::ordered_json planeJson(const Probe& probe);
nlohmann::ordered_json passesJson(const Probe& probe);

} // namespace shadowlab::commands
