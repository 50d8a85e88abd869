// What lamps cover of the patches that they lie in.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamp_cover.h"

#include <gtest/gtest.h>

#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// The area that the lamp covers of the walls of a room of 3 x 2 x 4 m.
double coveredArea(const scene::Light& lamp) {
    const Room room(emptyRoom({3, 2, 4}), 0.3);
    double area = 0;
    int parts = 0;
    for (const Patch& patch : room.patches) {
        const double covered = coveredByLamps(patch, std::span(&lamp, 1), room.originWorld);
        EXPECT_GE(covered, 0);
        EXPECT_LE(covered, 1);
        parts += covered > 0 && covered < 1;
        area += covered * patch.area;
    }
    EXPECT_EQ(parts > 3, area > 0) << "patches of 0.3 m have their borders elsewhere";
    return area;
}

/// One of 0.5 x 0.4 m, below the ceiling by so much.
double coveredArea(double below, bool shinesDown = true) {
    scene::Light lamp;
    lamp.type = scene::LightType::rect;
    lamp.positionWorld = {1.43, 2 - below, 2.21};
    lamp.edgeUWorld = {shinesDown ? 0.5 : -0.5, 0, 0};
    lamp.edgeVWorld = {0, 0, 0.4};
    return coveredArea(lamp);
}

TEST(LampCover, IsWhatLiesStraightBehind) {
    EXPECT_NEAR(coveredArea(0), 0.2, 1e-6);
    EXPECT_NEAR(coveredArea(0.02), 0.2, 1e-6);
    EXPECT_EQ(coveredArea(0.3), 0) << "light gets in between";
    EXPECT_EQ(coveredArea(0.02, false), 0) << "it shines at the ceiling";
}

// A circle, whether the ball's middle is in the room or behind the ceiling.
TEST(LampCover, OfABallIsWhatLiesWithinIt) {
    scene::Light ball;
    ball.type = scene::LightType::sphere;
    ball.radius = 0.25;
    for (const double below : {0.0, 0.2, -0.2}) {
        ball.positionWorld = {1.43, 2 - below, 2.21};
        EXPECT_NEAR(coveredArea(ball), glm::pi<double>() * (0.25 * 0.25 - below * below), 1e-6) << "corners are floats";
    }
    ball.positionWorld.y = 1.7;
    EXPECT_EQ(coveredArea(ball), 0);
}

// Where light is the same everywhere and in all directions, a body meets as much of it as its surface has of the walls'.
TEST(LampCover, LampsInAFurnaceCatchTheirShareOfItsSurface) {
    const dvec3 size{3, 2, 4};
    const Room room(emptyRoom(size), 0.1);
    const double walls = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
    const std::vector<dvec3> radiosity(room.patches.size(), dvec3(0.7));
    scene::Light ball, panel, point;
    ball.type = scene::LightType::sphere;
    ball.positionWorld = {1.2, 1.1, 1.9};
    ball.radius = 0.4;
    panel.type = scene::LightType::rect;
    panel.positionWorld = {1.6, 0.9, 2.3};
    panel.edgeUWorld = {0.6, 0.1, 0};
    panel.edgeVWorld = {0, 0.1, 0.8};
    const double ofBall = 4 * glm::pi<double>() * ball.radius * ball.radius / walls;
    const double ofPanel = 2 * glm::length(glm::cross(panel.edgeUWorld, panel.edgeVWorld)) / walls;
    const auto caught = [&](const std::vector<scene::Light>& lights) { return caughtByLamps(room.patches, radiosity, lights, room.originWorld); };
    EXPECT_NEAR(caught({ball}), ofBall, 0.002 * ofBall); // by the centres of patches of 0.1 m
    EXPECT_NEAR(caught({panel}), ofPanel, 0.002 * ofPanel);
    EXPECT_NEAR(caught({ball, panel, point}), ofBall + ofPanel, 0.002 * (ofBall + ofPanel));
    EXPECT_EQ(caught({point}), 0);
}

} // namespace
} // namespace shadowlab::radiosity
