// What tinyobjloader makes of a checked OBJ file: polygons, the material of each, and the materials of the libraries.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/obj/obj_scan.h"

namespace shadowlab::scene {

struct ObjCorner {
    std::uint32_t position = 0;
    std::int32_t normal = -1;   ///< -1: none
    std::int32_t texcoord = -1; ///< -1: none
};

struct ObjFaces {
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> firstCorner; ///< per face, and one behind the last
    std::vector<std::uint32_t> materialOf;  ///< per face, index into materialNames
    std::vector<std::string> materialNames; ///< as usemtl says, in order of first use; "" before any usemtl
    std::vector<Material> materials;        ///< of all libraries
    std::vector<std::string> notes;
};

/// Takes `scan.statements` (cleared afterwards). Material files come through AllowedFolders; a missing one is a note.
ObjFaces readFaces(ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options);

} // namespace shadowlab::scene
