// Numbers for what a scene shows, and for texts: equal scenes have equal ones, wherever their files lie.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::report {

/// Sixteen hexadecimal digits over all that a picture of the scene depends on.
std::string digestOf(const scene::Scene& scene);
std::string digestOf(const std::string& text);

} // namespace shadowlab::report
