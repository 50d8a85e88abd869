// The text of a shader file, for those who show it.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace shadowlab::gl {

/// One file as programs are compiled from it now: from the folder that the environment variable SHADOWLAB_SHADERS names,
/// where it is there, else as it was embedded. Nothing where there is no such file.
std::optional<std::string> shaderText(std::string_view name);

} // namespace shadowlab::gl
