// Plug-ins: techniques in shared libraries (techniques/plugin.h), taken into the registry beside ours.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "techniques/plugin.h"

namespace shadowlab::student {

struct LoadedPlugin {
    std::string file; ///< as it was given
    const Plugin* plugin = nullptr;
    std::span<const TechniqueInfo> techniques;
};

/// What the program says, and ends with status 70, where the code of a plug-in calls exit().
inline constexpr const char* kEndedByPlugin = "a plug-in or a library has ended the program";

/// Takes one in, before anybody has asked for the list of techniques. Its own code runs in another process first, so that one
/// that does not survive it is a message and no crash. Throws Error (badInput), `FILE: what is wrong; what to do`, and leaves
/// everything as it was: no file, no shared library, none of ours, built for another contract, does not load, throws, ids that
/// are no ids or are taken.
void loadPlugin(const std::filesystem::path& file);

/// Those that have been taken in, in order.
std::span<const LoadedPlugin> loadedPlugins();

/// The one that a technique of that folder (RegisteredTechnique) comes from; nullptr: it is ours.
const LoadedPlugin* pluginOf(std::string_view folder);

/// What is wrong with what a plug-in says of itself, and the remedy: loadPlugin turns it into an Error that names the file.
struct PluginFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Its techniques, looked through. Throws PluginFault, and whatever the plug-in throws.
std::span<const TechniqueInfo> checkedTechniques(const Plugin& plugin);

/// Small letters, digits and single hyphens between them; a letter comes first: "shadow-map".
bool isKebabCase(std::string_view id);

} // namespace shadowlab::student
