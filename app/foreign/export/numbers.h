// Numbers as text that reads back as the same number, no longer than needed: 0.1, not 0.100000001.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "techniques/foundation/math/types.h"

namespace shadowlab::foreign {

std::string text(float value);
std::string text(double value);
/// "1, 2.5, -3"
std::string text(const dvec3& v);
std::string text(const vec3& v);

/// Appends the numbers, with blanks between them and after the last one: how the scripts take lists of vectors.
void appendAll(std::string& list, std::span<const float> values);
void appendAll(std::string& list, std::span<const std::uint32_t> values);

} // namespace shadowlab::foreign
