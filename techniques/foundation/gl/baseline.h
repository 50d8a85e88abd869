// The GL state that every pass starts from. It is set before each pass, so that no pass has to restore anything.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::gl {

/// Depth test GL_LESS with writes; colour writes on; no blending, stencil test, culling, scissor, polygon offset, depth
/// clamp or clip distances; counter-clockwise is front; polygons filled; dithering and multisampling off;
/// no program in use.
void setBaselineState();

} // namespace shadowlab::gl
