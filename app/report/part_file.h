// The files that a report's folder is made of, read again.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace shadowlab::report {

/// All of a picture (`.png`) or a text of JSON, within the limits of images and scenes. Throws Error: badInput where it cannot be
/// read, overLimit.
std::string partBytes(const std::filesystem::path& file);

/// For the library that reads JSON a text ends at a NUL byte, whatever comes behind it: what holds one is not ours.
bool isText(const std::string& bytes);

} // namespace shadowlab::report
