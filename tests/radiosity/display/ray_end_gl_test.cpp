// What the surface at the end of a gather ray sends, held against paths: near shadows, cones of light and contacts, where a patch's mean is wrong.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/area_lights.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"

namespace shadowlab {
namespace {

using RadiosityRayEndTest = testing::GlTest;

/// The mean of a picture by gathering, over that by paths: 1 but for chance, which is a hundredth with a million rays each if one of a hundred
/// meets what is bright.
double gatheredOverPaths(const scene::Scene& scene, ivec2 size, const std::string& patches = "patches=6") {
    const auto mean = [&](const std::string& technique, const std::vector<std::string>& settings) {
        double sum = 0;
        for (const vec4& texel : testing::TechniqueSlot(technique, testing::snapshot(scene)).radiance(settings, size))
            sum += static_cast<double>(texel.g);
        return sum / (size.x * size.y);
    };
    const double paths = mean("ray-traced", {"samples=1024", "interreflection=true", "antialias=false"});
    EXPECT_GT(paths, 1e-4) << "the picture is not black";
    return mean("radiosity", {patches, "gather=pixels", "gather-samples=1024"}) / paths;
}

// A floor of one patch, of which a spot with a hard edge reaches a hundredth. The wall beside sees the floor outside the cone, which is dark.
TEST_F(RadiosityRayEndTest, BesideTheConeOfASpotNothingIsSent) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.materials[0].diffuse = vec3(0.5f);
    testing::addObject(scene, scene::makeQuad({8, 8}), dmat4(1));
    testing::addObject(scene, scene::makeQuad({2, 8}), glm::rotate(testing::translation({4, 1, 0}), glm::radians(90.0), dvec3(0, 0, 1)));
    scene.lights.push_back(testing::pointLight({0, 3, 0}));
    scene.lights[0].type = scene::LightType::spot;
    scene.lights[0].directionWorld = {0, -1, 0};
    scene.lights[0].coneDegrees = 18;
    scene.lights[0].edgeDegrees = 0;
    scene.camera.positionWorld = {1, 1, 0};
    scene.camera.targetWorld = {4, 1, 0};
    scene.camera.fovYDegrees = 30;
    EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}), 1, 0.03) << "without a look at the cone it is fifty times as bright";
}

/// A tile that hangs above a floor of one patch. Its shadow is so small that none of the lines to that patch may be in it; but it is most of
/// what the tile's underside sees.
scene::Scene tileAboveAFloor(const scene::Light& light) {
    scene::Scene scene;
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.materials[1].diffuse = vec3(0.05f); // what it sends back is a mean of the whole floor for the patch, and so lost
    testing::addObject(scene, scene::makeQuad({8, 8}), dmat4(1));
    testing::addObject(scene, scene::makeBox({0.3, 0.02, 0.3}), testing::translation({0.1, 0.2, 0.1}));
    scene.objects[1].partMaterials = {1};
    scene.lights.push_back(light);
    scene.camera.positionWorld = {0.1, 0.02, 0.101};
    scene.camera.targetWorld = {0.1, 0.19, 0.1};
    scene.camera.fovYDegrees = 60;
    return scene;
}

TEST_F(RadiosityRayEndTest, ASmallShadowOnALargePatchIsSeenFromNearby) {
    EXPECT_NEAR(gatheredOverPaths(tileAboveAFloor(testing::directionalLight({0, -1, 0})), {32, 32}), 1, 0.03)
        << "with the floor taken for lit, because all lines arrive, it is 1.6";
}

// The same of lights with an area, which besides light the middle of the floor more than its mean.
TEST_F(RadiosityRayEndTest, SoASoftOneOfALightWithAnArea) {
    scene::Light panel = testing::rectLight({0.1, 3, 0.1}, {0.3, 0, 0}, {0, 0, 0.3}), ball = testing::sphereLight({0.1, 3, 0.1}, 0.15);
    panel.intensity = ball.intensity = 30;
    EXPECT_NEAR(gatheredOverPaths(tileAboveAFloor(panel), {32, 32}), 1, 0.03) << "a panel";
    EXPECT_NEAR(gatheredOverPaths(tileAboveAFloor(ball), {32, 32}), 1, 0.03) << "a ball";
}

// Where a ball stands on a floor it is dark, and what patches of ball and floor send there is the mean of much that is brighter.
TEST_F(RadiosityRayEndTest, UnderABallItIsAsDarkAsItIs) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.materials[0].specular = vec3(0);
    testing::addObject(scene, scene::makeQuad({4, 4}), dmat4(1));
    testing::addObject(scene, scene::makeSphere(0.4, 64), testing::translation({0, 0.4, 0}));
    scene.lights.push_back(testing::rectLight({0, 2.7, 0}, {3, 0, 0}, {0, 0, 3}));
    scene.lights[0].intensity = 2;
    scene.camera.positionWorld = {1.3, 0.15, 0.001};
    scene.camera.targetWorld = {0, 0.05, 0};
    scene.camera.fovYDegrees = 8;
    EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}, "patches=300"), 1, 0.03) << "by the means of patches it is too bright";
}

// Rays that go on several times choose each direction anew. In a room of one patch for each wall all of them do.
TEST_F(RadiosityRayEndTest, EveryReflectionGoesItsOwnWay) {
    scene::Scene scene;
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.materials[1].emission = vec3(1.0f);
    testing::addObject(scene, scene::makeBox({2, 2, 2}), dmat4(1));
    testing::addObject(scene, scene::makeQuad({2, 2}), glm::rotate(testing::translation({0, 0.99, 0}), glm::radians(180.0), dvec3(1, 0, 0))); // a ceiling that glows
    scene.objects[1].partMaterials = {1};
    scene.camera.positionWorld = {0, 0, 0.5};
    scene.camera.targetWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 60;
    scene.camera.near = 0.01;
    // Half of all rays meet what glows, so that a million of them are right to a thousandth.
    EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}), 1, 0.005) << "where one direction goes with the next it is 0.94";
}

// A panel that shines at a wall 3 cm behind it. What gets out comes from near its outline, where the wall is darker than the patches behind the panel.
TEST_F(RadiosityRayEndTest, OfAGapComesWhatItsBorderSends) {
    scene::Scene scene = testing::emptyRoom({1.6, 1.6, 1.6});
    scene.materials.resize(2);
    scene.materials[0].diffuse = vec3(0.6f);
    scene.materials[1].diffuse = vec3(0.3f);
    scene.materials[1].emission = vec3(1);
    testing::addObject(scene, scene::makeQuad({0.9, 0.6}), glm::rotate(testing::translation({0.03, 0.8, 0.8}), glm::radians(90.0), dvec3(0, 0, 1))).partMaterials = {1};
    scene.camera.positionWorld = {0.8, 0.8, 0.8};
    scene.camera.targetWorld = {1.6, 0.8, 0.801};
    scene.camera.fovYDegrees = 80;
    scene.camera.near = 0.01;
    for (const std::string patches : {"patches=150", "patches=600"})
        EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}, patches), 1, 0.03) << "by the means of patches, and without paths, it is 1.19 and 1.14";
}

// A chessboard of which few patches are left, each of several squares. What is sent from nearby is that of the square, in its colour and its shadow.
TEST_F(RadiosityRayEndTest, SquaresOfASimplifiedBoardKeepColourAndShadow) {
    scene::Scene scene = *scene::loadScene("mirror-and-glass", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    for (scene::Material& material : scene.materials) { // dull, as radiosity takes it
        scene::Material dull;
        dull.name = material.name;
        dull.diffuse = material.diffuse;
        dull.ofMesh = material.ofMesh;
        material = dull;
    }
    scene.camera.fovYDegrees = 0.5;
    scene.camera.targetWorld = {0.034, 0, 0.354};
    EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}, "patches=600"), 1, 0.03) << "below the red ball; with the colours of squares mixed it is 0.90";
    scene.camera.targetWorld = {-0.008, 0, -0.002};
    EXPECT_NEAR(gatheredOverPaths(scene, {32, 32}, "patches=600"), 1, 0.03) << "below the blue ball, in a shadow; with the shadows of patches it is 1.9";
}

} // namespace
} // namespace shadowlab
