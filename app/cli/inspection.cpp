// SPDX-License-Identifier: MIT
#include "app/cli/inspection.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <unordered_map>

#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/load/scene_file.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/object_pieces.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/obj/common_vertices.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

double largest(const dvec3& size) { return glm::max(size.x, glm::max(size.y, size.z)); }

dvec3 sizeOf(const scene::Bounds& bounds) { return bounds.isEmpty() ? dvec3(0.0) : bounds.upperWorld - bounds.lowerWorld; }

using Pieces = scene::CommonVertices::Pieces;

/// A float of 24 bits is followed by the next one 2^-23 of its leading power of two later.
double largestStep(const scene::CommonVertices& vertices) {
    float largest = 0;
    vertices.each([&](const dvec3&, const vec3& positionMesh) {
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(positionMesh[axis]));
    });
    return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0.0;
}

/// Adds what is found of one more piece to what was found of others; `edges` gets the lengths of its edges.
void addPiece(scene::MeshReport& report, const scene::Mesh& mesh, std::vector<double>& edges) {
    const scene::MeshTopology topology = scene::buildTopology(mesh);
    const scene::MeshReport more = scene::reportMesh(mesh, topology);
    for (const MeshCount& count : kMeshCounts)
        report.*count.value += more.*count.value;
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
    const scene::CommonVertices common(pieces);
    inspected.sizeWithoutOutliers = pieces.front()->outlierCount > 0 ? sizeOf(common.bounds(dmat4(1.0))) : inspected.sizeMetres;
    inspected.stepMetres = largestStep(common);
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
        mesh.largestInWorld = glm::max(mesh.largestInWorld, largest(sizeOf(scene::CommonVertices(pieces).bounds(object.worldFromObject))));
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
    content.cameras = 1 + content.views.size();
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

} // namespace

Inspection inspectFile(const std::string& file, const scene::LoadOptions& loading) {
    Inspection inspection;
    inspection.file = file;
    std::vector<scene::Material> materials;
    std::set<std::string> withColors;
    std::size_t lampMaterials = 0;
    const scene::FileKind kind = scene::fileKind(file);
    if (kind == scene::FileKind::obj) { // itself, not staged: floor and light are not its own
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
    } else if (kind == scene::FileKind::gltf) {
        scene::GltfFile gltf = scene::loadGltf(file, loading.normals.value_or(scene::NormalMode::file), loading);
        inspection.kind = "gltf";
        inspection.name = std::filesystem::path(file).stem().string();
        inspection.notes = std::move(gltf.notes);
        const std::size_t nodes = gltf.nodes, images = gltf.images;
        materials = gltf.materials;
        const scene::Scene scene = alone(std::move(gltf));
        inspection.scene = contentOf(scene);
        inspection.scene->cameras = inspection.scene->views.size(); // all of them are views
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
