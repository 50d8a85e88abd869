// glTF 2.0, as .gltf or .glb: things, lights and cameras in one file. docs/gltf.md says what of it is read, and what becomes of it.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

/// A node that shows a mesh.
struct GltfObject {
    std::string name; ///< no two have the same
    std::shared_ptr<const Mesh> mesh;
    dmat4 worldFromNode{1.0};
    std::vector<std::uint32_t> partMaterials; ///< one for each part, an index into GltfFile::materials, or this:
    static constexpr std::uint32_t kNoMaterial = 0xffffffffu;
};

struct GltfFile {
    std::vector<Material> materials; ///< no two have the same name
    std::vector<GltfObject> objects; ///< at least one
    std::vector<Light> lights;
    std::vector<Viewpoint> viewpoints;
    std::size_t nodes = 0, images = 0; ///< in the file
    std::vector<std::string> notes;
};

/// Throws Error (badInput, overLimit). Everything is checked before it is used.
GltfFile loadGltf(const std::filesystem::path& file, NormalMode mode, const LoadOptions& options);

/// The same from the bytes of the file; only buffers and images that it names are read from elsewhere.
GltfFile parseGltf(std::string bytes, const std::filesystem::path& file, NormalMode mode, const LoadOptions& options);

/// A scene of the file alone. Its first camera is the scene's, its lights are the scene's. Where it has no lights, a key light is added;
/// where it has no camera, one that frames it; where it has neither, it is put on a floor as an OBJ file is.
std::shared_ptr<const Scene> stagedGltf(GltfFile gltf, const std::filesystem::path& file, const LoadOptions& options);

} // namespace shadowlab::scene
