// Two names of one file, as two outputs of a command, or an output and an input.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace shadowlab::cli {

/// Would these two names lead to one and the same regular file? Neither need exist. What is no regular file, as /dev/null, takes any number of
/// outputs.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

} // namespace shadowlab::cli
