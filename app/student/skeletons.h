// Folders to begin a technique with: a skeleton, written under the name that the technique is to have. `empty` is a folder of
// assets/skeletons. All others are the lecture's algorithms (techniques/lecture) with blanks, which blanks.h describes.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/plugin.h"

namespace shadowlab::student {

/// "empty", and those with blanks in the order of the lecture: "planar", "shadow-map", "z-fail", "ray-tracing", "radiosity".
std::vector<std::string> skeletonNames();

/// The files of a skeleton as my_shadows, by their names in its folder. Throws Error (badInput) where a file of the program is missing or
/// a blank does not fit the source.
std::map<std::string, std::string> skeletonFiles(const std::string& skeleton);

/// A built-in scene in which one sees whether it is right. Throws as skeletonFiles().
std::string sceneToTry(const std::string& skeleton);

/// The skeleton with blanks that a plug-in was made from: its sources and shaders have the anchors of all blanks, under names of their own.
/// Empty: of none, or the anchors have been taken out. Throws Error (badInput) where a file of the program is missing.
std::string skeletonOf(const Plugin& plugin);

/// Throws Error (usage) where a technique, its namespace and its folder of shaders cannot have that name: no id, longer than 40
/// characters, a word of C++, or in use.
void requireFreeName(const std::string& name);

/// Writes the skeleton as a new folder, whole or not at all. Throws Error (usage) for a bad name, (cannotWrite) where there is
/// something of that name already, or it cannot be made, and as skeletonFiles().
void writeSkeleton(const std::string& skeleton, const std::string& name, const std::filesystem::path& folder);

} // namespace shadowlab::student
