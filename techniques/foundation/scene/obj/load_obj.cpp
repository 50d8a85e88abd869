// An OBJ file from text to mesh: read, scan strictly, let tinyobjloader parse, build.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/obj/obj_mesh.h"

namespace shadowlab::scene {

namespace {

/// A part without a material of its own would be drawn in grey, and hide the colours of its vertices: it gets a white one.
void giveColoredPartsMaterials(ObjFile& obj) {
    if (obj.mesh.colors.empty()) return;
    const MaterialsByName known = materialsByName(obj.materials);
    std::vector<Material> added;
    for (MeshPart& part : obj.mesh.parts) {
        if (!part.materialName.empty() && known.contains(part.materialName)) continue;
        if (part.materialName.empty()) part.materialName = "vertex colours";
        Material& material = added.emplace_back();
        material.name = part.materialName;
        material.diffuse = vec3(1.0f);
    }
    obj.materials.insert(obj.materials.end(), added.begin(), added.end());
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
    for (const MeshPart& part : obj.mesh.parts)
        if (const auto found = known.find(part.materialName); found != known.end())
            if (const std::string note = noteOnWholePart(obj.materials[found->second], part); !note.empty())
                obj.notes.push_back(name + ": " + note);
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
    obj.mesh = buildMesh(scan, faces);
    if (obj.mesh.triangles.empty())
        throw Error(ExitStatus::badInput, shownPath(file) + ":1: all " +
                                              counted(obj.mesh.droppedTriangles, "triangle") +
                                              " of the file are degenerate (no area); export the mesh again");
    if (mode != NormalMode::file) obj.mesh = withNormals(obj.mesh, mode);
    obj.materials = std::move(faces.materials);
    obj.notes = std::move(faces.notes);
    giveColoredPartsMaterials(obj);
    addNotes(scan, file, obj);
    return obj;
}

} // namespace shadowlab::scene
