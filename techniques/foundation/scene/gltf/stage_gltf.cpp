// A scene of a glTF file alone: with its own lights and cameras, and what it lacks of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/obj/stage.h"
#include "techniques/foundation/scene/query/hidden_lights.h"
#include "techniques/foundation/scene/query/rough_number.h"
#include "techniques/foundation/scene/query/unit_notes.h"

namespace shadowlab::scene {

namespace {

constexpr float kStageAmbient = 0.09f;   // umbra clearly above black
constexpr double kStageIrradiance = 3.0; // makes a white surface that faces the light just not clip: 3 * 0.8 / pi = 0.76

std::vector<dvec3> pointsOf(const std::vector<Object>& objects) {
    std::vector<dvec3> pointsWorld;
    for (const Object& object : objects)
        for (const vec3& positionMesh : object.mesh->positionsMesh)
            pointsWorld.push_back(transformPoint(object.worldFromObject, object.mesh->originObject + dvec3(positionMesh)));
    return pointsWorld;
}

/// The file's materials behind those of the stage; the index of the first.
std::uint32_t addGltfMaterials(Scene& scene, std::vector<Material> materials) {
    scene.materials = stageMaterials();
    const auto first = static_cast<std::uint32_t>(scene.materials.size());
    for (Material& material : materials) {
        for (std::uint32_t i = 0; i < first; ++i)
            if (scene.materials[i].name == material.name) material.name += " (of the mesh)";
        scene.materials.push_back(std::move(material));
    }
    return first;
}

/// Above a model that comes with a camera: beside the camera where that is inside, since a light outside of a room would not come in.
Light lightForCamera(const Stage& stage, const Camera& camera) {
    Light light = keyLight(stage);
    const dvec3 &eye = camera.positionWorld, &lower = stage.meshWorld.lowerWorld, &upper = stage.meshWorld.upperWorld;
    if (glm::any(glm::lessThan(eye, lower)) || glm::any(glm::greaterThan(eye, upper))) return light;
    const dvec3 backwardWorld = glm::normalize(eye - camera.targetWorld);
    const dvec3 rightWorld = glm::normalize(glm::cross(camera.upWorld, backwardWorld));
    const double depth = glm::length(eye - camera.targetWorld);
    light.positionWorld = eye + 0.1 * depth * (glm::cross(backwardWorld, rightWorld) - rightWorld); // above, to the left
    light.intensity = kStageIrradiance * depth * depth;
    return light;
}

/// What reaches the middle of the model, were nothing in the way and every surface turned to the lights.
double irradianceInTheMiddle(const std::vector<Light>& lights, const Stage& stage) {
    const dvec3 middleWorld = 0.5 * (stage.meshWorld.lowerWorld + stage.meshWorld.upperWorld);
    double sum = 0;
    for (const Light& light : lights) {
        // A lamp in the middle lights what stands around it: at least a tenth of the model's size away.
        const double distance = std::max(glm::length(light.positionWorld - middleWorld), 0.1 * stage.size);
        const double share = std::max({light.color.r, light.color.g, light.color.b});
        sum += share * light.intensity / (light.type == LightType::directional ? 1.0 : distance * distance);
    }
    return sum;
}

/// Photometric intensities may be thousands of times what a picture can show: the exposure brings them back.
void setExposure(Scene& scene, const Stage& stage, const std::filesystem::path& file) {
    const double irradiance = irradianceInTheMiddle(scene.lights, stage);
    constexpr double kDarkest = 0.5,
                     kBrightest = 6.0; // a sixth of, and twice what lights a stage: these are as the file's author set them
    if (!(irradiance > 0) || (irradiance >= kDarkest && irradiance <= kBrightest)) return;
    constexpr double kLargest = 65504; // of half floats, in which pictures are before exposure
    scene.exposure = static_cast<float>(std::clamp(kStageIrradiance / irradiance, 1 / kLargest, kLargest));
    scene.notes.push_back(shownPath(file) + ": its lights bring " + roughNumber(irradiance) +
                          " lux to its middle; pictures are exposed by " + roughNumber(static_cast<double>(scene.exposure)) + " for that");
}

} // namespace

std::shared_ptr<const Scene> stagedGltf(GltfFile gltf, const std::filesystem::path& file, const LoadOptions& options) {
    const auto scene = std::make_shared<Scene>();
    scene->name = file.stem().string();
    scene->notes = std::move(gltf.notes);
    const std::uint32_t firstMaterial = addGltfMaterials(*scene, std::move(gltf.materials));
    const bool isBare = gltf.lights.empty() && gltf.viewpoints.empty();
    std::error_code ignored; // it was read a moment ago
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, ignored);
    Bounds bounds;
    for (GltfObject& from : gltf.objects) {
        Object& object = scene->objects.emplace_back();
        object.name = from.name;
        object.mesh = std::move(from.mesh);
        object.worldFromObject = from.worldFromNode;
        for (const std::uint32_t material : from.partMaterials)
            object.partMaterials.push_back(material == GltfObject::kNoMaterial ? kClay : firstMaterial + material);
        object.source.mesh = canonical;
        object.source.objectFromNode = from.worldFromNode;
        if (gltf.objects.size() > 1) object.source.node = from.name;
        bounds.include(boundsWorld(object));
    }
    const dvec3 toStage = isBare ? ontoStage(bounds) : dvec3(0.0);
    Bounds meshWorld;
    for (Object& object : scene->objects) {
        object.source.translateWorld = toStage;
        object.worldFromObject = worldFromObjectOf(object.source);
        meshWorld.include(boundsWorld(object));
    }
    const Stage stage = stageAround(meshWorld, largestExtent(bounds));

    scene->viewpoints = std::move(gltf.viewpoints);
    const Light key = keyLight(stage);
    scene->camera = scene->viewpoints.empty() ? stageFraming(stage, pointsOf(scene->objects), key.positionWorld) : scene->viewpoints.front().camera;
    scene->lights = std::move(gltf.lights);
    if (scene->lights.empty())
        scene->lights = {isBare ? key : lightForCamera(stage, scene->camera)};
    else
        setExposure(*scene, stage, file);
    if (isBare) {
        Object floor = floorUnder(stage);
        floor.partMaterials = {kFloorMaterial};
        scene->objects.insert(scene->objects.begin(), std::move(floor));
    }
    scene->ambient = vec3(kStageAmbient / scene->exposure);
    scene->background = vec3(0.32f, 0.33f, 0.35f) / scene->exposure; // neutral, darker than a lit surface
    addEmitterSurfaces(*scene);
    for (const std::string& note : notesOnHiddenLights(*scene))
        scene->notes.push_back(shownPath(file) + ": " + note);
    if (const std::string note = noteOnUnits(*scene); !note.empty()) scene->notes.push_back(shownPath(file) + ": " + note);
    scene->memory = memoryBudget(*scene, options.limits);
    return scene;
}

} // namespace shadowlab::scene
