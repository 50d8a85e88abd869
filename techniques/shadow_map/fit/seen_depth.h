// The range of distances in a picture, from its depth buffer: cascades need not cover what nobody sees.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/frame.h"

namespace shadowlab::shadow_map {

/// Metres along the eye's axis to the nearest and the farthest visible point, of a picture whose depths have been drawn;
/// none where there is only background. Read back, which takes about as long as filling the picture once (Lauritzen, Salvi
/// and Lefohn 2011 do it on the graphics card, with shaders that OpenGL 3.3 does not have).
std::optional<dvec2> visibleDepthRange(const Frame& frame);

} // namespace shadowlab::shadow_map
