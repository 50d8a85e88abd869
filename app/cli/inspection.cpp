// SPDX-License-Identifier: MIT
#include "app/cli/inspection.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>

#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/object_pieces.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/obj/outliers.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

double largest(const dvec3& size) { return glm::max(size.x, glm::max(size.y, size.z)); }

dvec3 sizeOf(const scene::Bounds& bounds) { return bounds.isEmpty() ? dvec3(0.0) : bounds.upperWorld - bounds.lowerWorld; }

using Pieces = std::vector<std::shared_ptr<const scene::Mesh>>;

/// Which vertices of a mesh are no outliers, and how large a thing they are.
class CommonVertices {
public:
    explicit CommonVertices(const Pieces& pieces) : pieces_(pieces) {
        if (pieces.front()->outlierCount == 0) return;
        std::vector<dvec3> all;
        for (const auto& piece : pieces)
            for (const vec3& positionMesh : piece->positionsMesh)
                all.push_back(piece->originObject + dvec3(positionMesh));
        place_.emplace(all.size(), [&](std::size_t i) { return all[i]; });
    }
    [[nodiscard]] scene::Bounds bounds(const dmat4& worldFromObject) const {
        scene::Bounds bounds;
        each([&](const dvec3& positionObject, const vec3&) { bounds.include(transformPoint(worldFromObject, positionObject)); });
        return bounds;
    }
    /// A float of 24 bits is followed by the next one 2^-23 of its leading power of two later.
    [[nodiscard]] double largestStep() const {
        float largest = 0;
        each([&](const dvec3&, const vec3& positionMesh) {
            for (int axis = 0; axis < 3; ++axis)
                largest = std::max(largest, std::abs(positionMesh[axis]));
        });
        return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0.0;
    }

private:
    template <typename Take>
    void each(const Take& take) const {
        for (const auto& piece : pieces_)
            for (const vec3& positionMesh : piece->positionsMesh)
                if (const dvec3 positionObject = piece->originObject + dvec3(positionMesh); !place_ || !place_->isFar(positionObject))
                    take(positionObject, positionMesh);
    }
    const Pieces& pieces_;
    std::optional<scene::CommonPlace> place_;
};

/// Adds what is found of one more piece to what was found of others; `edges` gets the lengths of its edges.
void addPiece(scene::MeshReport& report, const scene::Mesh& mesh, std::vector<double>& edges) {
    const scene::MeshTopology topology = scene::buildTopology(mesh);
    const scene::MeshReport more = scene::reportMesh(mesh, topology);
    using Count = std::uint64_t scene::MeshReport::*;
    using Report = scene::MeshReport;
    for (const Count count : {&Report::triangles, &Report::droppedTriangles, &Report::duplicateTriangles, &Report::vertices,
                              &Report::weldedVertices, &Report::edges, &Report::boundaryEdges, &Report::multipleEdges,
                              &Report::inconsistentEdges, &Report::components})
        report.*count += more.*count;
    for (const scene::Edge& edge : topology.edges)
        edges.push_back(glm::length(dvec3(mesh.positionsMesh[edge.a]) - dvec3(mesh.positionsMesh[edge.b])));
}

Scale scaleOf(double metres) {
    if (metres < kTinyMetres) return Scale::tiny;
    return metres > kHugeMetres ? Scale::huge : Scale::ordinary;
}

InspectedMesh inspectMesh(const std::string& name, const Pieces& pieces) {
    InspectedMesh inspected;
    inspected.name = name;
    inspected.pieces = pieces;
    std::vector<double> edges;
    for (const auto& piece : pieces)
        addPiece(inspected.report, *piece, edges);
    if (!edges.empty()) {
        const auto hundredth = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 100);
        std::ranges::nth_element(edges, hundredth);
        inspected.shortestEdge = *hundredth;
    }
    inspected.outward = std::ranges::all_of(pieces, [](const auto& piece) { return piece->outward; });
    scene::Bounds bounds;
    for (const auto& piece : pieces) {
        scene::Object unmoved;
        unmoved.mesh = piece;
        bounds.include(scene::boundsWorld(unmoved));
    }
    inspected.sizeMetres = sizeOf(bounds);
    const CommonVertices common(pieces);
    inspected.sizeWithoutOutliers = pieces.front()->outlierCount > 0 ? sizeOf(common.bounds(dmat4(1.0))) : inspected.sizeMetres;
    inspected.stepMetres = common.largestStep();
    return inspected;
}

void addObjects(Inspection& inspection, const scene::Scene& scene) {
    std::unordered_map<const scene::Mesh*, std::size_t> known;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        inspection.triangles += object.emitterOfLight < 0 ? object.mesh->triangles.size() : 0;
        if (object.emitterOfLight >= 0 || object.isFurtherPiece) continue; // not the user's, and no technique's concern; or counted before
        Pieces pieces;
        for (auto [piece, end] = scene::piecesOf(scene, o); piece < end; ++piece)
            pieces.push_back(scene.objects[piece].mesh);
        const auto [entry, isNew] = known.try_emplace(object.mesh.get(), inspection.meshes.size());
        if (isNew) inspection.meshes.push_back(inspectMesh(object.name, pieces));
        InspectedMesh& mesh = inspection.meshes[entry->second];
        mesh.objects.push_back(object.name);
        for (auto [piece, end] = scene::piecesOf(scene, o); piece < end; ++piece)
            mesh.report.hasHoles |= scene::hasHoles(scene, scene.objects[piece]);
        mesh.largestInWorld = glm::max(mesh.largestInWorld, largest(sizeOf(CommonVertices(pieces).bounds(object.worldFromObject))));
        mesh.scale = scaleOf(mesh.largestInWorld);
    }
}

SceneContent contentOf(const scene::Scene& scene) {
    SceneContent content;
    for (const scene::Object& object : scene.objects) {
        if (object.emitterOfLight >= 0 || object.isFurtherPiece) continue;
        ++content.objects;
        if (!object.castsShadow) content.castNoShadow.push_back(object.name);
        if (!object.receivesShadow) content.receiveNoShadow.push_back(object.name);
    }
    using enum scene::LightType;
    for (const scene::LightType type : {point, directional, spot, rect, sphere})
        content.lights[std::string(toText(type))] = 0;
    for (const scene::Viewpoint& viewpoint : scene.viewpoints)
        content.views.push_back(viewpoint.name);
    for (const scene::Light& light : scene.lights)
        ++content.lights[std::string(toText(light.type))];
    return content;
}

/// Equal sentences of one technique become one remark on several meshes.
std::vector<Remark> remarksOn(const std::vector<InspectedMesh>& meshes) {
    std::vector<Remark> remarks;
    for (const RegisteredTechnique& registered : registeredTechniques()) {
        const auto technique = registered.info->make();
        std::unordered_map<std::string, std::size_t> known;
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const std::string sentence = technique->remark(meshes[i].report, *meshes[i].pieces.front());
            if (sentence.empty()) continue;
            const auto [entry, isNew] = known.try_emplace(sentence, remarks.size());
            if (isNew) remarks.push_back({std::string(registered.info->id), sentence, {}});
            remarks[entry->second].meshes.push_back(i);
        }
    }
    return remarks;
}

/// A mesh as a scene of its own, with nothing else in it.
scene::Scene alone(const std::string& name, scene::ObjFile obj) {
    scene::Scene scene;
    scene.materials = std::move(obj.materials);
    scene.materials.emplace_back(); // of parts whose material no file defines
    const scene::MaterialsByName known = scene::materialsByName(scene.materials);
    const auto add = [&](scene::Mesh mesh) {
        scene::Object& object = scene.objects.emplace_back();
        object.name = name;
        object.isFurtherPiece = scene.objects.size() > 1;
        for (const scene::MeshPart& part : mesh.parts) {
            const auto found = known.find(part.materialName);
            const bool isKnown = found != known.end();
            object.partMaterials.push_back(isKnown ? found->second : static_cast<std::uint32_t>(scene.materials.size()) - 1);
        }
        object.mesh = scene::sharedMesh(std::move(mesh));
    };
    add(std::move(obj.mesh));
    for (scene::Mesh& piece : obj.furtherPieces)
        add(std::move(piece));
    return scene;
}

/// A glTF file as a scene of what is in it, and nothing else.
scene::Scene alone(scene::GltfFile gltf) {
    scene::Scene scene;
    scene.materials = std::move(gltf.materials);
    const auto none = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.emplace_back(); // of parts that have none
    for (scene::GltfObject& from : gltf.objects) {
        scene::Object& object = scene.objects.emplace_back();
        object.name = std::move(from.name);
        object.mesh = std::move(from.mesh);
        object.worldFromObject = from.worldFromNode;
        for (const std::uint32_t material : from.partMaterials)
            object.partMaterials.push_back(material == scene::GltfObject::kNoMaterial ? none : material);
    }
    scene.lights = std::move(gltf.lights);
    scene.viewpoints = std::move(gltf.viewpoints);
    return scene;
}

/// Names of the materials that take the colours of vertices.
std::set<std::string> coloredByVertices(const scene::Scene& scene) {
    std::set<std::string> names;
    for (const scene::Object& object : scene.objects)
        for (std::size_t part = 0; part < object.partMaterials.size(); ++part)
            if (scene::usesVertexColors(scene, object, part)) names.insert(scene.materials[object.partMaterials[part]].name);
    return names;
}

/// Of the materials that shine; surfaces of lights, which the scene does not name, come last and do not count.
std::vector<InspectedEmitter> emittersAmong(const std::vector<scene::Material>& materials, std::size_t ownCount) {
    std::vector<InspectedEmitter> emitters;
    for (const scene::Material& material : std::span(materials).first(ownCount))
        if (material.emission != vec3(0.0f)) emitters.push_back({material.name, material.emits});
    return emitters;
}

bool isMeshFile(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return ending == ".obj";
}

} // namespace

Inspection inspectFile(const std::string& file, const scene::LoadOptions& loading) {
    Inspection inspection;
    inspection.file = file;
    std::vector<scene::Material> materials;
    std::set<std::string> withColors;
    std::size_t lampMaterials = 0;
    if (isMeshFile(file)) { // itself, not staged: floor and light are not its own
        scene::ObjFile obj = scene::loadObj(file, loading.normals.value_or(scene::NormalMode::file), loading);
        inspection.kind = "mesh";
        inspection.name = std::filesystem::path(file).stem().string();
        inspection.notes = std::move(obj.notes);
        materials = obj.materials;
        if (!obj.mesh.colors.empty())
            for (const scene::MeshPart& part : obj.mesh.parts)
                withColors.insert(part.materialName);
        const scene::Scene unstaged = alone(inspection.name, std::move(obj));
        inspection.coinciding = coinciding(unstaged);
        addObjects(inspection, unstaged);
    } else if (scene::isGltfFile(file)) {
        scene::GltfFile gltf = scene::loadGltf(file, loading.normals.value_or(scene::NormalMode::file), loading);
        inspection.kind = "gltf";
        inspection.name = std::filesystem::path(file).stem().string();
        inspection.notes = std::move(gltf.notes);
        const std::size_t nodes = gltf.nodes, images = gltf.images;
        materials = gltf.materials;
        const scene::Scene scene = alone(std::move(gltf));
        inspection.scene = contentOf(scene);
        inspection.scene->nodes = nodes;
        inspection.scene->images = images;
        withColors = coloredByVertices(scene);
        inspection.coinciding = coinciding(scene);
        addObjects(inspection, scene);
    } else {
        const auto scene = scene::loadScene(file, loading);
        inspection.name = scene->name;
        inspection.notes = scene->notes;
        inspection.scene = contentOf(*scene);
        materials = scene->materials;
        withColors = coloredByVertices(*scene);
        lampMaterials = static_cast<std::size_t>(
            std::ranges::count_if(scene->objects, [](const scene::Object& o) { return o.emitterOfLight >= 0; }));
        inspection.coinciding = coinciding(*scene);
        addObjects(inspection, *scene);
    }
    for (const scene::Material& material : materials)
        inspection.materials.push_back({material, withColors.contains(material.name)});
    inspection.emitters = emittersAmong(materials, materials.size() - lampMaterials);
    inspection.remarks = remarksOn(inspection.meshes);
    return inspection;
}

} // namespace shadowlab::cli
