// The one-line message for a file that could not be written: the reason and the remedy.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace shadowlab::image {

/// `FILE: reason; remedy` for an errno. `oldFileKept` adds that the file to be replaced is still there.
std::string outputErrorText(const std::filesystem::path& path, int errorNumber, bool oldFileKept);

} // namespace shadowlab::image
