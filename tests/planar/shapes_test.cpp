// What the outside camera is given to show: planes with their outlines, and rays that end on a plane.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/registry.h"
#include "techniques/technique.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

TEST(PlanarShapes, RaysGoFromTheLightToTheFloor) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const auto technique = findTechnique("planar").make();
    while (!technique->prepare(snapshot, Deadline::max()).converged) {
    }
    View view;
    view.camera = scene.camera;
    for (const int light : {0, 1}) {
        const std::vector<SceneShape> shapes = technique->shapes(snapshot, view, light);
        ASSERT_EQ(shapes.size(), 3u);
        // The floor and what the eye can see of the box: four faces of four edges and two triangles.
        EXPECT_EQ(shapes[0].pointsWorld.size(), 4u * 4 * 2);
        EXPECT_EQ(shapes[1].pointsWorld.size(), 4u * 2 * 3);
        const std::vector<dvec3>& rays = shapes[2].pointsWorld;
        EXPECT_EQ(rays.size(), 2u * 3 * 4) << "four of box, ball and torus each";
        const dvec4 lightWorld = scene::homogeneousPositionWorld(scene.light(light));
        for (std::size_t i = 0; i < rays.size(); i += 2) {
            EXPECT_NEAR(rays[i + 1].y, 0, 1e-9);
            const dvec3 toLight = glm::normalize(dvec3(lightWorld) - lightWorld.w * rays[i + 1]);
            EXPECT_NEAR(glm::length(glm::cross(toLight, rays[i] - rays[i + 1])), 0, 1e-9);
        }
    }
    EXPECT_EQ(technique->shapes(snapshot, view, kNoLight).size(), 2u);
}

} // namespace
} // namespace shadowlab
