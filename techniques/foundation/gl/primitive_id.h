// Fragment shaders that read gl_PrimitiveID, on a driver that draws nothing with them.
//
// Mesa's softpipe, the plain one of its software renderers, draws no pixel when a fragment shader reads the number of its
// triangle, unless a geometry shader hands the number on. So there one is put between that hands everything on and changes
// nothing. Everywhere else there is none: it would cost time for nothing. (Mesa 22.3; that renderer is worth the trouble as a
// second opinion, because it rounds otherwise than llvmpipe.)
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::gl {

/// Is this such a driver? A context must be current.
bool losesPrimitiveId();

/// The geometry shader for a vertex shader with these outputs, which have to be renamed there: with the defines, to be placed
/// before its text.
struct HandingOn {
    std::string geometryText;
    std::vector<std::string> vertexDefines;
};

/// `vertexText` is after its includes; `defines` are those it is compiled with, of which its #ifdefs may speak.
HandingOn handingOn(std::string_view vertexText, std::span<const std::string> defines);

} // namespace shadowlab::gl
