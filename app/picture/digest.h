// Numbers for what a scene shows, and for texts: equal scenes have equal ones, wherever their files lie.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::picture {

/// Sixteen hexadecimal digits over all that a picture of the scene depends on.
std::string digestOf(const scene::Scene& scene);
std::string digestOf(const std::string& text);
std::string digestOf(std::span<const std::uint8_t> bytes);

} // namespace shadowlab::picture
