// Depth-pass shadow volumes: right wherever the eye and its near plane are in no volume, wrong elsewhere, as the textbook
// has it; and what a camera outside sees of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::HardClass;
using testing::kTiePx;
using testing::TruthComparison;
using ZPassTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};
const std::string kZPass = "shadow-volume-zpass", kZFail = "shadow-volume-zfail";

// As for depth fail: isolated pixels at cracks between sides.
constexpr double kCrackShare = 3e-5;

scene::Snapshot builtIn(const std::string& name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

/// Does a triangle of a caster lie between the point and the light? Möller and Trumbore 1997, in double.
bool inShadow(const scene::Scene& scene, const dvec3& pointWorld, const scene::Light& light) {
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    const dvec3 way = dvec3(lightWorld) - pointWorld * lightWorld.w;
    const double length = lightWorld.w == 0 ? 1e300 : 1.0;
    for (const scene::Object& object : scene.objects) {
        if (!object.castsShadow) continue;
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        const auto corner = [&](std::uint32_t v) {
            return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[v]));
        };
        for (const uvec3& t : object.mesh->triangles) {
            const dvec3 a = corner(t.x), u = corner(t.y) - a, v = corner(t.z) - a, p = glm::cross(way, v);
            const double determinant = glm::dot(u, p);
            if (determinant == 0) continue;
            const dvec3 s = pointWorld - a, q = glm::cross(s, u);
            const double alpha = glm::dot(s, p) / determinant, beta = glm::dot(way, q) / determinant;
            const double at = glm::dot(v, q) / determinant;
            if (alpha >= 0 && beta >= 0 && alpha + beta <= 1 && at > 0 && at < length) return true;
        }
    }
    return false;
}

/// Asked at a grid over the near plane: is the near-clip pyramid free of casters?
bool nearPlaneIsLit(const scene::Scene& scene) {
    const scene::Camera& camera = scene.camera;
    for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x) {
            const dvec3 direction = scene::rayDirectionWorld(camera, dvec2(kSize) * dvec2(x / 4.0, y / 4.0), kSize);
            const dvec3 axis = glm::normalize(camera.targetWorld - camera.positionWorld);
            const dvec3 point = camera.positionWorld + direction * (camera.near / glm::dot(direction, axis));
            if (inShadow(scene, point, scene.lights[0])) return false;
        }
    return true;
}

// The claim of the default, and no more: it is right from outside.
TEST_F(ZPassTest, IsExactUpToCracksWhereTheNearPlaneIsLit) {
    const int perClass = std::getenv("SHADOWLAB_LONG") ? 100 : 8;
    TruthComparison all;
    int scenes = 0;
    for (const bool directional : {false, true})
        for (const HardClass hardClass : testing::kHardClasses)
            for (int i = 0; i < perClass; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, static_cast<unsigned>(i), directional);
                if (!nearPlaneIsLit(scene)) continue;
                const TruthComparison one = compareWithTruth(testing::snapshot(scene), kZPass, {}, kSize, 0, kTiePx);
                if (one.wrong() > 3) std::cout << toText(hardClass) << " scene " << i << ": " << one << "\n";
                all += one;
                ++scenes;
            }
    std::cout << scenes << " scenes: " << all << "\n";
    EXPECT_GE(scenes, 20);
    EXPECT_GT(all.lit, 20000);
    EXPECT_GT(all.shadowed, 20000);
    EXPECT_LE(all.wrong(), kCrackShare * all.compared) << all;
}

TEST_F(ZPassTest, FailsWithTheEyeInAVolumeWhereDepthFailHolds) {
    const scene::Snapshot snapshot = builtIn("eye-in-shadow");
    const TruthComparison zpass = compareWithTruth(snapshot, kZPass, {}, {160, 90}, 0, kTiePx);
    const TruthComparison zfail = compareWithTruth(snapshot, kZFail, {}, {160, 90}, 0, kTiePx);
    EXPECT_GT(zfail.lit, 3000);
    EXPECT_GT(zfail.shadowed, 3000);
    EXPECT_EQ(zfail.wrong(), 0) << zfail;
    EXPECT_GT(zpass.falseShadow, zpass.lit / 2) << zpass;
    EXPECT_GT(zpass.falseLit, zpass.shadowed / 2) << zpass;
}

TEST_F(ZPassTest, FailsWhereTheNearPlaneCutsAVolumeWhereDepthFailHolds) {
    // A plate beside the eye shades what the eye sees through its volume; the eye itself is in the light.
    scene::Scene scene = testing::floorScene();
    scene.camera.positionWorld = {0, 1, 4};
    scene.camera.targetWorld = {0, 0, -2};
    testing::addObject(scene, scene::makeBox({4, 0.25, 1}), testing::translation({0, 2.5, 2.5}));
    scene.lights.push_back(testing::directionalLight({0, -1, 0.125}));
    ASSERT_FALSE(inShadow(scene, scene.camera.positionWorld, scene.lights[0]));
    for (const double near : {0.125, 1.25}) {
        scene.camera.near = near;
        const TruthComparison zpass = compareWithTruth(testing::snapshot(scene), kZPass, {}, {320, 240}, 0, kTiePx);
        const TruthComparison zfail = compareWithTruth(testing::snapshot(scene), kZFail, {}, {320, 240}, 0, kTiePx);
        EXPECT_GT(zfail.lit, 5000);
        EXPECT_GT(zfail.shadowed, 5000);
        EXPECT_LE(zfail.wrong(), 2) << zfail;
        EXPECT_EQ(zpass.wrong() <= 2, near < 1) << near << ": " << zpass;
        EXPECT_EQ(zpass.wrong() > 1000, near > 1) << near << ": " << zpass;
    }
}

// The volumes end where the scene does. An eye beyond that looks into them through the bottom.
TEST_F(ZPassTest, IsExactFromBeyondTheEndOfTheVolumes) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({2, 1.5, 1}), testing::translation({0, 0.75, 0}));
    testing::addObject(scene, scene::makeSphere(0.5, 24), testing::translation({-2, 0.75, 1}));
    scene.camera.positionWorld = {4, 1.5, 12};
    scene.camera.targetWorld = {-0.5, 0.5, 2};
    scene.camera.fovYDegrees = 30;
    for (const scene::Light& light : {testing::directionalLight({0, -0.1, 1}), testing::pointLight({0, 1.75, -6})}) {
        scene.lights = {light};
        ASSERT_FALSE(inShadow(scene, scene.camera.positionWorld, light));
        const TruthComparison sum = compareWithTruth(testing::snapshot(scene), kZPass, {}, {320, 240}, 0, kTiePx);
        EXPECT_GT(sum.lit, 1000);
        EXPECT_GT(sum.shadowed, 1000);
        EXPECT_LE(sum.wrong(), 2) << sum;
    }
}

TEST_F(ZPassTest, TwoPassesGiveTheSamePixelsAsOne) {
    for (const HardClass hardClass : testing::kHardClasses) {
        const auto scene = testing::snapshot(testing::hardScene(hardClass, 3, false));
        const auto one = testing::renderVisibility(scene, kZPass, {}, kSize, 0);
        const auto two = testing::renderVisibility(scene, kZPass, {"two-sided=false"}, kSize, 0);
        EXPECT_EQ(one.greyAlpha, two.greyAlpha) << toText(hardClass);
    }
}

TEST_F(ZPassTest, WithoutWrappingItLosesCounts) {
    const auto snapshot = builtIn("still-life");
    const TruthComparison sum = compareWithTruth(snapshot, kZPass, {"wrap=false"}, {160, 90}, 0, kTiePx);
    EXPECT_GT(sum.wrong(), 20) << sum;
}

TEST_F(ZPassTest, FromOutsideOneSeesVolumesSilhouettesAndTheNearClipPyramid) {
    for (const scene::Light& light : {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25})})
        for (const std::string& id : {kZPass, kZFail}) {
            scene::Scene scene = testing::simpleScene();
            scene.lights = {light};
            const auto snapshot = testing::snapshot(scene);
            picture::Slot slot = picture::Session::makeSlot(id);
            while (!slot.technique->prepare(snapshot, Deadline::max()).converged) {
            }
            const View view{.camera = scene.camera, .size = kSize, .region = {}};
            const std::vector<SceneShape> shapes = slot.technique->shapes(snapshot, view, 0);
            const auto named = [&](const std::string& label) {
                std::vector<dvec3> pointsWorld; // each caster has a shape of its own
                for (const SceneShape& shape : shapes)
                    if (shape.label == label)
                        pointsWorld.insert(pointsWorld.end(), shape.pointsWorld.begin(), shape.pointsWorld.end());
                return pointsWorld;
            };
            EXPECT_GT(named("silhouette").size(), 40u);
            EXPECT_GE(named("sides").size(), 3 * named("silhouette").size()); // two triangles an edge
            EXPECT_EQ(named("top cap").empty(), id == kZPass);
            EXPECT_EQ(named("bottom cap").empty(), id == kZPass);
            const std::vector<dvec3> pyramid = named("near-clip pyramid");
            ASSERT_EQ(pyramid.size(), 16u);
            EXPECT_NEAR(glm::length(pyramid[0] - scene.camera.positionWorld), scene.camera.near, scene.camera.near);
            if (light.type == scene::LightType::point) {
                EXPECT_EQ(pyramid[3], light.positionWorld);
            }
            for (const SceneShape& shape : shapes)
                for (const dvec3& point : shape.pointsWorld)
                    ASSERT_LT(glm::length(point), 20) << shape.label; // the floor reaches to 7
        }
}

} // namespace
} // namespace shadowlab
