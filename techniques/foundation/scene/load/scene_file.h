// The file that SCENE on a command line stands for.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

/// The path itself, or that of a built-in scene. Throws Error (badInput) for a name that is neither.
std::filesystem::path sceneFile(const std::string& nameOrPath, const LoadOptions& options);

/// By the file's ending, in capitals or not: a .json scene; a mesh, .obj or .gltf and .glb; or none of them.
enum class FileKind { none, scene, obj, gltf };
FileKind fileKind(const std::filesystem::path& file);

} // namespace shadowlab::scene
