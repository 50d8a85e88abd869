// The eye and the lights as lines, and lines as they lie in a picture.
// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/picture/outside/shape_painter.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "tests/support/scenes.h"

namespace shadowlab::picture {
namespace {

constexpr ivec2 kSize{320, 240};

bool holds(const std::vector<dvec3>& points, const dvec3& point, double tolerance) {
    return std::ranges::any_of(points, [&](const dvec3& p) { return glm::length(p - point) <= tolerance; });
}

View viewOf(const scene::Scene& scene) {
    View view;
    view.camera = scene.camera;
    view.size = kSize;
    return view;
}

/// At the origin, looking down -z: 90 degrees high, one metre to the near plane.
scene::Camera plainCamera() {
    scene::Camera camera;
    camera.positionWorld = {0, 0, 0};
    camera.targetWorld = {0, 0, -1};
    camera.fovYDegrees = 90;
    camera.near = 1;
    return camera;
}

TEST(OutsideShapes, TheEyeSeesAllThingsAndEndsSoonBehindThem) {
    const scene::Scene scene = testing::simpleScene();
    const View view = viewOf(scene);
    const std::vector<SceneShape> eye = eyeShapes(scene, view);
    ASSERT_EQ(eye.size(), 2u);
    EXPECT_EQ(eye[0].pointsWorld.size(), 2u * (4 + 4));
    EXPECT_EQ(eye[1].pointsWorld.size(), 2u * 4);
    const double depth = shownDepth(scene, view);
    for (const dvec3& corner : scene::viewCorners(view.camera, 4.0 / 3, depth))
        EXPECT_TRUE(holds(eye[0].pointsWorld, corner, 1e-12));
    for (const dvec3& corner : scene::viewCorners(view.camera, 4.0 / 3, view.camera.near))
        EXPECT_TRUE(holds(eye[1].pointsWorld, corner, 1e-12));
    EXPECT_TRUE(holds(eye[0].pointsWorld, view.camera.positionWorld, 0));

    double farthest = 0;
    const scene::Bounds things = scene::thingsBounds(scene);
    for (int i = 0; i < 8; ++i)
        farthest = std::max(farthest, -transformPoint(scene::viewFromWorld(view.camera), things.corner(i)).z);
    EXPECT_GT(depth, farthest);
    EXPECT_LT(depth, 1.2 * farthest);

    scene::Scene wide = scene; // a floor to the horizon
    wide.objects[0].mesh = std::make_shared<const scene::Mesh>(scene::makeQuad({1e5, 1e5}));
    EXPECT_DOUBLE_EQ(shownDepth(wide, view), depth);
    wide.camera.targetWorld = wide.camera.positionWorld + dvec3(0, 0, 3); // away from everything: as far as it looks
    EXPECT_DOUBLE_EQ(shownDepth(wide, viewOf(wide)), 1.1 * 3);
}

TEST(OutsideShapes, EveryKindOfLightHasASign) {
    scene::Scene scene = testing::simpleScene();
    const scene::Bounds things = scene::thingsBounds(scene);
    const scene::Camera outside = scene::outsideCameraFor(scene, scene.camera);
    scene::Light light = testing::pointLight({2, 5, 3});
    light.directionWorld = glm::normalize(dvec3(-1, -2, 0.5));
    std::vector<std::vector<dvec3>> signs;
    using enum scene::LightType;
    for (const scene::LightType type : {point, directional, spot, rect, sphere}) {
        light.type = type;
        scene.lights = {light};
        const auto shapes = lightShapes(scene, things, 0, outside);
        ASSERT_EQ(shapes.size(), 1u);
        EXPECT_EQ(shapes[0].colorLinear, look::kChosenLight);
        EXPECT_EQ(shapes[0].label, "light point");
        EXPECT_EQ(shapes[0].pointsWorld.size() % 2, 0u);
        EXPECT_GE(shapes[0].pointsWorld.size(), 2u * 8);
        for (const std::vector<dvec3>& other : signs)
            EXPECT_NE(shapes[0].pointsWorld, other);
        signs.push_back(shapes[0].pointsWorld);
    }
    // A sphere's outline lies on it, a rect's corners are its own.
    for (const dvec3& p : signs[4])
        EXPECT_NEAR(glm::length(p - light.positionWorld), light.radius, 1e-12);
    EXPECT_TRUE(holds(signs[3], light.positionWorld + 0.5 * (light.edgeUWorld - light.edgeVWorld), 1e-12));
    // A spot's cone opens by its own angle.
    for (const dvec3& p : signs[2])
        if (p != light.positionWorld) {
            const double cosine = glm::dot(glm::normalize(p - light.positionWorld), light.directionWorld);
            EXPECT_NEAR(cosine, std::cos(glm::radians(light.coneDegrees / 2)), 1e-12);
        }
}

TEST(OutsideShapes, OtherLightsAreGrey) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::pointLight({-2, 3, 0}));
    scene.lights.push_back(testing::directionalLight({0, -1, 0}));
    const scene::Bounds things = scene::thingsBounds(scene);
    const auto shapes = lightShapes(scene, things, 2, scene.camera);
    ASSERT_EQ(shapes.size(), 2u);
    EXPECT_EQ(shapes[0].colorLinear, look::kOtherLight);
    EXPECT_EQ(shapes[1].label, "light sun");
    EXPECT_EQ(lightShapes(scene, things, kNoLight, scene.camera).size(), 1u);
    scene.lights.clear();
    EXPECT_TRUE(lightShapes(scene, things, kNoLight, scene.camera).empty());
}

TEST(ProjectSegments, PutsPointsWhereThePictureHasThem) {
    // At depth 2 the picture is 4 high and 16/3 wide: a metre is 60 pixels.
    const std::vector<dvec3> points = {{0, 0, -2}, {1, 0.5, -2}};
    const auto segments = projectSegments(points, plainCamera(), kSize);
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_LT(glm::length(vec2(segments[0].from) - vec2(160, 120)), 1e-4f);
    EXPECT_LT(glm::length(vec2(segments[0].to) - vec2(220, 150)), 1e-4f);
    EXPECT_NEAR(segments[0].from.z, 1 - 2 * 1.0 / 2, 1e-6); // depth with the far plane at infinity: 1 - 2 near / z
}

TEST(ProjectSegments, CutsWhatLiesBehindTheCamera) {
    const scene::Camera camera = plainCamera();
    const std::vector<dvec3> behind = {{0, 0, 2}, {1, 0, 5}, {0, 0, -0.5}, {0.2, 0, -0.99}};
    EXPECT_TRUE(projectSegments(behind, camera, kSize).empty());

    const std::vector<dvec3> through = {{0, 0.5, 10}, {0, 0.5, -4}}; // enters the view at (0, 0.5, -1)
    const auto segments = projectSegments(through, camera, kSize);
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_LT(glm::length(segments[0].from - vec3(160, 180, -1)), 1e-4f);
    EXPECT_LT(glm::length(vec2(segments[0].to) - vec2(160, 135)), 1e-4f);
    // Projected without the cut, the point behind would be upside down: below the middle instead of above.
    const dvec4 clip = scene::clipFromView(camera, 4.0 / 3) * dvec4(through[0], 1.0);
    EXPECT_LT(clip.y / clip.w, 0);
}

TEST(ProjectSegments, KeepsLongLinesWithinReachOfFloat) {
    const std::vector<dvec3> points = {{-1e9, 0, -3}, {1e9, 0, -3}, {5e6, 0, -3}, {5e6, 1, -3}};
    const auto segments = projectSegments(points, plainCamera(), kSize);
    ASSERT_EQ(segments.size(), 1u); // the other one lies beside the picture
    EXPECT_NEAR(segments[0].from.x, 160 - 1.5 * 160, 1e-3);
    EXPECT_NEAR(segments[0].to.x, 160 + 1.5 * 160, 1e-3);
    EXPECT_NEAR(segments[0].from.y, 120, 1e-3);
}

} // namespace
} // namespace shadowlab::picture
