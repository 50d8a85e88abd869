// SPDX-License-Identifier: MIT
#include "tests/support/scenes.h"

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::testing {

scene::Mesh triangleSoup(const std::vector<dvec3>& corners) {
    scene::Mesh mesh;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const dvec3 normal = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        const auto first = static_cast<std::uint32_t>(mesh.positionsMesh.size());
        for (std::size_t c = 0; c < 3; ++c) {
            mesh.positionsMesh.emplace_back(corners[i + c]);
            mesh.normalsMesh.emplace_back(glm::length(normal) > 0 ? glm::normalize(normal) : dvec3(0, 1, 0));
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

scene::Object& addObject(scene::Scene& scene, scene::Mesh mesh, const dmat4& worldFromObject) {
    scene::Object object;
    object.name = "object" + std::to_string(scene.objects.size() + 1);
    object.mesh = scene::sharedMesh(std::move(mesh));
    object.worldFromObject = worldFromObject;
    object.partMaterials.assign(object.mesh->parts.size(), 0);
    scene.objects.push_back(std::move(object));
    return scene.objects.back();
}

scene::Scene floorScene() {
    scene::Scene scene;
    scene.name = "test";
    scene.materials.emplace_back();
    scene.ambient = vec3(0.1f);
    scene.camera.positionWorld = {0, 3, 6};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.fovYDegrees = 60;
    addObject(scene, scene::makeQuad({10, 10}));
    return scene;
}

scene::Light pointLight(const dvec3& positionWorld) {
    scene::Light light;
    light.name = "point";
    light.positionWorld = positionWorld;
    light.intensity = 50;
    return light;
}

scene::Light directionalLight(const dvec3& directionWorld) {
    scene::Light light;
    light.name = "sun";
    light.type = scene::LightType::directional;
    light.directionWorld = glm::normalize(directionWorld);
    light.intensity = 2;
    return light;
}

scene::Scene simpleScene() {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({1, 1, 1}), translation({-1.25, 0.5, 0}));
    addObject(scene, scene::makeSphere(0.5, 32), translation({0.25, 0.75, 1}));
    addObject(scene, scene::makeTorus(0.75, 0.25, {32, 16}), translation({1.25, 1, -0.5}));
    scene.lights.push_back(pointLight({2, 5, 3}));
    return scene;
}

scene::Scene everyKindOfLight() {
    using enum scene::LightType;
    scene::Scene scene = simpleScene();
    dmat4 mirror = translation({-1, 1, 1});
    mirror[0][0] = -1.5;
    addObject(scene, scene::makeTorus(0.5, 0.2, {24, 12}), mirror);
    addObject(scene, scene::makeBox({0.6, 0.6, 0.6}), translation({1, 2, 0.5})).castsShadow = false;
    addObject(scene, scene::makeQuad({1.5, 1.5}), translation({-1, 0.4, 2})).receivesShadow = false;
    const scene::Light first = scene.lights[0];
    scene.lights.clear();
    for (const scene::LightType type : {point, directional, spot, rect, sphere}) {
        scene.lights.push_back(first);
        scene.lights.back().type = type;
        scene.lights.back().directionWorld = glm::normalize(dvec3(-0.4, -1, -0.6));
        scene.lights.back().edgeVWorld = {0, 0.3, 1};
    }
    scene.lights.push_back(directionalLight({0, -1, 0})); // along an axis
    scene.lights.push_back(pointLight({0.2, 1e-3, 0.3})); // so near that rays leave it on all sides
    scene.lights.push_back(pointLight({0, 1, 0}));        // within things
    return scene;
}

scene::Scene moved(const scene::Scene& scene, const dvec3& offsetWorld) {
    scene::Scene result = scene;
    result.camera.positionWorld += offsetWorld;
    result.camera.targetWorld += offsetWorld;
    for (scene::Light& light : result.lights)
        light.positionWorld += offsetWorld;
    for (scene::Object& object : result.objects)
        object.worldFromObject[3] += dvec4(offsetWorld, 0);
    return result;
}

scene::Scene scaled(const scene::Scene& scene, double factor) {
    scene::Scene result = scene;
    result.camera.positionWorld *= factor;
    result.camera.targetWorld *= factor;
    result.camera.near *= factor;
    for (scene::Light& light : result.lights)
        light.positionWorld *= factor;
    for (scene::Object& object : result.objects)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                object.worldFromObject[column][row] *= factor;
    return result;
}

dmat4 translation(const dvec3& offset) {
    dmat4 matrix(1.0);
    matrix[3] = dvec4(offset, 1.0);
    return matrix;
}

} // namespace shadowlab::testing
