// What can be known about the file of a plug-in without running anything of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace shadowlab::student {

/// Throws Error (badInput) beginning with `FILE: `.
[[noreturn]] void refusePlugin(const std::filesystem::path& file, const std::string& whatAndMend);

/// Is it a shared library with the mark of a plug-in, for the contract of this program? Throws as above.
void requirePluginFile(const std::filesystem::path& file);

} // namespace shadowlab::student
