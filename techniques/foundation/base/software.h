// Which renderers draw on the processor.
// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace shadowlab {

/// By what GL_RENDERER says.
[[nodiscard]] bool isSoftware(std::string_view renderer);

} // namespace shadowlab
