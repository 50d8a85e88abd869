// Folders to begin a technique with: a skeleton (assets/skeletons), written under the name that the technique is to have.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::student {

/// "empty", "planar", "shadow-map", "z-fail".
std::vector<std::string> skeletonNames();

/// Throws Error (usage) where a technique, its namespace and its folder of shaders cannot have that name: no id, longer than 40
/// characters, a word of C++, or in use.
void requireFreeName(const std::string& name);

/// Writes the skeleton as a new folder, whole or not at all. Throws Error (usage) for a bad name, (badInput) where the skeleton is
/// not installed, (cannotWrite) where there is something of that name already, or it cannot be made.
void writeSkeleton(const std::string& skeleton, const std::string& name, const std::filesystem::path& folder);

} // namespace shadowlab::student
