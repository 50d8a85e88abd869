// Where the program's own scenes, models and fonts are.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>

namespace shadowlab::context {

/// share/shadowlab beside the folder that the program lies in, where it was installed; none: it was built and not installed.
std::optional<std::filesystem::path> installedShare();

/// The source tree that the program was built from. It may have been deleted since.
std::filesystem::path sourceTree();

/// The folder that the environment variable SHADOWLAB_ASSETS names, else what was installed with the program, else assets/ of
/// the source tree it was built from.
std::filesystem::path assetsRoot();

} // namespace shadowlab::context
