// SPDX-License-Identifier: MIT
#include "tests/support/perforated.h"

#include <algorithm>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

scene::Mesh withRepeats(scene::Mesh mesh, vec2 times) {
    for (vec2& texcoord : mesh.texcoords)
        texcoord *= times;
    return mesh;
}

std::shared_ptr<const scene::AlphaMask> maskOf(const Pattern& pattern) {
    image::PictureFile picture;
    picture.hasAlpha = true;
    picture.image = image::Image(static_cast<int>(pattern.front().size()), static_cast<int>(pattern.size()));
    for (int y = 0; y < picture.image.height; ++y)
        for (int x = 0; x < picture.image.width; ++x) {
            const bool solid = pattern[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
            picture.image.set(x, y, {.a = static_cast<std::uint8_t>(solid ? 255 : 0)});
        }
    return std::make_shared<const scene::AlphaMask>(picture);
}

void perforate(scene::Scene& scene, std::size_t object, const Pattern& pattern) {
    scene::Material material;
    material.name = "perforated " + std::to_string(scene.materials.size());
    material.alphaMap = "in memory";
    material.alphaMask = maskOf(pattern);
    std::ranges::fill(scene.objects[object].partMaterials, static_cast<std::uint32_t>(scene.materials.size()));
    scene.materials.push_back(std::move(material));
}

bool castsThroughHoles(const scene::Scene& scene) {
    return std::ranges::any_of(scene.objects, [&](const scene::Object& object) {
        return object.castsShadow && scene::hasHoles(scene, object);
    });
}

scene::Scene perforatedScene() {
    const Pattern pattern = {"######", "#..#.#", "##.#.#", "#..###", "###..#"};
    scene::Scene scene = floorScene();
    scene.camera.positionWorld = {0.2, 2, 3.8};
    scene.camera.targetWorld = {0.1, 1, 0};
    dmat4 upright(0.0); // from lying, face up, to standing, facing +z
    upright[0][0] = 1;
    upright[1][2] = 1;
    upright[2][1] = -1;
    upright[3] = dvec4(-1.5, 1, 0.3, 1);
    addObject(scene, withRepeats(scene::makeQuad({2, 2}), {2, 1.5}), upright);
    perforate(scene, 1, pattern);
    addObject(scene, scene::makeSphere(0.8, 48), translation({1.2, 0.9, 0.9}));
    perforate(scene, 2, pattern);
    dmat4 mirror = translation({0.3, 1, -1.6});
    mirror[0][0] = -1;
    addObject(scene, withRepeats(scene::makeTorus(1, 0.4, {48, 24}), {-4, 3}), mirror);
    perforate(scene, 3, pattern);
    addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), translation({2.6, 0.25, -0.4}));
    scene.lights.push_back(pointLight({-1, 4, 3}));
    scene.lights.push_back(directionalLight({0.4, -1, -0.5}));
    return scene;
}

} // namespace shadowlab::testing
