// The plain scene as JSON, which the page for three.js and the script for Blender carry with them and read.
//
// Lists of vectors are one text, "0 0 0 1 0 0": shorter than JSON's own lists, and read at once.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/foreign/export/plain_scene.h"

namespace shadowlab::foreign {

enum class ImagesAs { files, dataUrls }; ///< images are named, or lie within the text
enum class MeshesAs { numbers, files };  ///< meshes lie within the text, or are named (meshFile)

/// Of ASCII alone, and without the character '<', so that it may stand in a page.
std::string plainSceneJson(const PlainScene& scene, ivec2 size, ImagesAs images, MeshesAs meshes = MeshesAs::numbers);

/// "meshes/scene-1.ply", for the first mesh: its place below the folder.
std::string meshFile(const std::string& stem, std::size_t mesh);

} // namespace shadowlab::foreign
