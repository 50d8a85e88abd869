// A glTF file as a scene: its lights and cameras, the stage for what lacks them, and its place in scene files.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/model/edit_scene.h"
#include "tests/foundation/scene/gltf/gltf_file.h"

namespace shadowlab::scene {
namespace {

constexpr double kRounding = 1e-12; // of a turn and a few products on numbers about 10

Snapshot staged(const MadeGltf& made) { return stagedGltf(made.parsed(), "made.gltf", {}); }

/// A quarter turn about x downward: what looked along -z looks along -y.
const Json kDown{{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}};

TEST(GltfLights, StandAndShineAsTheirNodesDo) {
    MadeGltf made;
    Json above = kDown;
    above["translation"] = {1, 5, 2};
    above["name"] = "lamp";
    made.light(above) = {
        {"type", "spot"}, {"intensity", 40}, {"color", {1, 0.5, 0}}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.75}}}};
    made.light(kDown) = {{"type", "directional"}, {"intensity", 3}};
    made.light({{"translation", {0, 2, 0}}, {"scale", {7, 7, 7}}}) = {{"type", "point"}};
    const std::vector<Light> lights = made.parsed().lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].name, "lamp");
    EXPECT_EQ(lights[0].type, LightType::spot);
    EXPECT_EQ(lights[0].positionWorld, dvec3(1, 5, 2));
    EXPECT_LT(glm::length(lights[0].directionWorld - dvec3(0, -1, 0)), kRounding);
    EXPECT_NEAR(lights[0].coneDegrees, 1.5 * 180 / glm::pi<double>(), kRounding) << "from edge to edge";
    EXPECT_NEAR(lights[0].edgeDegrees, 0.5 * 180 / glm::pi<double>(), kRounding);
    EXPECT_EQ(lights[0].intensity, 40);
    EXPECT_EQ(lights[0].color, vec3(1, 0.5f, 0));
    EXPECT_EQ(lights[1].type, LightType::directional);
    EXPECT_LT(glm::length(lights[1].directionWorld - dvec3(0, -1, 0)), kRounding);
    EXPECT_EQ(lights[2].type, LightType::point);
    EXPECT_EQ(lights[2].positionWorld, dvec3(0, 2, 0));
    EXPECT_EQ(lights[2].intensity, 1);
}

TEST(GltfLights, ASpotWithoutAnglesIsOfAQuarterTurn) {
    MadeGltf made;
    made.light() = {{"type", "spot"}, {"spot", Json::object()}};
    const Light light = made.parsed().lights.at(0);
    constexpr double kDigits = 1e-9; // tinygltf's pi/4 has ten digits
    EXPECT_NEAR(light.coneDegrees, 90, kDigits);
    EXPECT_NEAR(light.edgeDegrees, 45, kDigits);
}

TEST(GltfCameras, ProjectAsGltfSays) {
    MadeGltf made;
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.25}, {"zfar", 50}}}},
                            {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    const double s = std::sin(0.3), c = std::cos(0.3); // half of a turn of 0.6 about y
    made.addNode({{"camera", 0}, {"name", "eye"}, {"translation", {3, 1, 4}}, {"rotation", {0, s, 0, c}}});
    made.addNode({{"camera", 1}});
    const GltfFile file = made.parsed();
    ASSERT_EQ(file.viewpoints.size(), 1u) << "orthographic cameras are left out";
    EXPECT_TRUE(contains(joinedNotes(file.notes), "cameras[1]: orthographic cameras are left out"));
    const Camera& camera = file.viewpoints[0].camera;
    EXPECT_EQ(file.viewpoints[0].name, "eye");
    EXPECT_EQ(camera.near, 0.25);
    EXPECT_EQ(camera.far, 50);
    // A point 2 to the right, 1 up and 8 before the camera: x = 2 / 8 and y = 1 / 8, over the tangent of half the angle.
    const dvec3 point =
        dvec3(3, 1, 4) + 2.0 * dvec3(std::cos(0.6), 0, -std::sin(0.6)) + dvec3(0, 1, 0) - 8.0 * dvec3(std::sin(0.6), 0, std::cos(0.6));
    const dvec4 clip = clipFromView(camera, 1.5) * viewFromWorld(camera) * dvec4(point, 1);
    EXPECT_NEAR(clip.x / clip.w, 2.0 / 8 / std::tan(0.4) / 1.5, kRounding);
    EXPECT_NEAR(clip.y / clip.w, 1.0 / 8 / std::tan(0.4), kRounding);
}

TEST(GltfStage, ABareFileIsStagedAsTheSameObjFileIs) {
    const TempFolder folder;
    MadeGltf made;
    made.primitive()["attributes"]["POSITION"] = made.add<float>({0, 0, 0, 2, 0, 0, 0, 1, 1}, 5126, "VEC3", 3);
    const Snapshot gltf = loadScene(folder.write("m.gltf", made.text()).string(), {});
    const Snapshot obj = loadScene(folder.write("m.obj", "v 0 0 0\nv 2 0 0\nv 0 1 1\nf 1 2 3\n").string(), {});
    EXPECT_EQ(gltf->camera, obj->camera);
    EXPECT_EQ(gltf->lights, obj->lights);
    EXPECT_EQ(gltf->ambient, obj->ambient);
    EXPECT_EQ(gltf->exposure, obj->exposure);
    ASSERT_EQ(gltf->objects.size(), obj->objects.size());
    for (std::size_t i = 0; i < obj->objects.size(); ++i) {
        EXPECT_EQ(gltf->objects[i].worldFromObject, obj->objects[i].worldFromObject);
        EXPECT_EQ(gltf->objects[i].mesh->positionsMesh, obj->objects[i].mesh->positionsMesh);
        EXPECT_EQ(gltf->objects[i].partMaterials, obj->objects[i].partMaterials);
    }
}

TEST(GltfStage, OwnCamerasAndLightsAreUsedAndNothingIsPutBeside) {
    MadeGltf made;
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.25}}}}};
    made.addNode({{"camera", 0}, {"name", "a"}, {"translation", {0, 0, 5}}});
    made.addNode({{"camera", 0}, {"name", "b"}, {"translation", {0, 0, 9}}});
    made.light({{"translation", {0, 0, 1}}}) = {{"type", "point"}, {"intensity", 3}};
    const Snapshot scene = staged(made);
    EXPECT_EQ(scene->objects.size(), 1u) << "no floor";
    EXPECT_EQ(scene->objects[0].worldFromObject, dmat4(1.0)) << "nothing is moved";
    ASSERT_EQ(scene->viewpoints.size(), 2u);
    EXPECT_EQ(scene->viewpoints[1].name, "b");
    EXPECT_EQ(scene->camera, scene->viewpoints[0].camera);
    ASSERT_EQ(scene->lights.size(), 1u);
    EXPECT_EQ(scene->lights[0].intensity, 3);
    EXPECT_EQ(scene->exposure, 1);
}

TEST(GltfStage, PhotometricLightsAreExposedToWhatAPictureShows) {
    MadeGltf made;
    made.light(kDown) = {{"type", "directional"}, {"intensity", 3000}};
    const Snapshot scene = staged(made);
    EXPECT_EQ(scene->lights.at(0).intensity, 3000) << "as the file has it";
    EXPECT_FLOAT_EQ(scene->exposure, 0.001f) << "3000 lux are shown as the stage's 3";
    EXPECT_TRUE(contains(joinedNotes(scene->notes), "its lights bring 3000 lux")) << joinedNotes(scene->notes);
}

TEST(GltfStage, AnEyeWithinTheModelHasItsLightBesideIt) {
    MadeGltf made;
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.01}}}}};
    made.addNode({{"mesh", 0}, {"translation", {0, 0, 10}}});
    made.addNode({{"camera", 0}, {"translation", {0.5, 0.5, 8}}});
    const Snapshot inside = staged(made);
    ASSERT_EQ(inside->lights.size(), 1u);
    EXPECT_LT(glm::length(inside->lights[0].positionWorld - inside->camera.positionWorld), 2);
    made.json["nodes"].back()["translation"] = {0.5, 0.5, 30};
    EXPECT_GT(glm::length(staged(made)->lights.at(0).positionWorld - dvec3(0.5, 0.5, 30)), 10);
}

/// A scene file with two nodes of a glTF file beside it.
struct SceneOfTwo {
    TempFolder folder;
    SceneOfTwo() {
        MadeGltf made;
        made.json["nodes"][0]["name"] = "low";
        made.addNode({{"mesh", 0}, {"name", "high"}, {"translation", {0, 2, 0}}});
        made.light() = {{"type", "point"}};
        folder.write("m.gltf", made.text());
    }
    [[nodiscard]] Snapshot with(const std::string& objects, const std::string& more = "") const {
        return loadScene(folder
                             .write("s.json", R"({"camera": {"position": [0, 0, 9], "target": [0, 0, 0]}, )" + more +
                                                  R"("lights": [], "objects": [)" + objects + "]}")
                             .string(),
                         {});
    }
};

TEST(GltfInScenes, AllNodesStandUnderTheObjectsTransform) {
    const SceneOfTwo files;
    const Snapshot scene = files.with(R"({"name": "car", "mesh": "m.gltf", "scale": 2, "translate": [1, 0, 0]})");
    ASSERT_EQ(scene->objects.size(), 2u);
    EXPECT_EQ(scene->objects[0].name, "car low");
    EXPECT_EQ(scene->objects[1].name, "car high");
    EXPECT_EQ(transformPoint(scene->objects[1].worldFromObject, dvec3(1, 0, 0)), dvec3(3, 4, 0));
    EXPECT_EQ(scene->objects[0].mesh, scene->objects[1].mesh);
    EXPECT_TRUE(contains(joinedNotes(scene->notes), "1 light and 0 cameras of the file are left out")) << joinedNotes(scene->notes);
}

TEST(GltfInScenes, OneNodeMayBeNamed) {
    const SceneOfTwo files;
    const Snapshot scene = files.with(R"({"mesh": "m.gltf", "node": "high"})");
    ASSERT_EQ(scene->objects.size(), 1u);
    EXPECT_EQ(scene->objects[0].name, "high");
    EXPECT_EQ(transformPoint(scene->objects[0].worldFromObject, dvec3(0)), dvec3(0, 2, 0));
    const Error unknown = errorOf([&] { (void)files.with(R"({"mesh": "m.gltf", "node": "hihg"})"); });
    EXPECT_TRUE(contains(unknown.what(), "s.json:1:")) << unknown.what();
    EXPECT_TRUE(contains(unknown.what(), "did you mean \"high\"?")) << unknown.what();
}

TEST(GltfInScenes, AStagedFileIsTheSameWhenItWasWrittenAndRead) {
    const TempFolder folder;
    MadeGltf made;
    made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 0, 1};
    made.addNode({{"mesh", 0}, {"translation", {0, 2, 0}}, {"name", "second"}});
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.25}}}}};
    made.addNode({{"camera", 0}, {"name", "eye"}, {"translation", {0, 0, 5}}});
    made.light(kDown) = {{"type", "directional"}, {"intensity", 3000}};
    const Snapshot first = loadScene(folder.write("m.glb", made.glb()).string(), {});
    const Snapshot again = loadScene(folder.write("s.json", sceneText(*first, first->camera, folder.path())).string(), {});
    EXPECT_EQ(first->camera, again->camera);
    EXPECT_EQ(first->viewpoints, again->viewpoints);
    EXPECT_EQ(first->exposure, again->exposure);
    EXPECT_EQ(first->ambient, again->ambient);
    EXPECT_EQ(first->lights, again->lights);
    ASSERT_EQ(first->objects.size(), again->objects.size());
    for (std::size_t i = 0; i < first->objects.size(); ++i) {
        EXPECT_EQ(first->objects[i].name, again->objects[i].name);
        EXPECT_EQ(first->objects[i].worldFromObject, again->objects[i].worldFromObject);
        EXPECT_EQ(first->objects[i].mesh->positionsMesh, again->objects[i].mesh->positionsMesh);
        EXPECT_EQ(materialOfTriangle(*first, first->objects[i], 0).diffuse, materialOfTriangle(*again, again->objects[i], 0).diffuse);
    }
}

TEST(GltfInScenes, AnObjectThatIsMovedStaysWhereItsNodeIsAndIsWrittenSo) {
    const SceneOfTwo files;
    const Snapshot scene = files.with(R"({"mesh": "m.gltf", "scale": 0.3, "rotateDegrees": [10, 20, 30], "translate": [1, 0, 0]})");
    const Snapshot moved = withObjectMovedBy(scene, 1, {0.1, 0.7, -3});
    EXPECT_EQ(moved->objects[0].worldFromObject, scene->objects[0].worldFromObject);
    const dvec3 before(scene->objects[1].worldFromObject[3]), after(moved->objects[1].worldFromObject[3]);
    EXPECT_LT(glm::length(after - before - dvec3(0.1, 0.7, -3)), kRounding);
    const Snapshot again = loadScene(files.folder.write("t.json", sceneText(*moved, moved->camera, files.folder.path())).string(), {});
    ASSERT_EQ(again->objects.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(again->objects[i].worldFromObject, moved->objects[i].worldFromObject) << "to the last bit";
}

TEST(Views, AreReadAndWritten) {
    const SceneOfTwo files;
    const std::string views = R"("views": {"from above": {"position": [0, 9, 1], "target": [0, 0, 0], "fovYDegrees": 30}}, )";
    const Snapshot scene = files.with(R"({"shape": "box", "size": [1, 1, 1]})", views);
    ASSERT_EQ(scene->viewpoints.size(), 1u);
    EXPECT_EQ(scene->viewpoints[0].name, "from above");
    EXPECT_EQ(scene->viewpoints[0].camera.fovYDegrees, 30);
    const Snapshot again = loadScene(files.folder.write("t.json", sceneText(*scene, scene->camera, files.folder.path())).string(), {});
    EXPECT_EQ(again->viewpoints, scene->viewpoints);
    const Error bad = errorOf([&] { (void)files.with("", R"("views": {"x": {"position": [0, 0, 0], "target": [0, 0, 0]}}, )"); });
    EXPECT_TRUE(contains(bad.what(), "the view 'x'")) << bad.what();
}

} // namespace
} // namespace shadowlab::scene
