// A scene and all its files in one folder, which may be taken anywhere.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

struct PackedScene {
    std::filesystem::path file; ///< the scene, relative to the folder: NAME.json
    std::size_t copies = 0;     ///< files beside it
};

/// Writes the scene (`nameOrPath` as loadScene() takes it, `scene` what it gave) and copies of all that it is made of into the
/// folder, which exists and is empty:
/// - of a .json file the text itself, comments and all, with the new places of its files;
/// - of a bare mesh the scene that it is staged in, written down.
/// `pause` is called between files; it may throw. Throws Error as loading and writing do.
PackedScene packScene(const std::string& nameOrPath, const Scene& scene, const LoadOptions& options,
                      const std::filesystem::path& folder, const std::function<void()>& pause);

} // namespace shadowlab::scene
