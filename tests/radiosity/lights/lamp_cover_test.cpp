// What lamps cover of the patches that they lie in.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamp_cover.h"

#include <gtest/gtest.h>

#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// The area of the ceiling of a room of 3 x 2 x 4 m that a lamp of 0.5 x 0.4 m covers, below it by so much.
double coveredArea(double below, bool shinesDown = true) {
    const Room room(emptyRoom({3, 2, 4}), 0.3);
    scene::Light lamp;
    lamp.type = scene::LightType::rect;
    lamp.positionWorld = {1.43, 2 - below, 2.21};
    lamp.edgeUWorld = {shinesDown ? 0.5 : -0.5, 0, 0};
    lamp.edgeVWorld = {0, 0, 0.4};
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

TEST(LampCover, IsWhatLiesStraightBehind) {
    EXPECT_NEAR(coveredArea(0), 0.2, 1e-6);
    EXPECT_NEAR(coveredArea(0.02), 0.2, 1e-6);
    EXPECT_EQ(coveredArea(0.3), 0) << "light gets in between";
    EXPECT_EQ(coveredArea(0.02, false), 0) << "it shines at the ceiling";
}

} // namespace
} // namespace shadowlab::radiosity
