// Scripts and styles of pages for a browser, as they lie in assets/pages. A page holds what it needs: one that is opened from a folder may
// load no other file.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>

namespace shadowlab::course {

/// The files of these names, one after the other. `assets`: the folder of all assets. Throws Error (badInput) where one is missing.
std::string pageCode(const std::filesystem::path& assets, std::span<const char* const> files);

} // namespace shadowlab::course
