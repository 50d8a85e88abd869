// A glTF file from bytes to objects: container, checked JSON, tinygltf, buffers, nodes, materials, meshes.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/load_gltf.h"

#include <algorithm>
#include <map>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/gltf/gltf_container.h"
#include "techniques/foundation/scene/gltf/gltf_lights.h"
#include "techniques/foundation/scene/gltf/gltf_meshes.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// Judges by the number of values in the text, before it is parsed. One value takes up to this much, doubled by growing arrays.
void requireMemoryForJson(const GltfContainer& container, const std::filesystem::path& file, const Limits& limits) {
    constexpr std::uint64_t kBytesPerValue = 2 * (sizeof(JsonValue) + sizeof(std::string));
    constexpr std::uint64_t kCopies = 4; // of the text and of what its strings hold: text, tree, decoded, for tinygltf
    const auto isBeforeValue = [](char c) { return c == ',' || c == '[' || c == '{' || c == ':'; };
    const std::uint64_t values = 1 + static_cast<std::uint64_t>(std::ranges::count_if(container.json, isBeforeValue));
    const std::uint64_t needed =
        memoryForMeshFile(0, limits) + values * kBytesPerValue + kCopies * container.json.size() + container.bytes.size();
    if (needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, shownPath(file) + ": to read " + counted(container.json.size(), "byte") + " of JSON, " +
                                               beyondMemory(needed, limits.memoryBytes) +
                                               "; simplify the model, or set --limit memory=VALUE");
}

Bounds boundsOf(const GltfObject& object) {
    Object placed;
    placed.mesh = object.mesh;
    placed.worldFromObject = object.worldFromNode;
    return boundsWorld(placed);
}

/// A file as it is put together.
class GltfReader {
public:
    GltfReader(const GltfParts& parts, const std::vector<GltfNode>& nodes, const LoadOptions& options)
        : parts_(parts), nodes_(nodes), options_(options) {}

    void readObjects(NormalMode mode, GltfFile& file) {
        countTriangles();
        for (const GltfMaterial& material : parts_.materials)
            file.materials.push_back(material.material);
        std::map<int, GltfMesh> meshes;
        for (const GltfNode& node : nodes_) {
            const int mesh = parts_.model.nodes[node.index].mesh;
            if (mesh < 0) continue;
            const auto [entry, isNew] = meshes.try_emplace(mesh);
            const auto index = static_cast<std::size_t>(mesh);
            if (isNew) entry->second = gltfMesh(parts_, index, primitives_.at(mesh), mode);
            if (!entry->second.mesh) {
                parts_.source.note("meshes", index, "has no triangles to show; it is left out");
                continue;
            }
            if (hasExtent(node)) file.objects.push_back(objectOf(node, entry->second, file));
        }
    }

private:
    void countTriangles() {
        std::uint64_t triangles = 0;
        std::size_t objects = 0;
        for (const GltfNode& node : nodes_) {
            const int mesh = parts_.model.nodes[node.index].mesh;
            if (mesh < 0) continue;
            const auto refuse = [&](const std::string& why, const char* limit) {
                parts_.source.fail("nodes", node.index, why + "; simplify the model, or set --limit " + limit + "=VALUE",
                                   ExitStatus::overLimit);
            };
            const Limits& limits = options_.limits;
            if (++objects > limits.objects) refuse("is one object more than the limit of " + std::to_string(limits.objects), "objects");
            const auto [entry, isNew] = primitives_.try_emplace(mesh);
            if (isNew) entry->second = GltfPrimitive::ofMesh(parts_, static_cast<std::size_t>(mesh));
            for (const GltfPrimitive& primitive : entry->second)
                triangles += primitive.triangleCount();
            if (triangles > limits.triangles)
                refuse("brings the file to " + counted(triangles, "triangle") + ", more than the limit of " +
                           std::to_string(limits.triangles),
                       "triangles");
            if (const std::uint64_t needed = memoryForTriangles(triangles, limits); needed > limits.memoryBytes)
                refuse("brings the file to " + counted(triangles, "triangle") + ", for which " + beyondMemory(needed, limits.memoryBytes),
                       "memory");
        }
    }

    /// False where the node's transform flattens all things: then there is nothing to see, and normals have no direction.
    bool hasExtent(const GltfNode& node) {
        dmat3 axes(node.worldFromNode);
        for (int axis = 0; axis < 3; ++axis) {
            const double length = glm::length(axes[axis]);
            axes[axis] = length > 0 && std::isfinite(length) ? axes[axis] / length : dvec3(0.0);
        }
        // Below this the axes lie in a plane but for the rounding of float, which is what files hold.
        if (std::abs(glm::determinant(axes)) > 1e-7) return true;
        parts_.source.note("nodes", node.index, "is flattened by its transform (a scale of 0?), which cannot be shown; it is left out");
        return false;
    }

    GltfObject objectOf(const GltfNode& node, const GltfMesh& mesh, GltfFile& file) {
        GltfObject object{node.name, mesh.mesh, node.worldFromNode, {}};
        for (std::size_t part = 0; part < mesh.materials.size(); ++part)
            object.partMaterials.push_back(mesh.materials[part] >= 0   ? static_cast<std::uint32_t>(mesh.materials[part])
                                           : mesh.mesh->colors.empty() ? GltfObject::kNoMaterial
                                                                       : materialOfVertexColors(file));
        const Bounds bounds = boundsOf(object);
        const dvec3 farthest = glm::max(glm::abs(bounds.lowerWorld), glm::abs(bounds.upperWorld));
        const double limit = options_.limits.coordinate;
        if (!(glm::max(farthest.x, glm::max(farthest.y, farthest.z)) <= limit))
            parts_.source.fail("nodes", node.index,
                               "reaches beyond " + numberText(limit) + " m from the origin; reduce its scale or translation");
        return object;
    }

    /// A part without a material would be drawn in grey, and hide the colours of its vertices: it gets a white one.
    std::uint32_t materialOfVertexColors(GltfFile& file) {
        if (ofVertexColors_ == GltfObject::kNoMaterial) {
            ofVertexColors_ = static_cast<std::uint32_t>(file.materials.size());
            Material& material = file.materials.emplace_back();
            material.name = "vertex colours";
            material.diffuse = vec3(1.0f);
            material.ofMesh = true;
        }
        return ofVertexColors_;
    }

    const GltfParts& parts_;
    const std::vector<GltfNode>& nodes_;
    const LoadOptions& options_;
    std::map<int, std::vector<GltfPrimitive>> primitives_; ///< of the meshes that are shown
    std::uint32_t ofVertexColors_ = GltfObject::kNoMaterial;
};

} // namespace

GltfFile parseGltf(std::string bytes, const std::filesystem::path& file, NormalMode mode, const LoadOptions& options) {
    GltfContainer container = gltfContainer(std::move(bytes), file);
    requireMemoryForJson(container, file, options.limits);
    const JsonDocument document(std::move(container.json), file, options.limits.jsonDepth, "a glTF 2.0 file, starting with {");
    GltfSource source(document);
    GltfFiles files(file, options);
    const GltfBuffers buffers(source, container, files, options);
    const tinygltf::Model model = tinygltfModel(source);
    checkGltfAccessors(source, model, buffers);
    const std::vector<GltfNode> nodes = gltfNodes(source, model);
    GltfTextures textures(file, source, model, buffers, files, options);
    const std::vector<GltfMaterial> materials = gltfMaterials(source, model, textures);

    GltfFile gltf;
    const GltfParts parts{source, model, buffers, materials};
    GltfReader(parts, nodes, options).readObjects(mode, gltf);
    if (gltf.objects.empty())
        document.fail(0, "has no triangles to show" + (source.notes().first().empty() ? "" : " (" + source.notes().first() + ")") +
                             "; export a model with surfaces");
    gltf.lights = gltfLights(source, model, nodes);
    if (gltf.lights.size() > options.limits.lights)
        document.fail(0,
                      "has " + counted(gltf.lights.size(), "light") + ", more than the limit of " +
                          std::to_string(options.limits.lights) + "; remove some, or set --limit lights=VALUE",
                      ExitStatus::overLimit);
    Bounds bounds;
    for (const GltfObject& object : gltf.objects)
        bounds.include(boundsOf(object));
    gltf.viewpoints = gltfCameras(source, model, nodes, bounds);
    gltf.nodes = model.nodes.size();
    gltf.images = source.elements("images").size();
    source.notes().appendTo(gltf.notes, document);
    files.appendNotesTo(gltf.notes);
    return gltf;
}

GltfFile loadGltf(const std::filesystem::path& file, NormalMode mode, const LoadOptions& options) {
    std::string bytes = readFile(file, options.limits.fileBytes, "mesh-file");
    image::keepInput(file);
    return parseGltf(std::move(bytes), file, mode, options);
}

} // namespace shadowlab::scene
