// OpenGL by Mesa on the processor, also on a machine with a graphics card: the same bytes on every machine
// with the same Mesa whose processor has AVX.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// From now on only contexts with software rendering are made, also by programs that this one starts. Called before the first
/// context: Mesa reads its environment when it is loaded.
void demandSoftware();
[[nodiscard]] bool isSoftwareDemanded();

} // namespace shadowlab::context
