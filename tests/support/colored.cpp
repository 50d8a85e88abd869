// SPDX-License-Identifier: MIT
#include "tests/support/colored.h"

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

std::shared_ptr<const scene::ColorImage> imageOf(const std::vector<vec3>& encoded) {
    image::Image picture(2, static_cast<int>(encoded.size() / 2));
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        const auto byte = [&](float value) { return static_cast<std::uint8_t>(255.0f * value + 0.5f); };
        picture.set(static_cast<int>(i % 2), static_cast<int>(i / 2), {byte(encoded[i].r), byte(encoded[i].g), byte(encoded[i].b), 255});
    }
    return std::make_shared<const scene::ColorImage>(picture);
}

namespace {

/// Index of a new material with the image.
std::uint32_t addImaged(scene::Scene& scene, const scene::ImagePlacement& placement) {
    scene::Material& material = scene.materials.emplace_back();
    material.name = "image " + std::to_string(scene.materials.size());
    material.diffuse = {1.0f, 0.9f, 0.8f};
    material.diffuseMap = "in memory";
    material.colorImage = imageOf({{1, 0.2f, 0.2f}, {0.2f, 1, 0.2f}, {0.2f, 0.2f, 1}, {1, 1, 0.4f}});
    material.colorPlacement = placement;
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

scene::Mesh ballWithColors() {
    scene::Mesh mesh = scene::makeSphere(0.7, 24);
    for (const vec3& normal : mesh.normalsMesh)
        mesh.colors.push_back(0.5f + 0.5f * normal);
    return mesh;
}

} // namespace

scene::Scene coloredScene() {
    scene::Scene scene = floorScene();
    scene.objects[0].partMaterials = {addImaged(scene, {.scale = {3.5, 2.5}, .offset = {0.3, -0.2}, .clamped = false})};
    addObject(scene, scene::makeBox({1, 1, 1}), translation({-1.6, 0.5, 0})).partMaterials = {
        addImaged(scene, {.scale = dvec2(1.6), .offset = dvec2(-0.3), .clamped = true})};
    scene::Material& ofMesh = scene.materials.emplace_back();
    ofMesh.name = "of the mesh";
    ofMesh.ofMesh = true;
    addObject(scene, ballWithColors(), translation({0.4, 0.9, 0.8})).partMaterials = {
        static_cast<std::uint32_t>(scene.materials.size() - 1)};
    addObject(scene, ballWithColors(), translation({2, 0.9, -0.5})).partMaterials = {0};
    addObject(scene, scene::makeBox({0.5, 1.5, 0.5}), translation({0.6, 0.75, -1.2}));
    scene.lights = {pointLight({2.5, 5, 3})};
    scene.lights[0].intensity = 60;
    return scene;
}

} // namespace shadowlab::testing
