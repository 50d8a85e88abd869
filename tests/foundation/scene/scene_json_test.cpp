// What a scene file says is what the scene holds: defaults, every key, sharing, placement.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <locale>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kCamera = R"("camera": {"position": [0, 1, 5], "target": [0, 0, 0]})";

std::shared_ptr<const Scene> parse(const std::string& text, const LoadOptions& options = {}) {
    return parseSceneJson(text, "scene.json", options);
}

/// A scene with one object of these keys.
std::shared_ptr<const Scene> withObject(const std::string& keys) {
    return parse("{" + kCamera + R"(, "objects": [{)" + keys + "}]}");
}

TEST(SceneJson, DefaultsAreAsDocumented) {
    const auto scene = parse("{" + kCamera + "}");
    EXPECT_EQ(scene->name, "scene");
    EXPECT_EQ(scene->camera.upWorld, dvec3(0, 1, 0));
    EXPECT_EQ(scene->camera.fovYDegrees, 45.0);
    EXPECT_EQ(scene->camera.near, 0.1);
    EXPECT_TRUE(std::isinf(scene->camera.far));
    EXPECT_EQ(scene->ambient, vec3(0));
    EXPECT_EQ(scene->background, vec3(0));
    EXPECT_EQ(scene->exposure, 1.0f);
    EXPECT_TRUE(scene->lights.empty());
    EXPECT_TRUE(scene->objects.empty());
    ASSERT_EQ(scene->materials.size(), 1u);
    EXPECT_EQ(scene->materials[0].name, "white");
    EXPECT_EQ(scene->materials[0].diffuse, vec3(0.8f));
    EXPECT_TRUE(scene->notes.empty());
}

// A closed body with the eye in it is a room and glows inside; whatever else shares its material, or says which side shines, does not.
TEST(SceneJson, ARoomGlowsInside) {
    const auto emitsOf = [](const std::string& keys, const std::string& eye, const std::string& others) {
        const auto scene = parse(R"({"camera": {"position": )" + eye + R"(, "target": [0, 0, -9]}, "materials": {"glow": {"emission": [1, 1, 1])" +
                                 keys + R"(}}, "objects": [{"shape": "box", "size": [2, 2, 2], "material": "glow"})" + others + "]}");
        std::vector<EmittingSides> sides;
        for (const Object& object : scene->objects)
            sides.push_back(scene->materials[object.partMaterials[0]].emits);
        EXPECT_EQ(scene->materials.size(), others.find("glow") == std::string::npos || sides[0] == sides[1] ? 2u : 3u);
        return sides;
    };
    const std::string inside = "[0, 0, 0.5]", outside = "[0, 0, 5]";
    const std::string panel = R"(, {"shape": "quad", "size": [1, 1], "material": "glow"})";
    using enum EmittingSides;
    EXPECT_EQ(emitsOf("", inside, ""), std::vector{both});
    EXPECT_EQ(emitsOf("", outside, ""), std::vector{front});
    EXPECT_EQ(emitsOf(R"(, "emits": "front")", inside, ""), std::vector{front});
    EXPECT_EQ(emitsOf("", inside, panel), (std::vector{both, front})) << "a quad has no inside";
    EXPECT_EQ(emitsOf("", outside, panel), (std::vector{front, front}));
}

TEST(SceneJson, CommentsAndAByteOrderMarkAreAllowed) {
    const auto scene = parse("\xef\xbb\xbf// a scene\n{ /* the eye */ " + kCamera + " // \"end\":\n}\n/* done */");
    EXPECT_EQ(scene->camera.positionWorld, dvec3(0, 1, 5));
}

TEST(SceneJson, LightsOfAllTypesAreRead) {
    const auto scene = parse("{" + kCamera + R"(, "lights": [
        {"name": "key", "type": "point", "position": [2, 5, 3], "color": [1, 0.5, 0], "intensity": 40},
        {"type": "directional", "direction": [0, -4, 0]},
        {"type": "spot", "position": [0, 4, 0], "direction": [3, -4, 0], "coneDegrees": 50, "edgeDegrees": 25},
        {"name": "panel", "type": "rect", "position": [0, 4, 0], "edgeU": [2, 0, 0], "edgeV": [0, 0, 3]},
        {"name": "bulb", "type": "sphere", "position": [0, 4, 0], "radius": 0.25, "intensity": 10},
        {"name": "plain spot", "type": "spot", "position": [1, 2, 3]}]})");
    ASSERT_EQ(scene->lights.size(), 6u);
    EXPECT_EQ(scene->lights[0].intensity, 40.0);
    EXPECT_EQ(scene->lights[0].color, vec3(1, 0.5f, 0));
    EXPECT_EQ(scene->lights[1].name, "light1");
    EXPECT_EQ(scene->lights[1].directionWorld, dvec3(0, -1, 0)) << "made unit";
    EXPECT_EQ(scene->lights[1].intensity, 1.0);
    EXPECT_EQ(scene->lights[2].name, "light2");
    EXPECT_EQ(scene->lights[2].coneDegrees, 50.0);
    EXPECT_EQ(scene->lights[2].edgeDegrees, 25.0);
    EXPECT_NEAR(glm::length(scene->lights[2].directionWorld - dvec3(0.6, -0.8, 0)), 0.0, 1e-15);
    EXPECT_EQ(scene->lights[3].edgeVWorld, dvec3(0, 0, 3));
    EXPECT_EQ(scene->lights[4].radius, 0.25);
    EXPECT_EQ(scene->lights[5].coneDegrees, 60.0);
    EXPECT_EQ(scene->lights[5].directionWorld, dvec3(0, -1, 0));
}

TEST(SceneJson, AreaLightsGetASurfaceThatShinesAndBlocksNothing) {
    const auto scene = parse("{" + kCamera + R"(, "lights": [
        {"type": "point", "position": [0, 9, 0]},
        {"name": "panel", "type": "rect", "position": [0, 4, 0], "edgeU": [2, 0, 0], "edgeV": [0, 0, 3], "color": [1, 0, 0.5], "intensity": 10},
        {"name": "bulb", "type": "sphere", "position": [1, 4, 0], "radius": 0.25}]})");
    ASSERT_EQ(scene->objects.size(), 2u);
    const Object& panel = scene->objects[0];
    EXPECT_EQ(panel.name, "panel (surface)");
    EXPECT_EQ(panel.emitterOfLight, 1);
    EXPECT_FALSE(panel.castsShadow);
    EXPECT_FALSE(panel.receivesShadow);
    EXPECT_EQ(areaVectorSum(*panel.mesh), dvec3(0, -6, 0)) << "faces edgeU x edgeV";
    EXPECT_EQ(boundsWorld(panel).lowerWorld, dvec3(-1, 4, -1.5));
    const Material& shining = scene->materials[panel.partMaterials[0]];
    EXPECT_EQ(shining.emission, vec3(10, 0, 5));
    EXPECT_EQ(shining.diffuse, vec3(0));
    EXPECT_EQ(scene->objects[1].emitterOfLight, 2);
    EXPECT_EQ(boundsWorld(scene->objects[1]).upperWorld, dvec3(1.25, 4.25, 0.25));

    Scene moved = *scene; // calling again moves the surfaces and adds nothing
    moved.lights[1].positionWorld.x = 7.0;
    addEmitterSurfaces(moved);
    EXPECT_EQ(moved.objects.size(), 2u);
    EXPECT_EQ(moved.materials.size(), scene->materials.size());
    EXPECT_EQ(boundsWorld(moved.objects[0]).lowerWorld, dvec3(6, 4, -1.5));
}

TEST(SceneJson, MaterialsAreReadAndWhiteIsAlwaysThereFirst) {
    const auto scene = parse("{" + kCamera + R"(, "materials": {
        "glass": {"diffuse": [0, 0, 0], "specular": [1, 1, 1], "shininess": 200, "reflectivity": 0.1, "transparency": 0.9,
                  "ior": 1.33, "priority": 2, "glossDegrees": 1, "translucencyDegrees": 3, "emission": [0, 5, 0], "emits": "both"},
        "white": {"diffuse": [0.5, 0.5, 0.5]}},
        "objects": [{"shape": "box", "size": [1, 1, 1], "material": "glass"}, {"shape": "box", "size": [1, 1, 1]}]})");
    ASSERT_EQ(scene->materials.size(), 2u);
    EXPECT_EQ(scene->materials[0].name, "white");
    EXPECT_EQ(scene->materials[0].diffuse, vec3(0.5f));
    const Material& glass = scene->materials[1];
    EXPECT_EQ(glass.shininess, 200.0f);
    EXPECT_EQ(glass.transparency, 0.9);
    EXPECT_EQ(glass.ior, 1.33);
    EXPECT_EQ(glass.priority, 2);
    EXPECT_EQ(glass.glossDegrees, 1.0);
    EXPECT_EQ(glass.translucencyDegrees, 3.0);
    EXPECT_EQ(glass.emission, vec3(0, 5, 0));
    EXPECT_EQ(glass.emits, EmittingSides::both);
    EXPECT_EQ(scene->materials[0].emits, EmittingSides::front) << "the default";
    EXPECT_EQ(scene->objects[0].partMaterials, std::vector<std::uint32_t>{1});
    EXPECT_EQ(scene->objects[1].partMaterials, std::vector<std::uint32_t>{0});
}

TEST(SceneJson, ShapesHaveTheirSizesAndSegments) {
    const auto scene = parse("{" + kCamera + R"(, "objects": [
        {"shape": "quad", "size": [4, 2]}, {"shape": "box", "size": [1, 2, 3], "name": "crate"},
        {"shape": "sphere", "radius": 0.5}, {"shape": "sphere", "radius": 0.5, "segments": 8, "normals": "flat"},
        {"shape": "torus", "radii": [1, 0.3]}, {"shape": "torus", "radii": [1, 0.3], "segments": [5, 4]},
        {"shape": "torus", "radii": [1, 0.3], "segments": 10}, {"shape": "sphere", "radius": 0.5}]})");
    const auto triangles = [&](int i) { return scene->objects[i].mesh->triangles.size(); };
    EXPECT_EQ(boundsWorld(scene->objects[0]).upperWorld, dvec3(2, 0, 1)) << "size is [x, z]";
    EXPECT_EQ(boundsWorld(scene->objects[1]).upperWorld, dvec3(0.5, 1, 1.5));
    EXPECT_EQ(scene->objects[1].name, "crate");
    EXPECT_EQ(triangles(2), 64u * 31u * 2u);
    EXPECT_EQ(triangles(3), 8u * 3u * 2u);
    EXPECT_GT(scene->objects[3].mesh->positionsMesh.size(), 2u + 3u * 8u) << "flat: neighbours share no vertices";
    EXPECT_EQ(triangles(4), 64u * 32u * 2u);
    EXPECT_EQ(triangles(5), 5u * 4u * 2u);
    EXPECT_EQ(triangles(6), 10u * 5u * 2u);
    EXPECT_EQ(scene->objects[2].mesh, scene->objects[7].mesh) << "equal shapes share a mesh";
    EXPECT_EQ(scene->objects[2].name, "sphere");
    EXPECT_EQ(scene->objects[3].name, "sphere2");
}

TEST(SceneJson, FlagsAndVelocityAreRead) {
    const auto scene = withObject(
        R"("shape": "quad", "size": [1, 1], "castsShadow": false, "receivesShadow": false, "velocity": [1, 2, 3])");
    EXPECT_FALSE(scene->objects[0].castsShadow);
    EXPECT_FALSE(scene->objects[0].receivesShadow);
    EXPECT_EQ(scene->objects[0].velocityWorld, dvec3(1, 2, 3));
    EXPECT_TRUE(withObject(R"("shape": "quad", "size": [1, 1])")->objects[0].castsShadow);
}

TEST(SceneJson, ScalesThenRotatesAboutXYZThenTranslates) {
    const dmat4 m = withObject(R"("shape": "box", "size": [1, 1, 1], "scale": [2, 3, 4],
                                  "rotateDegrees": [90, 90, 0], "translate": [10, 20, 30])")
                        ->objects[0]
                        .worldFromObject;
    // x axis: scaled to (2,0,0), about x stays, about y by 90 degrees becomes (0,0,-2).
    EXPECT_EQ(transformPoint(m, {1, 0, 0}), dvec3(10, 20, 28));
    // y axis: (0,3,0), about x becomes (0,0,3), about y becomes (3,0,0).
    EXPECT_EQ(transformPoint(m, {0, 1, 0}), dvec3(13, 20, 30));
    // z axis: (0,0,4), about x becomes (0,-4,0), about y stays.
    EXPECT_EQ(transformPoint(m, {0, 0, 1}), dvec3(10, 16, 30));
}

TEST(SceneJson, QuarterTurnsAreExactAndOthersAreRotations) {
    for (int i = -8; i <= 8; ++i) {
        const dmat4 m =
            withObject(R"("shape": "quad", "size": [1, 1], "rotateDegrees": [0, 0, )" + std::to_string(90 * i) + "]")
                ->objects[0]
                .worldFromObject;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                EXPECT_EQ(m[c][r], std::round(m[c][r]));
    }
    const dmat4 m =
        withObject(R"("shape": "quad", "size": [1, 1], "rotateDegrees": [0, 0, 150])")->objects[0].worldFromObject;
    EXPECT_NEAR(m[0][0], -std::sqrt(3.0) / 2.0, 1e-15);
    EXPECT_NEAR(m[0][1], 0.5, 1e-15);
    EXPECT_NEAR(glm::determinant(dmat3(m)), 1.0, 1e-15);
}

TEST(SceneJson, AScaleNumberActsOnAllAxesAndMayMirror) {
    EXPECT_EQ(withObject(R"("shape": "quad", "size": [1, 1], "scale": 2)")->objects[0].worldFromObject[1][1], 2.0);
    EXPECT_EQ(withObject(R"("shape": "quad", "size": [1, 1], "scale": [1, -1, 1])")->objects[0].worldFromObject[1][1],
              -1.0);
}

const std::string kMesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(SceneJson, MeshFilesAreRelativeToTheSceneAndShared) {
    const TempFolder folder;
    folder.write("models/square.obj", kMesh + "f 1 2 3 4\n");
    const auto file = folder.write("scene.json", "");
    const auto scene = parseSceneJson("{" + kCamera + R"(, "objects": [
        {"mesh": "models/square.obj"}, {"mesh": "./models/../models/square.obj", "translate": [1, 0, 0]},
        {"mesh": "models/square.obj", "normals": "smooth"}]})",
                                      file, {});
    EXPECT_EQ(scene->objects[0].mesh, scene->objects[1].mesh);
    EXPECT_NE(scene->objects[0].mesh, scene->objects[2].mesh);
    EXPECT_EQ(scene->objects[0].name, "square");
    EXPECT_EQ(boundsWorld(scene->objects[1]).upperWorld, dvec3(2, 1, 0));
}

TEST(SceneJson, MeshMaterialsJoinTheSceneUnderUniqueNames) {
    const TempFolder folder;
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl white\nKd 0 1 0\nnewmtl unused\n");
    folder.write("a.obj", "mtllib a.mtl\n" + kMesh +
                              "f 1 2 3\nusemtl red\nf 1 3 4\nusemtl white\nf 1 2 4\nusemtl lost\nf 2 3 4\n");
    const auto file = folder.write("scene.json", "");
    const auto scene = parseSceneJson("{" + kCamera + R"(, "materials": {"blue": {"diffuse": [0, 0, 1]}}, "objects": [
        {"mesh": "a.obj"}, {"mesh": "a.obj", "normals": "flat"}, {"mesh": "a.obj", "material": "blue"}]})",
                                      file, {});
    ASSERT_EQ(scene->materials.size(), 4u);
    EXPECT_EQ(scene->materials[2].name, "red");
    EXPECT_EQ(scene->materials[3].name, "white (a)");
    EXPECT_EQ(scene->objects[0].partMaterials, (std::vector<std::uint32_t>{0, 2, 3, 0}));
    EXPECT_EQ(scene->objects[1].partMaterials, scene->objects[0].partMaterials);
    EXPECT_EQ(scene->objects[2].partMaterials, (std::vector<std::uint32_t>{1, 1, 1, 1}));
    ASSERT_EQ(scene->notes.size(), 1u) << "the note about 'lost' appears once";
}

TEST(SceneJson, TheLocaleChangesNothing) {
    struct CommaNumbers : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
    const auto scene = parse(R"({"camera": {"position": [0.5, 1.25, 5], "target": [0, 0, 0]}})");
    std::locale::global(before);
    EXPECT_EQ(scene->camera.positionWorld, dvec3(0.5, 1.25, 5.0));
}

} // namespace
} // namespace shadowlab::scene
