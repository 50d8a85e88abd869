// An OBJ file from text to mesh: read, scan strictly, let tinyobjloader parse, build.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/obj/obj_mesh.h"
#include "techniques/foundation/scene/obj/outliers.h"
#include "techniques/foundation/scene/obj/statement_lines.h"
#include "techniques/foundation/scene/query/rough_number.h"

namespace shadowlab::scene {

namespace {

/// A part without a material of its own would be drawn in grey, and hide the colours of its vertices: it gets a white one.
void giveColoredPartsMaterials(ObjFile& obj, Mesh& mesh) {
    if (mesh.colors.empty()) return;
    const MaterialsByName known = materialsByName(obj.materials);
    std::vector<Material> added;
    for (MeshPart& part : mesh.parts) {
        if (!part.materialName.empty() && known.contains(part.materialName)) continue;
        if (part.materialName.empty()) part.materialName = "vertex colours";
        if (known.contains(part.materialName)) continue; // of another piece
        Material& material = added.emplace_back();
        material.name = part.materialName;
        material.diffuse = vec3(1.0f);
    }
    obj.materials.insert(obj.materials.end(), added.begin(), added.end());
}

/// Notes on parts that a mask leaves whole, each once.
void noteWholeParts(const std::string& name, const MaterialsByName& known, const Mesh& mesh, ObjFile& obj) {
    for (const MeshPart& part : mesh.parts) {
        const auto found = known.find(part.materialName);
        const std::string note = found == known.end() ? "" : noteOnWholePart(obj.materials[found->second], part);
        if (!note.empty() && std::ranges::find(obj.notes, name + ": " + note) == obj.notes.end()) obj.notes.push_back(name + ": " + note);
    }
}

/// Vertices that faces use far from where most are.
void findOutliers(const ObjScan& scan, const ObjFaces& faces, Mesh& mesh) {
    const auto cornerAt = [&](std::size_t i) { return scan.positions[faces.corners[i].position]; };
    const CommonPlace place(faces.corners.size(), cornerAt);
    std::vector<std::uint32_t> found;
    for (const ObjCorner& corner : faces.corners)
        if (place.isFar(scan.positions[corner.position])) found.push_back(corner.position);
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    constexpr std::size_t kMost = 8; // enough to find the others beside them
    mesh.outlierCount = found.size();
    for (std::size_t i = 0; i < std::min(found.size(), kMost); ++i)
        mesh.outliers.push_back({found[i] + 1u, 0, place.distanceTo(scan.positions[found[i]])});
}

/// Lines are counted only here, in the file read once more: most meshes have no use for them.
void findLines(const std::filesystem::path& file, const Limits& limits, std::vector<MeshOutlier>& outliers) {
    const std::string text = utf8Text(readFile(file, limits.fileBytes, "mesh-file"), file);
    StatementLines lines(text, file, limits.lineBytes);
    std::uint64_t vertex = 0;
    auto next = outliers.begin();
    while (next != outliers.end() && lines.nextStatement())
        if (lines.keyword() == "v" && ++vertex == next->vertex) (next++)->line = lines.line();
}

std::string noteOnOutliers(const std::string& name, const Mesh& mesh) {
    const MeshOutlier& first = mesh.outliers.front();
    const std::uint64_t more = mesh.outlierCount - 1;
    return name + ":" + std::to_string(first.line) + ": vertex " + std::to_string(first.vertex) + " lies " + roughNumber(first.distance) +
           " m from where most others are" + (more > 0 ? ", and so do " + std::to_string(more) + " more" : "") +
           "; remove the faces that use " + (more > 0 ? "them if they are" : "it if it is") +
           " left over, since shadow maps have to reach as far and get coarse";
}

/// Notes on the mesh: the user should know about these faults, but need not fix them.
void addNotes(const ObjScan& scan, const std::filesystem::path& file, ObjFile& obj) {
    const std::string name = shownPath(file);
    obj.notes.insert(obj.notes.end(), scan.notes.begin(), scan.notes.end());
    if (obj.mesh.droppedTriangles > 0)
        obj.notes.push_back(name + ": dropped " + counted(obj.mesh.droppedTriangles, "degenerate triangle"));
    if (scan.unusableNormals > 0)
        obj.notes.push_back(name + ":" + std::to_string(scan.unusableNormalLine) + ": " +
                            counted(scan.unusableNormals, "normal") +
                            " (vn) without a direction; flat normals are used there");
    if (scan.colorsInBytes > 0)
        obj.notes.push_back(name + ":" + std::to_string(scan.colorsInBytes) + ": vertex colours above 1 are taken to count to 255");
    const MaterialsByName known = materialsByName(obj.materials);
    noteWholeParts(name, known, obj.mesh, obj);
    for (const Mesh& piece : obj.furtherPieces)
        noteWholeParts(name, known, piece, obj);
    if (!obj.mesh.outliers.empty()) obj.notes.push_back(noteOnOutliers(name, obj.mesh));
    // Below this size float squares underflow in shaders, and below 1e-38 floats lose their digits.
    constexpr float kTiny = 1e-15f;
    vec3 lower(1e30f), upper(-1e30f);
    for (const vec3& position : obj.mesh.positionsMesh) {
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
    }
    const vec3 extent = upper - lower;
    if (const float size = glm::max(extent.x, glm::max(extent.y, extent.z)); size < kTiny)
        obj.notes.push_back(name + ": the mesh is only " + numberText(size) +
                            " m across, too small for the graphics card; scale it up");
}

/// Judges by the size of the file, before it is read. A file without a size is refused by readFile.
void requireMemoryForObj(const std::filesystem::path& file, const Limits& limits) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return;
    const std::uint64_t bytes = std::filesystem::file_size(file, ignored);
    if (ignored || bytes > limits.fileBytes) return;
    if (const std::uint64_t needed = memoryForMeshFile(bytes, limits); needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, shownPath(file) + ": to read " + counted(bytes, "byte") + ", " +
                                               beyondMemory(needed, limits.memoryBytes) +
                                               "; simplify the model, or set --limit memory=VALUE");
}

} // namespace

MaterialsByName materialsByName(const std::vector<Material>& materials) {
    MaterialsByName byName;
    for (std::uint32_t i = 0; i < materials.size(); ++i)
        byName.try_emplace(materials[i].name, i);
    return byName;
}

ObjFile loadObj(const std::filesystem::path& file, NormalMode mode, const LoadOptions& options) {
    requireMemoryForObj(file, options.limits);
    ObjScan scan = scanObj(utf8Text(readFile(file, options.limits.fileBytes, "mesh-file"), file), file, options.limits);
    image::keepInput(file);
    ObjFaces faces = readFaces(scan, file, options);
    ObjFile obj;
    std::vector<Mesh> meshes = buildMeshes(scan, faces, mode);
    std::uint32_t dropped = 0;
    for (Mesh& piece : meshes)
        dropped += std::exchange(piece.droppedTriangles, 0u);
    std::erase_if(meshes, [](const Mesh& piece) { return piece.triangles.empty(); });
    if (meshes.empty())
        throw Error(ExitStatus::badInput, shownPath(file) + ":1: all " + counted(dropped, "triangle") +
                                              " of the file are degenerate (no area); export the mesh again");
    obj.mesh = std::move(meshes.front());
    obj.mesh.droppedTriangles = dropped;
    obj.furtherPieces.assign(std::move_iterator(meshes.begin() + 1), std::move_iterator(meshes.end()));
    findOutliers(scan, faces, obj.mesh);
    if (!obj.mesh.outliers.empty()) findLines(file, options.limits, obj.mesh.outliers);
    obj.materials = std::move(faces.materials);
    obj.notes = std::move(faces.notes);
    giveColoredPartsMaterials(obj, obj.mesh);
    for (Mesh& piece : obj.furtherPieces)
        giveColoredPartsMaterials(obj, piece);
    addNotes(scan, file, obj);
    return obj;
}

} // namespace shadowlab::scene
