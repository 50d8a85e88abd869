// A scene written down and read again is the same scene, number by number.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/model/edit_scene.h"
#include "techniques/foundation/scene/model/holes.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

using Texels = std::vector<std::uint8_t>;
const std::filesystem::path kAssets = std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "assets";

/// Counts what it has compared, so that an empty comparison is seen.
int expectSame(const Scene& a, const Scene& b) {
    int compared = 0;
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.background, b.background);
    EXPECT_EQ(a.exposure, b.exposure);
    EXPECT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < std::min(a.lights.size(), b.lights.size()); ++i, ++compared)
        EXPECT_EQ(b.lights[i], a.lights[i]) << a.lights[i].name;
    EXPECT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < std::min(a.objects.size(), b.objects.size()); ++i, ++compared) {
        const Object &x = a.objects[i], &y = b.objects[i];
        EXPECT_EQ(x.name, y.name);
        EXPECT_EQ(x.worldFromObject, y.worldFromObject) << x.name;
        EXPECT_EQ(x.castsShadow, y.castsShadow);
        EXPECT_EQ(x.receivesShadow, y.receivesShadow);
        EXPECT_EQ(x.velocityWorld, y.velocityWorld);
        EXPECT_EQ(x.emitterOfLight, y.emitterOfLight);
        EXPECT_EQ(x.mesh->originObject, y.mesh->originObject) << x.name;
        EXPECT_EQ(x.mesh->positionsMesh, y.mesh->positionsMesh) << x.name;
        EXPECT_EQ(x.mesh->normalsMesh, y.mesh->normalsMesh) << x.name;
        EXPECT_EQ(x.mesh->texcoords, y.mesh->texcoords) << x.name;
        EXPECT_EQ(x.mesh->triangles, y.mesh->triangles) << x.name;
        EXPECT_EQ(x.partMaterials.size(), y.partMaterials.size());
        for (std::size_t p = 0; p < std::min(x.partMaterials.size(), y.partMaterials.size()); ++p) {
            const Material &m = a.materials[x.partMaterials[p]], &n = b.materials[y.partMaterials[p]];
            EXPECT_EQ(m.diffuse, n.diffuse) << x.name << ": " << m.name << ", " << n.name;
            EXPECT_EQ(m.specular, n.specular);
            EXPECT_EQ(m.shininess, n.shininess);
            EXPECT_EQ(m.emission, n.emission);
            EXPECT_EQ(m.emits, n.emits);
            EXPECT_EQ(m.ior, n.ior);
            EXPECT_EQ(m.priority, n.priority);
            EXPECT_EQ(m.transparency, n.transparency);
            EXPECT_EQ(m.alphaMap, n.alphaMap);
            EXPECT_EQ(m.alphaMask ? m.alphaMask->texels() : Texels{}, n.alphaMask ? n.alphaMask->texels() : Texels{});
        }
    }
    return compared;
}

/// Written into `folder`, with what it needs allowed, and read again.
std::shared_ptr<const Scene> again(const Scene& scene, const Camera& camera, const TempFolder& folder) {
    const LoadOptions options{
        .assetsRoot = kAssets, .allowed = foldersToAllow(scene, folder.path(), kAssets), .limits = {}};
    return loadScene(folder.write("again.json", sceneText(scene, camera, folder.path())).string(), options);
}

TEST(WriteScene, EveryBuiltInSceneComesBackFromAnotherFolder) {
    int compared = 0;
    for (const std::string& name : builtInScenes(kAssets)) {
        const TempFolder folder;
        const auto scene = loadScene(name, {.assetsRoot = kAssets, .allowed = {}, .limits = {}});
        EXPECT_TRUE(foldersToAllow(*scene, folder.path(), kAssets).empty()) << "models are among the assets";
        const auto back = again(*scene, scene->camera, folder);
        EXPECT_EQ(back->camera, scene->camera) << name;
        compared += expectSame(*scene, *back);
    }
    EXPECT_GT(compared, 50);
}

TEST(WriteScene, EveryKeyOfTheFormatComesBack) {
    const TempFolder folder;
    const std::vector<std::uint8_t> png = image::encodePng(image::Image(2, 1), {.opaque = false, .text = {}});
    folder.write("leaf.png", {png.begin(), png.end()});
    folder.write("part/tri.obj",
                 "mtllib tri.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl green\nf 1 2 3\nf 1 3 4\n");
    folder.write("part/tri.mtl", "newmtl green\nKd 0.1 0.7 0.2\n");
    const auto file = folder.write("all.json", R"({
      "camera": {"position": [3.1, 1e-12, 1000005], "target": [0, 0.6, 1000000], "up": [0, 1, 0.25], "fovYDegrees": 33.3,
                 "near": 0.01, "far": 77.7},
      "ambient": [0.05, 0.1, 0.15], "background": [0.1, 0.123456789, 0.12], "exposure": 1.7,
      "lights": [
        {"name": "a \"quoted\" one", "type": "point", "position": [2, 5, 3], "color": [1, 0.3, 0.1], "intensity": 40.5},
        {"type": "directional", "direction": [-0.3, -1, -0.2], "intensity": 0.1},
        {"name": "lämp", "type": "spot", "position": [0, 4, 0], "direction": [0.1, -1, 0], "coneDegrees": 61.7,
         "edgeDegrees": 5, "intensity": 40},
        {"type": "rect", "position": [0, 4, 0], "edgeU": [1, 0, 0.2], "edgeV": [0, 0, 1], "intensity": 10},
        {"type": "sphere", "position": [0.1, 4, 0], "radius": 0.35, "intensity": 10}],
      "materials": {"white": {"diffuse": [0.7, 0.7, 0.7]},
        "odd \\ name": {"diffuse": [0.2, 0.3, 0.4], "specular": [0.5, 0.5, 0.5], "shininess": 77.7, "reflectivity": 0.25,
          "transparency": 0.5, "ior": 1.33, "priority": 3, "glossDegrees": 2.5, "translucencyDegrees": 4.5,
          "emission": [1, 2, 3], "emits": "both", "alphaMap": "leaf.png"}},
      "objects": [
        {"name": "floor", "shape": "quad", "size": [12.5, 0.1]},
        {"shape": "box", "size": [1, 2, 0.3], "translate": [0.1, 1e6, -3], "rotateDegrees": [10, 90, -33.3],
         "scale": [1, -2, 0.5], "material": "odd \\ name"},
        {"shape": "sphere", "radius": 0.3, "segments": 17, "normals": "flat", "castsShadow": false},
        {"shape": "torus", "radii": [1, 0.3], "segments": [12, 7], "receivesShadow": false, "velocity": [1, 0, -0.5]},
        {"mesh": "part/tri.obj", "scale": 3.3, "normals": "smooth"},
        {"mesh": "part/tri.obj", "material": "odd \\ name"}]})");
    const auto scene = loadScene(file.string(), {});
    const TempFolder elsewhere;
    EXPECT_EQ(foldersToAllow(*scene, folder.path(), kAssets).size(), 0u);
    EXPECT_EQ(foldersToAllow(*scene, elsewhere.path(), kAssets).size(), 2u) << "of the mesh and of the image";
    for (const TempFolder* to : {&folder, &elsewhere}) {
        const auto back = again(*scene, scene->camera, *to);
        EXPECT_EQ(back->camera, scene->camera);
        EXPECT_EQ(expectSame(*scene, *back), 13);
    }
}

TEST(WriteScene, AStagedMeshComesBackWithItsStage) {
    const TempFolder folder;
    const auto file = folder.write("tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.3\nf 1 2 3\n");
    const auto scene = loadScene(file.string(), {});
    const auto back = again(*scene, scene->camera, folder);
    EXPECT_EQ(expectSame(*scene, *back), 3);
    EXPECT_EQ(back->camera, scene->camera);
}

TEST(WriteScene, AStagedMeshKeepsItsHoles) {
    const TempFolder folder;
    const auto scene = loadScene((kAssets / "models" / "screen.obj").string(), {});
    const auto back = again(*scene, scene->camera, folder);
    EXPECT_EQ(expectSame(*scene, *back), 3);
    EXPECT_TRUE(hasHoles(*scene, scene->objects[1]));
    EXPECT_TRUE(hasHoles(*back, back->objects[1]));
    EXPECT_TRUE(scene->notes.empty());
}

// The surface of a light is made again when the light is read. Written down beside it, it would be there once more each
// time, under one name, and that is an error.
TEST(WriteScene, WhatIsWrittenTwiceIsTheSameAsOnce) {
    const TempFolder folder;
    const auto scene = loadScene(folder
                                     .write("s.json", R"({"camera": {"position": [3, 2, 5], "target": [0, 0, 0]},
      "lights": [{"name": "panel", "type": "rect", "position": [0, 4, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1]},
                 {"name": "bulb", "type": "sphere", "position": [0, 4, 0], "radius": 0.5}],
      "objects": [{"shape": "quad", "size": [5, 5]}]})")
                                     .string(),
                                 {});
    const std::string once = sceneText(*scene, scene->camera, folder.path());
    const auto back = again(*scene, scene->camera, folder);
    EXPECT_EQ(sceneText(*back, back->camera, folder.path()), once);
    EXPECT_EQ(back->materials.size(), scene->materials.size());
    EXPECT_EQ(once.find("surface"), std::string::npos) << once;
}

TEST(WriteScene, WhatWasMovedIsWrittenWhereItIs) {
    const TempFolder folder;
    const auto scene = loadScene(folder
                                     .write("s.json", R"({"camera": {"position": [3, 2, 5], "target": [0, 0, 0]},
      "lights": [{"type": "rect", "position": [0, 4, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1]}],
      "objects": [{"shape": "box", "size": [1, 1, 1], "translate": [0.1, 0.2, 0.3], "velocity": [0.3, 0, 0]},
                  {"shape": "quad", "size": [5, 5]}]})")
                                     .string(),
                                 {});
    ASSERT_EQ(scene->objects.size(), 3u) << "the light has a surface";
    const Snapshot moved = atTime(withObjectMovedBy(scene, 0, {0.7, 0, -0.1}), 1.3);
    EXPECT_NE(moved->revisions.transforms, scene->revisions.transforms);
    EXPECT_EQ(moved->revisions.geometry, scene->revisions.geometry);
    EXPECT_EQ(moved->revisions.lights, scene->revisions.lights);
    EXPECT_NEAR(moved->objects[0].worldFromObject[3].x, 0.1 + 0.7 + 0.3 * 1.3, 1e-15);
    EXPECT_EQ(moved->objects[1].worldFromObject, scene->objects[1].worldFromObject);
    EXPECT_EQ(scene->objects[0].worldFromObject[3].x, 0.1) << "the scene itself never changes";
    expectSame(*moved, *again(*moved, moved->camera, folder));

    EXPECT_EQ(atTime(scene, 0), scene);
    EXPECT_EQ(withObjectMovedBy(scene, 2, {1, 0, 0}), scene) << "the surface of a light stays with its light";
}

} // namespace
} // namespace shadowlab::scene
