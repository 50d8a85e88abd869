// The rays that are shown begin and end where those of the picture do.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/ray_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::ray_tracing {
namespace {

/// A ball over a large floor, seen so that its shadow lies in the middle of the picture.
scene::Scene ballScene() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(0.5, 128), testing::translation({0, 1.5, 0}));
    scene.lights = {testing::pointLight({0.5, 6, 0})};
    return scene;
}

struct Rays {
    std::vector<SceneShape> shapes;
    explicit Rays(const scene::Scene& scene) {
        trace::SceneTracer tracer;
        EXPECT_TRUE(tracer.advance(testing::snapshot(scene), Deadline::max()));
        View view;
        view.camera = scene.camera;
        view.size = {320, 240};
        shapes = rayShapes(tracer, view, 0);
    }
    [[nodiscard]] const std::vector<dvec3>& of(std::size_t shape) const { return shapes.at(shape).pointsWorld; }
};

TEST(RayShapes, BeginAtTheEyeAndEndAtLightOrBlocker) {
    for (const dvec3 offset : {dvec3(0), dvec3(1e6, 0, 1e6)}) {
        const scene::Scene scene = testing::moved(ballScene(), offset);
        const Rays rays(scene);
        ASSERT_EQ(rays.shapes.size(), 3u);
        const auto &eye = rays.of(0), &arriving = rays.of(1), &blocked = rays.of(2);
        EXPECT_GE(eye.size(), 2u * 15);
        EXPECT_GE(arriving.size(), 2u * 10);
        EXPECT_GE(blocked.size(), 2u * 2);
        EXPECT_LE(arriving.size() + blocked.size(), eye.size());
        for (std::size_t i = 0; i < eye.size(); i += 2)
            EXPECT_EQ(eye[i], scene.camera.positionWorld);
        for (const auto* shadowRays : {&arriving, &blocked})
            for (std::size_t i = 0; i < shadowRays->size(); i += 2)
                EXPECT_NE(std::ranges::find(eye, (*shadowRays)[i]), eye.end()) << "not where an eye ray ends";
        for (std::size_t i = 1; i < arriving.size(); i += 2)
            EXPECT_EQ(arriving[i], scene.lights[0].positionWorld);
        for (std::size_t i = 0; i < blocked.size(); i += 2) {
            EXPECT_NEAR(blocked[i].y, 0, 1e-9); // from the floor
            // To the ball: 64 segments from pole to pole lie up to 0.5 (1 - cos(pi / 128)) = 2e-4 inside it, the quads
            // between them somewhat more.
            EXPECT_NEAR(glm::length(blocked[i + 1] - offset - dvec3(0, 1.5, 0)), 0.5, 1e-3);
            // And to the side that is turned to the floor, where the ray first meets it.
            EXPECT_LT(blocked[i + 1].y, 1.5 + 0.1);
        }
    }
}

TEST(RayShapes, TowardTheSunEndBeyondTheScene) {
    scene::Scene scene = ballScene();
    scene.lights = {testing::directionalLight({0.3, -1, 0.1})};
    const Rays rays(scene);
    const auto& arriving = rays.of(1);
    ASSERT_GE(arriving.size(), 2u * 10);
    EXPECT_GE(rays.of(2).size(), 2u);
    for (std::size_t i = 0; i < arriving.size(); i += 2) {
        const dvec3 way = arriving[i + 1] - arriving[i];
        EXPECT_GT(glm::dot(glm::normalize(way), -scene.lights[0].directionWorld), 1 - 1e-12);
        EXPECT_LT(glm::length(way), 10 * std::sqrt(2.0) + 2.0); // the floor's diagonal, and what is over it
        const bool leaves = arriving[i + 1].y > 2 || std::abs(arriving[i + 1].x) > 5 || std::abs(arriving[i + 1].z) > 5;
        EXPECT_TRUE(leaves);
    }
}

TEST(RayShapes, WhatIsTurnedAwaySendsNone) {
    scene::Scene scene = ballScene();
    scene.lights[0].positionWorld = {0, -3, 0}; // below the floor
    EXPECT_TRUE(Rays(scene).of(1).empty());
    EXPECT_GE(Rays(scene).of(0).size(), 2u * 15);
    scene = ballScene();
    scene.objects[0].receivesShadow = false;
    EXPECT_TRUE(Rays(scene).of(2).empty());
}

} // namespace
} // namespace shadowlab::ray_tracing
