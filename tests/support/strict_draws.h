// What a strict driver refuses or leaves undefined and Mesa draws all the same, noticed at each draw call. No test here meets
// such a driver; the state that it would look at is the same.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace shadowlab::testing {

/// From now on, until the context is made current again: no program is deleted while it is in use, and before each draw call of
/// this context
///   - there is a program, and a vertex array, and the target is complete
///   - each sampler's texture unit has a texture, of a kind of texels that the sampler can read, complete with its levels, and
///     compared by the sampler exactly where the sampler's type says so
///   - no texture that is read is a part of the target (a feedback loop)
///   - vertex attributes that are whole numbers come from whole numbers
///   - a clip distance that is enabled is written by the vertex shader
///   - glValidateProgram has no objection
/// Programs that are linked meanwhile are also kept as files where the environment variable SHADOWLAB_KEEP_PROGRAMS names a
/// folder: one NAME.vert and one NAME.frag for each, as the compiler got them (tests/shaders/glsl_check.py).
void watchDraws();

/// What was noticed since the last call, a line for each fault; empties the record.
std::string takeDrawFaults();

} // namespace shadowlab::testing
