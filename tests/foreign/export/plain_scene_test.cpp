// The plain scene holds the triangles of the scene where they are, turned as they are, with what lies on them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "app/foreign/export/plain_scene.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/brute_force.h"

namespace shadowlab::foreign {
namespace {

scene::Snapshot builtIn(const std::string& name) { return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}); }

scene::Snapshot parsed(const std::string& text) {
    return scene::parseSceneJson(text, "test.json", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

constexpr const char* kCamera = R"("camera": {"position": [0, 2, 6], "target": [0, 0, 0]})";

TEST(PlainScene, HasEveryTriangleOfEveryBuiltInScene) {
    std::size_t scenes = 0, corners = 0;
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        SCOPED_TRACE(name);
        const scene::Snapshot scene = builtIn(name);
        const PlainScene plain = plainScene(*scene);
        EXPECT_EQ(plain.originWorld, dvec3(0));
        std::size_t at = 0;
        const std::vector<testing::WorldTriangle> all = testing::allTriangles(*scene);
        for (const PlainMesh& mesh : plain.meshes)
            for (const uvec3& triangle : mesh.triangles) {
                ASSERT_LT(at, all.size());
                // A float of the largest coordinate, 240 m / 2, is 7.6e-6 m; half of it is rounding.
                constexpr double kRounding = 4e-6;
                for (const dvec3& expected : all[at].cornersWorld) { // in a mirrored object the other way round
                    double off = 1;
                    for (int corner = 0; corner < 3; ++corner)
                        off = std::min(off, glm::length(dvec3(mesh.positions[triangle[corner]]) - expected));
                    ASSERT_LE(off, kRounding * std::sqrt(3.0)) << mesh.name;
                    ++corners;
                }
                ++at;
            }
        EXPECT_EQ(at, scene::triangleCount(*scene));
        ++scenes;
    }
    EXPECT_GE(scenes, 13u);
    EXPECT_GE(corners, 500'000u);
}

TEST(PlainScene, FrontsOfMirroredObjectsStayFronts) {
    const scene::Snapshot scene = parsed(std::string("{") + kCamera + R"(, "objects": [
        {"shape": "sphere", "radius": 1, "segments": 16, "scale": [-1, 2, 1]}, {"shape": "sphere", "radius": 1, "segments": 16, "scale": [-1, -1, 3]}]})");
    const PlainScene plain = plainScene(*scene);
    ASSERT_EQ(plain.meshes.size(), 2u);
    int tried = 0;
    for (const PlainMesh& mesh : plain.meshes)
        for (const uvec3& triangle : mesh.triangles) {
            const dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]), c(mesh.positions[triangle.z]);
            const dvec3 front = glm::cross(b - a, c - a);
            EXPECT_GT(glm::dot(front, a + b + c), 0) << "the outside of a ball about the origin is its front";
            EXPECT_GT(glm::dot(front, dvec3(mesh.normals[triangle.x])), 0);
            ++tried;
        }
    EXPECT_GE(tried, 400);
}

TEST(PlainScene, IsMovedNearTheOriginWhereFloatsWouldBeCoarse) {
    const scene::Snapshot scene = parsed(R"({"camera": {"position": [1000000, 2, 6], "target": [1000000, 0, 0]},
        "lights": [{"type": "point", "position": [1000001, 5, 0]}, {"type": "directional", "direction": [0, -1, 0]}],
        "objects": [{"shape": "box", "size": [1.1, 1, 1], "translate": [1000000.25, 0, 0]}]})");
    const PlainScene plain = plainScene(*scene);
    EXPECT_EQ(plain.originWorld, dvec3(1000000, 0, 0));
    EXPECT_EQ(plain.eye.position, dvec3(0, 2, 6));
    EXPECT_EQ(plain.lights[0].positionWorld, dvec3(1, 5, 0));
    float right = 0;
    for (const vec3& position : plain.meshes.at(0).positions)
        right = std::max(right, position.x);
    EXPECT_NEAR(right, 0.8, 1e-7); // a float of 0.8; of 1000000.8 it would be off by 0.05
}

TEST(PlainScene, TheEyeIsThatOfTheCamera) {
    const scene::Snapshot scene = builtIn("still-life");
    const PlainEye eye = plainScene(*scene).eye;
    int tried = 0;
    for (const ivec2 pixel : {ivec2(0, 0), ivec2(319, 0), ivec2(17, 160), ivec2(200, 93)}) {
        // The formula of the README.
        const ivec2 size(320, 180);
        const double t = std::tan(glm::radians(eye.fovYDegrees) / 2);
        const dvec2 at = (dvec2(pixel) + 0.5) / dvec2(size);
        const dvec3 way = glm::normalize(eye.right * (t * size.x / size.y * (2 * at.x - 1)) + eye.up * (t * (1 - 2 * at.y)) - eye.back);
        EXPECT_LT(glm::length(way - scene::rayDirectionWorld(scene->camera, dvec2(pixel) + 0.5, size)), 1e-14); // rounding of double
        ++tried;
    }
    EXPECT_EQ(tried, 4);
    for (const PlainMesh& mesh : plainScene(*scene).meshes)
        for (const vec3& position : mesh.positions)
            ASSERT_LT(-glm::dot(dvec3(position) - eye.position, eye.back), eye.far);
}

TEST(PlainScene, AnImageHasHolesWhereTheMaskHasThem) {
    const scene::Snapshot scene = builtIn("lattice");
    const PlainScene plain = plainScene(*scene);
    ASSERT_EQ(plain.images.size(), 1u);
    int holes = 0, solid = 0;
    for (std::size_t object = 0; object < scene->objects.size(); ++object)
        for (std::size_t part = 0; part < scene->objects[object].mesh->parts.size(); ++part) {
            const scene::AlphaMask* mask = scene::maskOfPart(*scene, scene->objects[object], part);
            if (mask == nullptr) continue;
            const image::Image& image = plain.images[0].image;
            for (int row = 0; row < image.height; ++row)
                for (int x = 0; x < image.width; ++x) {
                    const dvec2 place((x + 0.5) / image.width, 1 - (row + 0.5) / image.height);
                    const bool hole = mask->isHole(place, false);
                    ASSERT_EQ(image.at(x, row).a, hole ? 0 : 255);
                    ++(hole ? holes : solid);
                }
        }
    EXPECT_GE(holes, 1000);
    EXPECT_GE(solid, 1000);
    int withPlaces = 0;
    for (const PlainMesh& mesh : plain.meshes) {
        const PlainMaterial& material = plain.materials[mesh.material];
        EXPECT_EQ(material.image >= 0, !mesh.texcoords.empty());
        if (mesh.texcoords.empty()) continue;
        EXPECT_EQ(mesh.texcoords.size(), mesh.positions.size());
        ++withPlaces;
    }
    EXPECT_EQ(withPlaces, 1);
}

TEST(PlainScene, FlatGroundsThatShadowNothingAreNoUsefulCasters) {
    const PlainScene plain = plainScene(*builtIn("sphere-on-plane"));
    ASSERT_EQ(plain.meshes.size(), 2u);
    EXPECT_EQ(plain.usefulCasters.at(0), std::vector<std::uint32_t>{1}); // the ball
    EXPECT_TRUE(plain.meshes[1].isClosed);
    EXPECT_FALSE(plain.meshes[0].isClosed);
}

TEST(PlainScene, SaysWhatItLoses) {
    const PlainScene plain = plainScene(*parsed(R"({"camera": {"position": [0, 2, 6], "target": [0, 0, 0]},
        "views": {"top": {"position": [0, 9, 1], "target": [0, 0, 0]}},
        "objects": [{"shape": "quad", "size": [2, 2]}, {"shape": "quad", "size": [1, 1]},
                    {"shape": "box", "size": [1, 1, 1], "translate": [0, 2, 0], "velocity": [1, 0, 0]}]})"));
    ASSERT_EQ(plain.lost.size(), 3u);
    EXPECT_NE(plain.lost[0].find("motion"), std::string::npos);
    EXPECT_NE(plain.lost[1].find("1 further view"), std::string::npos);
    EXPECT_NE(plain.lost[2].find("two faces in one plane"), std::string::npos);
    EXPECT_TRUE(plainScene(*builtIn("sphere-on-plane")).lost.empty());
}

} // namespace
} // namespace shadowlab::foreign
