// The arguments of the command line that makes the picture on show.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/lab/document.h"

namespace shadowlab::course {

/// What follows the program's name: `capture SCENE -o OUT.png -t ...`. `sceneFile` holds the scene as it is seen, with its
/// camera; `size` is that of the picture area.
std::vector<std::string> captureArguments(const lab::Document& document, const std::filesystem::path& sceneFile,
                                      const std::filesystem::path& picture, ivec2 size);

/// The options that belong to no command, as this program was given them: --plugin, --software and --limit.
std::vector<std::string> globalArguments();

/// For a shell: words with odd characters in quotes.
std::string asCommandLine(const std::vector<std::string>& words);

/// "single", "side", "split", "grid", "diff".
std::string_view layoutName(picture::Layout layout);

} // namespace shadowlab::course
