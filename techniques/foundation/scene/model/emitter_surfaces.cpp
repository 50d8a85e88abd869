// Area lights are seen by eye rays: each gets an object that shines with the light's radiance and blocks nothing.
// SPDX-License-Identifier: MIT
#include <map>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

namespace {

vec3 emissionOf(const Light& light) { return vec3(dvec3(light.color) * light.intensity); }

/// The surface of an area light about its centre.
std::shared_ptr<const Mesh> surfaceOf(const Light& light) {
    constexpr int kSegments = 64; // the default of the sphere shape
    return std::make_shared<const Mesh>(light.type == LightType::rect
                                            ? makeParallelogram(light.edgeUWorld, light.edgeVWorld)
                                            : makeSphere(light.radius, kSegments));
}

dmat4 atPosition(const Light& light) {
    dmat4 worldFromObject(1.0);
    worldFromObject[3] = dvec4(light.positionWorld, 1.0);
    return worldFromObject;
}

bool sameShape(const Light& a, const Light& b) {
    return a.edgeUWorld == b.edgeUWorld && a.edgeVWorld == b.edgeVWorld && a.radius == b.radius;
}

} // namespace

void addEmitterSurfaces(Scene& scene) {
    // Surfaces of an earlier call (before the lights moved) go; their materials are used again.
    std::map<int, std::uint32_t> materialOfLight;
    for (const Object& object : scene.objects)
        if (object.emitterOfLight >= 0) materialOfLight[object.emitterOfLight] = object.partMaterials.front();
    std::erase_if(scene.objects, [](const Object& object) { return object.emitterOfLight >= 0; });

    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!hasArea(light)) continue;
        const std::string name = light.name + " (surface)";

        // A black body that shines: it reflects nothing, its radiance is the light's.
        Material material;
        material.name = name;
        material.diffuse = vec3(0.0f);
        material.emission = emissionOf(light);
        // A sphere has no back to be seen, but an eye within it sees the lamp, too.
        material.emits = light.type == LightType::rect ? EmittingSides::front : EmittingSides::both;
        const auto next = static_cast<std::uint32_t>(scene.materials.size());
        const auto [entry, isNew] = materialOfLight.try_emplace(static_cast<int>(i), next);
        if (isNew)
            scene.materials.push_back(material);
        else
            scene.materials[entry->second] = material;

        Object object;
        object.name = name;
        object.mesh = surfaceOf(light);
        object.worldFromObject = atPosition(light);
        object.partMaterials = {entry->second};
        object.castsShadow = false;
        object.receivesShadow = false;
        object.emitterOfLight = static_cast<int>(i);
        scene.objects.push_back(std::move(object));
    }
}

Snapshot withLights(const Snapshot& snapshot, std::vector<Light> lights) {
    if (lights == snapshot->lights) return snapshot;
    const auto scene = std::make_shared<Scene>(*snapshot);
    scene->lights = std::move(lights);
    scene->revisions.lights = newRevision();
    for (Object& object : scene->objects) {
        if (object.emitterOfLight < 0) continue;
        const auto light = static_cast<std::size_t>(object.emitterOfLight);
        const Light &before = snapshot->lights[light], &after = scene->lights[light];
        if (!sameShape(before, after)) {
            object.mesh = surfaceOf(after);
            object.worldFromObject = atPosition(after); // without the turn that an orbit may have given the old mesh
            scene->revisions.geometry = newRevision();
            scene->revisions.transforms = newRevision();
        } else if (before.positionWorld != after.positionWorld) {
            object.worldFromObject[3] = dvec4(after.positionWorld, 1.0);
            scene->revisions.transforms = newRevision();
        }
        vec3& emission = scene->materials[object.partMaterials.front()].emission;
        if (emission != emissionOf(after)) {
            emission = emissionOf(after);
            scene->revisions.materials = newRevision();
        }
    }
    return scene;
}

} // namespace shadowlab::scene
