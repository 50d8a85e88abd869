// Area lights are seen by eye rays: each gets an object that shines with the light's radiance and blocks nothing.
// SPDX-License-Identifier: MIT
#include <map>

#include "techniques/foundation/scene/load.h"

namespace shadowlab::scene {

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
        material.emission = vec3(dvec3(light.color) * light.intensity);
        const auto next = static_cast<std::uint32_t>(scene.materials.size());
        const auto [entry, isNew] = materialOfLight.try_emplace(static_cast<int>(i), next);
        if (isNew)
            scene.materials.push_back(material);
        else
            scene.materials[entry->second] = material;

        Object object;
        object.name = name;
        constexpr int kSegments = 64; // the default of the sphere shape
        object.mesh = std::make_shared<const Mesh>(light.type == LightType::rect
                                                       ? makeParallelogram(light.edgeUWorld, light.edgeVWorld)
                                                       : makeSphere(light.radius, kSegments));
        object.worldFromObject[3] = dvec4(light.positionWorld, 1.0);
        object.partMaterials = {entry->second};
        object.castsShadow = false;
        object.receivesShadow = false;
        object.emitterOfLight = static_cast<int>(i);
        scene.objects.push_back(std::move(object));
    }
}

} // namespace shadowlab::scene
