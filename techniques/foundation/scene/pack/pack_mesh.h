// A mesh file of a packed scene, with the material files and the images that it names.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/pack/packed_files.h"

namespace shadowlab::scene {

/// Copies the mesh into `meshes/`, its material files beside it and their images into `textures/` below that, and writes the
/// new places into the copies; all else in them stays. What a statement names and is not there, or may not be read, is left as
/// it is: it is noted and left out when the scene is loaded, before as after. `options` are those the mesh is loaded with.
/// Of a glTF file it copies the buffers beside it, and the images likewise.
/// Returns the place of the mesh, relative to the packed scene.
std::filesystem::path packMesh(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files);

} // namespace shadowlab::scene
