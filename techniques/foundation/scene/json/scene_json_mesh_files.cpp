// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/scene_json_mesh_files.h"

#include <algorithm>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/scene_file.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::scene {

MeshFiles::MeshFiles(const SceneReading& reading) : reading_(reading), limits_(reading.options.limits) {
    for (const Material& material : reading.scene.materials) {
        countTexels(material);
        materialNames_.insert(material.name);
    }
}

void MeshFiles::countTexels(const Material& material) {
    const auto count = [&](const void* image, ivec2 size) {
        if (counted_.insert(image).second) limits_.texels += static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    };
    if (material.alphaMask) count(material.alphaMask.get(), material.alphaMask->size());
    if (material.colorImage) count(material.colorImage.get(), material.colorImage->size());
}

/// Index of a material that a mesh file defines, added to the scene on first use. If the name is taken, the mesh file's
/// name is added to it.
std::uint32_t MeshFiles::materialOfFile(const std::filesystem::path& canonical, const Material& fromFile) {
    const std::string& name = fromFile.name;
    const auto [entry, isNew] = materialOfFile_.try_emplace({canonical.string(), name}, 0);
    if (!isNew) return entry->second;
    Material material = fromFile;
    material.ofMesh = true;
    for (int attempt = 1; materialNames_.contains(material.name); ++attempt)
        material.name = name + " (" + canonical.stem().string() +
                        (attempt == 1 ? std::string() : " no. " + std::to_string(attempt)) + ")";
    entry->second = static_cast<std::uint32_t>(reading_.scene.materials.size());
    materialNames_.insert(material.name);
    countTexels(material);
    reading_.scene.materials.push_back(std::move(material));
    return entry->second;
}

void MeshFiles::addNotes(std::vector<std::string> more) {
    std::vector<std::string>& notes = reading_.scene.notes;
    for (std::string& note : more)
        if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
}

LoadedPiece MeshFiles::loadedPiece(const std::filesystem::path& canonical, const ObjFile& file, const MaterialsByName& known, Mesh mesh) {
    LoadedPiece piece;
    for (const MeshPart& part : mesh.parts) {
        const auto found = part.materialName.empty() ? known.end() : known.find(part.materialName);
        piece.partMaterials.push_back(found == known.end() ? kWhite : materialOfFile(canonical, file.materials[found->second]));
    }
    piece.mesh = sharedMesh(std::move(mesh));
    return piece;
}

std::vector<LoadedMesh> MeshFiles::loadedObj(const ReferredFile& file, NormalMode mode, const LoadOptions& options) {
    ObjFile obj = loadObj(file.path, mode, options);
    LoadedMesh loaded;
    const MaterialsByName known = materialsByName(obj.materials);
    loaded.pieces.push_back(loadedPiece(file.canonical, obj, known, std::move(obj.mesh)));
    for (Mesh& piece : obj.furtherPieces)
        loaded.pieces.push_back(loadedPiece(file.canonical, obj, known, std::move(piece)));
    loaded.file = file.canonical;
    addNotes(std::move(obj.notes));
    return {loaded};
}

/// Its lights and cameras stay out: a scene file says itself how it is lit and seen.
std::vector<LoadedMesh> MeshFiles::loadedGltf(const ReferredFile& file, NormalMode mode, const LoadOptions& options) {
    GltfFile gltf = loadGltf(file.path, mode, options);
    std::vector<LoadedMesh> loaded;
    for (GltfObject& object : gltf.objects) {
        LoadedMesh& mesh = loaded.emplace_back();
        LoadedPiece& whole = mesh.pieces.emplace_back();
        for (const std::uint32_t material : object.partMaterials)
            whole.partMaterials.push_back(
                material == GltfObject::kNoMaterial ? kWhite : materialOfFile(file.canonical, gltf.materials[material]));
        whole.mesh = std::move(object.mesh);
        mesh.file = file.canonical;
        mesh.node = object.name;
        mesh.objectFromNode = object.worldFromNode;
    }
    if (!gltf.lights.empty() || !gltf.viewpoints.empty())
        gltf.notes.push_back(shownPath(file.path) + ": " + counted(gltf.lights.size(), "light") + " and " +
                             counted(gltf.viewpoints.size(), "camera") +
                             " of the file are left out, because the scene has its own; write them there if they are wanted");
    addNotes(std::move(gltf.notes));
    return loaded;
}

std::vector<LoadedMesh> MeshFiles::named(const JsonObject& keys, NormalMode mode) {
    const ReferredFile file = readReference(reading_, keys, "mesh");
    const auto [entry, isNew] = files_.try_emplace({file.canonical.string(), mode});
    if (isNew) {
        LoadOptions options = reading_.options; // the mesh's own references may use the scene's folder too
        options.limits = limits_;
        options.allowed.push_back(reading_.file.parent_path().empty() ? "." : reading_.file.parent_path());
        entry->second = fileKind(file.path) == FileKind::gltf ? loadedGltf(file, mode, options) : loadedObj(file, mode, options);
    }
    if (!keys.find("node")) return entry->second;
    const std::string node = keys.text("node");
    std::vector<std::string> names;
    for (const LoadedMesh& loaded : entry->second) {
        if (!loaded.node.empty() && loaded.node == node) return {loaded};
        names.push_back(loaded.node);
    }
    keys.fail("node", "is " + inQuotes(node) + ", which is no node of that file with a mesh; " +
                          (names.front().empty() ? "only glTF files have nodes: leave it out" : suggestion(node, names)));
}

} // namespace shadowlab::scene
