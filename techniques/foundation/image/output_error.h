// Why a file could not be written, and what to do about it, in one line.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace shadowlab::image {

/// `FILE: reason; mend` for an errno. `oldFileKept` adds that the file to be replaced is still there.
std::string outputErrorText(const std::filesystem::path& path, int errorNumber, bool oldFileKept);

} // namespace shadowlab::image
