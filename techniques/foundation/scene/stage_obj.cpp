// A bare mesh made presentable: floor, key light and camera, all in proportion to the mesh, whatever its size.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/load.h"

namespace shadowlab::scene {

namespace {

/// The mesh where it will stand: centred over the origin, its lowest point on y = 0.
struct Stage {
    Bounds meshWorld;
    double size;       ///< largest extent of the mesh; every length below is a multiple of it
    double floorWorld; ///< height of the floor
};

Object placedMesh(ObjFile& obj, Stage& stage) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(std::move(obj.mesh));
    const Bounds bounds = boundsWorld(object);
    const dvec3 extent = bounds.upperWorld - bounds.lowerWorld;
    stage.size = glm::max(extent.x, glm::max(extent.y, extent.z));

    // A sheet lying flat would hide its own shadow: it floats a little.
    const bool isFlat = extent.y < 1e-3 * stage.size;
    const double lift = isFlat ? 0.3 * stage.size : 0.0;
    const dvec3 centre = 0.5 * (bounds.lowerWorld + bounds.upperWorld);
    object.worldFromObject[3] = dvec4(-centre.x, lift - bounds.lowerWorld.y, -centre.z, 1.0);
    stage.meshWorld = boundsWorld(object);
    // Just under the mesh: 1/1024 of its size is too little to see and enough for a 24-bit depth buffer to tell a flat
    // underside from the floor at the distance of this camera.
    stage.floorWorld = -stage.size / 1024.0;
    return object;
}

Object floorUnder(const Stage& stage) {
    Object floor;
    floor.name = "floor";
    const double extent = 40.0 * stage.size; // reaches the horizon of this camera
    floor.mesh = std::make_shared<const Mesh>(makeQuad({extent, extent}));
    floor.worldFromObject[3] = dvec4(0.0, stage.floorWorld, 0.0, 1.0);
    return floor;
}

/// Up, left and in front, as a photographer's key light: the shadow falls to the right and back, in full view.
Light keyLight(const Stage& stage) {
    Light light;
    light.name = "key";
    const dvec3 toLightWorld = glm::normalize(dvec3(-0.55, 1.0, 0.6)); // about 50 degrees high
    const double distance = 4.0 * stage.size; // so far that even a tall mesh throws a shadow shorter than two sizes
    light.positionWorld = 0.5 * (stage.meshWorld.lowerWorld + stage.meshWorld.upperWorld) + distance * toLightWorld;
    // Irradiance 3 makes a white surface that faces the light just not clip (3 * 0.8 / pi = 0.76).
    light.intensity = 3.0 * distance * distance;
    return light;
}

/// From the front right and above, so near that the mesh and its shadow fill the picture.
Camera framing(const Stage& stage, const Light& light) {
    // What has to be seen: the corners of the mesh's box, and their shadows on the floor.
    Bounds wanted = stage.meshWorld;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner = stage.meshWorld.corner(i);
        const double t = (light.positionWorld.y - stage.floorWorld) / (light.positionWorld.y - corner.y);
        wanted.include(light.positionWorld + t * (corner - light.positionWorld));
    }
    Camera camera;
    camera.fovYDegrees = 35.0; // a long lens: little distortion
    camera.targetWorld = 0.5 * (wanted.lowerWorld + wanted.upperWorld);
    const dvec3 backwardWorld = glm::normalize(dvec3(0.35, 0.5, 1.0));
    const dvec3 rightWorld = glm::normalize(glm::cross(camera.upWorld, backwardWorld));
    const dvec3 aboveWorld = glm::cross(backwardWorld, rightWorld);

    // The nearest distance at which every wanted point lies inside a square picture, a tenth of it left as margin.
    const double reach = 0.9 * std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0);
    double distance = 0.0;
    for (const Bounds& box : {wanted, stage.meshWorld})
        for (int i = 0; i < 8; ++i) {
            const dvec3 offset = box.corner(i) - camera.targetWorld;
            const double sideways =
                glm::max(std::abs(glm::dot(offset, rightWorld)), std::abs(glm::dot(offset, aboveWorld)));
            distance = glm::max(distance, glm::dot(offset, backwardWorld) + sideways / reach);
        }
    camera.positionWorld = camera.targetWorld + distance * backwardWorld;
    camera.near = distance / 100.0; // nothing stands that close, and depth precision stays where the mesh is
    return camera;
}

/// Material 0: white, as in every scene; 1: the floor; 2: clay, for parts without a material of their own.
std::vector<std::uint32_t> addMaterials(Scene& scene, const Mesh& mesh, const std::vector<Material>& fromFile) {
    Material floor, clay;
    floor.name = "floor";
    floor.diffuse = vec3(0.75f);
    clay.name = "clay";
    clay.diffuse = vec3(0.72f, 0.62f, 0.52f); // warm, so that the mesh stands out from the grey floor
    scene.materials = {Material{}, floor, clay};
    std::vector<std::uint32_t> partMaterials;
    for (const MeshPart& part : mesh.parts) {
        partMaterials.push_back(2);
        for (const Material& material : fromFile) {
            if (part.materialName.empty() || material.name != part.materialName) continue;
            partMaterials.back() = static_cast<std::uint32_t>(scene.materials.size());
            scene.materials.push_back(material);
            for (int i = 0; i < 3; ++i) // parts have different names, so only the three above can be in the way
                if (scene.materials[i].name == material.name) scene.materials.back().name += " (of the mesh)";
            break;
        }
    }
    return partMaterials;
}

} // namespace

std::shared_ptr<const Scene> stageObj(const std::filesystem::path& file, const LoadOptions& options) {
    ObjFile obj = loadObj(file, NormalMode::file, options);
    const auto scene = std::make_shared<Scene>();
    scene->name = file.stem().string();
    scene->notes = std::move(obj.notes);

    Stage stage{};
    Object object = placedMesh(obj, stage);
    object.name = scene->name;
    object.partMaterials = addMaterials(*scene, *object.mesh, obj.materials);
    Object floor = floorUnder(stage);
    floor.partMaterials = {1};
    scene->lights = {keyLight(stage)};
    scene->camera = framing(stage, scene->lights.front());
    scene->ambient = vec3(0.09f);                  // umbra clearly above black
    scene->background = vec3(0.32f, 0.33f, 0.35f); // neutral, darker than the lit floor
    scene->objects.push_back(std::move(floor));
    scene->objects.push_back(std::move(object));
    addEmitterSurfaces(*scene);
    return scene;
}

} // namespace shadowlab::scene
