// Shaders that come with plug-ins, beside those that the program was built with.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "techniques/foundation/gl/shader_source.h"

namespace shadowlab::gl {

/// Adds the shaders of a plug-in, whose texts must outlive the program. They were read from `folder`.
void addShaders(std::span<const EmbeddedShader> shaders, std::string folder);

/// Every shader: the program's own, and after them those that were added.
std::vector<EmbeddedShader> allShaders();

/// The folders that added shaders were read from.
const std::vector<std::string>& addedShaderFolders();

/// From now on an added shader is read from there where it still is there: while it is being edited.
void readAddedShadersFromFolders();

} // namespace shadowlab::gl
