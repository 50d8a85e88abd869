// A number for the program that draws: equal numbers draw equal pictures of equal scenes with the same OpenGL driver.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace shadowlab::student {

/// Sixteen hexadecimal digits over the program itself, the plug-ins taken in, every shader as it is compiled now
/// (SHADOWLAB_SHADERS) with what it includes, and the fonts. A version number would not do: who edits a shader draws something
/// else with the same one. Throws Error (badInput) where a shader's file cannot be read.
std::string programDigest();

} // namespace shadowlab::student
