// Which objects can be left out because nothing lies in their shadow, and which must not.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/casters.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using Indices = std::vector<std::size_t>;

TEST(UsefulCasters, AFloorWithEverythingAboveItShadowsNothing) {
    scene::Scene scene = testing::simpleScene();
    EXPECT_EQ(scene::usefulCasters(scene, scene.lights[0]), (Indices{1, 2, 3}));
    EXPECT_EQ(scene::usefulCasters(scene, testing::directionalLight({0, -1, 0})), (Indices{1, 2, 3}));
}

TEST(UsefulCasters, AFloorWithTheLightBelowShadowsEverything) {
    const scene::Scene scene = testing::simpleScene();
    EXPECT_EQ(scene::usefulCasters(scene, testing::pointLight({0, -3, 0})), (Indices{0, 1, 2, 3}));
}

TEST(UsefulCasters, AFloorThatSomethingReachesThroughIsKept) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[1].worldFromObject = testing::translation({0, 0.4, 0});
    EXPECT_EQ(scene::usefulCasters(scene, scene.lights[0]), (Indices{0, 1, 2, 3}));
}

TEST(UsefulCasters, WhatDoesNotCastIsNoCaster) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[2].castsShadow = false;
    EXPECT_EQ(scene::allCasters(scene), (Indices{0, 1, 3}));
    EXPECT_EQ(scene::usefulCasters(scene, scene.lights[0]), (Indices{1, 3}));
}

} // namespace
} // namespace shadowlab
