// A glTF file of a packed scene, with the buffers and the images that it names.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/pack/packed_files.h"

namespace shadowlab::scene {

/// As packMesh() does it for an OBJ file.
std::filesystem::path packGltf(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files);

} // namespace shadowlab::scene
