// SPDX-License-Identifier: MIT
#include "app/cli/inspection.h"

#include <algorithm>
#include <set>
#include <span>
#include <unordered_map>

#include "app/cli/common_options.h"
#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

double largest(const dvec3& size) { return glm::max(size.x, glm::max(size.y, size.z)); }

/// Size of a mesh of its own, or of an object in the world.
dvec3 sizeOf(const scene::Object& object) {
    const scene::Bounds bounds = scene::boundsWorld(object);
    return bounds.isEmpty() ? dvec3(0.0) : bounds.upperWorld - bounds.lowerWorld;
}

Scale scaleOf(double metres) {
    if (metres < kTinyMetres) return Scale::tiny;
    return metres > kHugeMetres ? Scale::huge : Scale::ordinary;
}

InspectedMesh inspectMesh(const std::string& name, const std::shared_ptr<const scene::Mesh>& mesh) {
    InspectedMesh inspected;
    inspected.name = name;
    inspected.mesh = mesh;
    inspected.report = scene::reportMesh(*mesh, scene::buildTopology(*mesh));
    inspected.outward = mesh->outward;
    scene::Object unmoved;
    unmoved.mesh = mesh;
    inspected.sizeMetres = sizeOf(unmoved);
    inspected.originOffset = mesh->originObject;
    return inspected;
}

void addObjects(Inspection& inspection, const scene::Scene& scene) {
    std::unordered_map<const scene::Mesh*, std::size_t> known;
    for (const scene::Object& object : scene.objects) {
        if (object.emitterOfLight >= 0) continue; // not the user's, and no technique's concern
        const auto [entry, isNew] = known.try_emplace(object.mesh.get(), inspection.meshes.size());
        if (isNew) inspection.meshes.push_back(inspectMesh(object.name, object.mesh));
        InspectedMesh& mesh = inspection.meshes[entry->second];
        mesh.objects.push_back(object.name);
        mesh.report.hasHoles |= scene::hasHoles(scene, object);
        mesh.largestInWorld = glm::max(mesh.largestInWorld, largest(sizeOf(object)));
        mesh.scale = scaleOf(mesh.largestInWorld);
        inspection.triangles += object.mesh->triangles.size();
    }
}

SceneContent contentOf(const scene::Scene& scene) {
    SceneContent content;
    for (const scene::Object& object : scene.objects) {
        if (object.emitterOfLight >= 0) continue;
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
            const std::string sentence = technique->remark(meshes[i].report, *meshes[i].mesh);
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
    scene::Object object;
    object.name = name;
    const scene::MaterialsByName known = scene::materialsByName(scene.materials);
    for (const scene::MeshPart& part : obj.mesh.parts) {
        const auto found = known.find(part.materialName);
        const bool isKnown = found != known.end();
        object.partMaterials.push_back(isKnown ? found->second
                                               : static_cast<std::uint32_t>(scene.materials.size()) - 1);
    }
    object.mesh = scene::sharedMesh(std::move(obj.mesh));
    scene.objects.push_back(std::move(object));
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

Inspection inspectFile(const std::string& file, const std::vector<std::filesystem::path>& allowed) {
    const scene::LoadOptions loading = loadOptions(allowed);
    Inspection inspection;
    inspection.file = file;
    std::vector<scene::Material> materials;
    std::set<std::string> withColors;
    std::size_t lampMaterials = 0;
    if (isMeshFile(file)) { // itself, not staged: floor and light are not its own
        scene::ObjFile obj = scene::loadObj(file, scene::NormalMode::file, loading);
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
        scene::GltfFile gltf = scene::loadGltf(file, scene::NormalMode::file, loading);
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
