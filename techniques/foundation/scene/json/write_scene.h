// From a scene back to a scene file (docs/scene_format.md): reading it gives the same scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The text of a scene file that stands in `folder`, with that camera. Numbers have as many digits as are needed to read
/// the same number; defaults are left out; meshes and images are named relative to the folder. Of a staged mesh whose file has
/// materials, parts that name none are clay: "white" is written as clay then, since the reader gives them that.
std::string sceneText(const Scene& scene, const Camera& camera, const std::filesystem::path& folder);

/// The text as a JSON string, with its quotes.
std::string textInJson(const std::string& text);

/// Folders of files the scene uses that a scene file in `folder` may not read unless they are allowed (--allow): those
/// neither below it nor below the assets.
std::vector<std::filesystem::path> foldersToAllow(const Scene& scene, const std::filesystem::path& folder,
                                                  const std::filesystem::path& assetsRoot);

} // namespace shadowlab::scene
