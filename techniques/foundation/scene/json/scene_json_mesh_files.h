// The mesh files that the objects of a scene file name: each is read once for all objects that show it, and its materials join the
// scene's.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/json/scene_json.h"

namespace shadowlab::scene {

constexpr std::uint32_t kWhite = 0; ///< index of the default material

/// A mesh with the scene's materials. One that is too wide for its detail is kept in several (obj/mesh_pieces.h).
struct LoadedPiece {
    std::shared_ptr<const Mesh> mesh;
    std::vector<std::uint32_t> partMaterials;
};

/// What becomes an object.
struct LoadedMesh {
    std::vector<LoadedPiece> pieces; ///< mostly one
    std::string shape;               ///< ShapeRequest::id; empty: of a file
    std::filesystem::path file;      ///< canonical
    std::string node{};              ///< of a glTF file with several: the one that shows it
    dmat4 objectFromNode{1.0};
};

class MeshFiles {
public:
    /// The scene has the materials of its own list by now, and no others.
    explicit MeshFiles(const SceneReading& reading);
    /// What the file shows that "mesh" names: of a glTF file each node, or the one that "node" names. Throws Error.
    [[nodiscard]] std::vector<LoadedMesh> named(const JsonObject& keys, NormalMode mode);
    /// Those of loading, with the texels of all images so far.
    [[nodiscard]] const Limits& limits() const { return limits_; }

private:
    [[nodiscard]] std::vector<LoadedMesh> loadedObj(const ReferredFile& file, NormalMode mode, const LoadOptions& options);
    [[nodiscard]] LoadedPiece loadedPiece(const std::filesystem::path& canonical, const ObjFile& file, const MaterialsByName& known, Mesh mesh);
    [[nodiscard]] std::vector<LoadedMesh> loadedGltf(const ReferredFile& file, NormalMode mode, const LoadOptions& options);
    void addNotes(std::vector<std::string> notes);
    std::uint32_t materialOfFile(const std::filesystem::path& canonical, const Material& fromFile);
    void countTexels(const Material& material);

    const SceneReading& reading_;
    Limits limits_;
    std::set<const void*> counted_;       ///< masks and colour images; materials may share one
    std::set<std::string> materialNames_; ///< of all of the scene so far
    std::map<std::pair<std::string, NormalMode>, std::vector<LoadedMesh>> files_; ///< by canonical path
    std::map<std::pair<std::string, std::string>, std::uint32_t> materialOfFile_; ///< by canonical path and the file's name for it
};

} // namespace shadowlab::scene
