// Where the program's own scenes, models and fonts are.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace shadowlab::session {

/// The folder that the environment variable SHADOWLAB_ASSETS names, else assets/ of the source tree it was built from.
std::filesystem::path assetsRoot();

} // namespace shadowlab::session
