// Scenes by name and by path, and meshes on their stage.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/foundation/scene/model/camera.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kScene = R"({"camera": {"position": [0, 1, 5], "target": [0, 0, 0]}})";

TEST(LoadScene, BuiltInScenesAreFoundByName) {
    const TempFolder assets;
    assets.write("scenes/colonnade.json", kScene);
    assets.write("scenes/box.json", kScene);
    assets.write("scenes/readme.txt", "");
    LoadOptions options;
    options.assetsRoot = assets.path();
    EXPECT_EQ(builtInScenes(assets.path()), (std::vector<std::string>{"box", "colonnade"}));
    EXPECT_EQ(loadScene("colonnade", options)->name, "colonnade");
    const Error error = errorOf([&] { (void)loadScene("colonade", options); });
    EXPECT_EQ(error.status(), ExitStatus::badInput);
    EXPECT_TRUE(contains(error.what(), "did you mean \"colonnade\"?")) << error.what();
    EXPECT_TRUE(builtInScenes(assets.path() / "none").empty());
}

TEST(LoadScene, PathsAreToldByTheirEnding) {
    const TempFolder folder;
    EXPECT_EQ(loadScene(folder.write("mine.json", kScene).string(), {})->name, "mine");
    EXPECT_EQ(loadScene(folder.write("MESH.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string(), {})->name, "MESH");
    for (const std::string& path : {folder.write("mesh.ply", "").string(), folder.path().string()}) {
        const Error error = errorOf([&] { (void)loadScene(path, {}); });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_TRUE(contains(error.what(), "neither a .json scene nor a mesh (.obj, .gltf, .glb)")) << error.what();
    }
    EXPECT_TRUE(contains(errorOf([&] { (void)loadScene((folder.path() / "none.json").string(), {}); }).what(),
                         "No such file or directory"));
}

TEST(LoadScene, SceneFilesBeyondTheLimitAreRefused) {
    const TempFolder folder;
    LoadOptions options;
    options.limits.sceneFileBytes = 10;
    const std::string file = folder.write("mine.json", kScene).string();
    EXPECT_EQ(errorOf([&] { (void)loadScene(file, options); }).status(), ExitStatus::overLimit);
}

/// A tetrahedron of the given size, somewhere.
std::string tetrahedron(double size, double offset) {
    char text[300];
    std::snprintf(text, sizeof text, "v %.17g 0 0\nv %.17g 0 0\nv %.17g %.17g 0\nv %.17g 0 %.17g\n", offset,
                  offset + size, offset, size, offset, size);
    return text + std::string("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

TEST(StageObj, FramesTheMeshAtAnySizeAndPlace) {
    const TempFolder folder;
    for (const double size : {1e-3, 1.0, 1e6})
        for (const double offset : {0.0, 1e5 * size}) {
            const auto scene = stageObj(folder.write("t.obj", tetrahedron(size, offset)), {});
            ASSERT_EQ(scene->objects.size(), 2u);
            ASSERT_EQ(scene->lights.size(), 1u);
            EXPECT_EQ(scene->lights[0].name, "key");
            const Bounds mesh = boundsWorld(scene->objects[1]);
            EXPECT_NEAR(mesh.lowerWorld.y, 0.0, 1e-9 * size) << "stands on y = 0";
            EXPECT_NEAR(mesh.upperWorld.y - mesh.lowerWorld.y, size, 1e-6 * size) << "keeps its size";
            const double floor = boundsWorld(scene->objects[0]).upperWorld.y;
            EXPECT_LT(floor, 0.0);
            EXPECT_GT(floor, -0.01 * size);

            // Every corner of the mesh's box, and its shadow on the floor, is in the picture.
            const Camera& camera = scene->camera;
            const dmat4 clipFromWorld = clipFromView(camera, 1.0) * viewFromWorld(camera);
            const dvec3 light = scene->lights[0].positionWorld;
            for (int i = 0; i < 8; ++i) {
                const dvec3 corner = mesh.corner(i);
                const dvec3 shadow = light + (corner - light) * ((light.y - floor) / (light.y - corner.y));
                for (const dvec3& p : {corner, shadow}) {
                    const dvec4 clip = clipFromWorld * dvec4(p, 1.0);
                    EXPECT_LT(std::abs(clip.x), clip.w);
                    EXPECT_LT(std::abs(clip.y), clip.w);
                    EXPECT_GT(clip.z, -clip.w) << "beyond the near plane";
                }
            }
            // Neither clipped nor dark: a white surface facing the light at the mesh's centre.
            const double distance = glm::length(light - 0.5 * (mesh.lowerWorld + mesh.upperWorld));
            const double radiance = scene->lights[0].intensity / (distance * distance) * 0.8 / 3.14159;
            EXPECT_GT(radiance, 0.5);
            EXPECT_LT(radiance, 1.0);
        }
}

TEST(StageObj, AFlatSheetFloatsAboveTheFloor) {
    const TempFolder folder;
    const auto scene = stageObj(folder.write("sheet.obj", "v 0 7 0\nv 2 7 0\nv 0 7 2\nf 1 3 2\n"), {});
    EXPECT_GT(boundsWorld(scene->objects[1]).lowerWorld.y, 0.1);
}

TEST(StageObj, UsesTheMaterialsOfTheFileElseClay) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl floor\nKd 1 0 0\n");
    const auto scene = stageObj(folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"
                                                      "usemtl floor\nf 1 2 4\n"),
                                {});
    const Object& object = scene->objects[1];
    ASSERT_EQ(object.partMaterials.size(), 2u);
    EXPECT_EQ(scene->materials[object.partMaterials[0]].name, "clay");
    EXPECT_EQ(scene->materials[object.partMaterials[1]].diffuse, vec3(1, 0, 0));
    EXPECT_NE(scene->materials[object.partMaterials[1]].name, "floor") << "that name is taken by the stage";
    EXPECT_EQ(scene->materials[0].name, "white");
}

} // namespace
} // namespace shadowlab::scene
