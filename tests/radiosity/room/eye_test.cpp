// One eye stands for all near it.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/eye.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/radiosity/room_row.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr ivec2 kSize(160, 90);
constexpr double kRoomWidth = 3;

/// A box with that diagonal, metres, a sixteenth of which is a step of places. It begins where the rooms do.
trace::CentredBox boxOfDiagonal(double diagonal, const trace::SceneTracer& tracer) {
    trace::CentredBox box;
    box.include(-tracer.world().originWorld);
    box.include(-tracer.world().originWorld + dvec3(diagonal, 0, 0));
    return box;
}

trace::SceneTracer tracerOf(const scene::Scene& scene) {
    trace::SceneTracer tracer;
    EXPECT_TRUE(tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max()));
    return tracer;
}

dvec3 directionOf(const scene::Camera& camera) { return glm::normalize(camera.targetWorld - camera.positionWorld); }

// In the middle of a room, 90 pictures one degree apart, then 90 a centimetre apart.
TEST(Eye, OneStandsForAllNearIt) {
    const scene::Scene scene = roomRow(1);
    const trace::SceneTracer tracer = tracerOf(scene);
    const dvec3 middle = placeOfRoom(0) + dvec3(0.5 * kRoomWidth, 1.2, 0.5 * kRoomDepth);
    std::vector<Eye> taken;
    for (int i = 0; i < 180; ++i) {
        const double turn = glm::radians(static_cast<double>(std::min(i, 90)));
        Eye eye{scene.camera, kSize};
        eye.camera.positionWorld = middle + dvec3(0.01 * std::max(0, i - 90), 0, 0);
        eye.camera.targetWorld = eye.camera.positionWorld + dvec3(std::cos(turn), -0.3, std::sin(turn));
        const Eye stands = inSteps(eye, boxOfDiagonal(8, tracer), tracer);
        EXPECT_LE(glm::distance(stands.camera.positionWorld, eye.camera.positionWorld), 0.25 * glm::root_three<double>() + 1e-12) << i;
        const double apart = glm::degrees(std::acos(glm::dot(directionOf(stands.camera), directionOf(eye.camera))));
        EXPECT_LE(2 * apart, stands.camera.fovYDegrees - eye.camera.fovYDegrees) << i << ": the picture is widened by as much";
        if (taken.empty() || taken.back() != stands) taken.push_back(stands);
    }
    EXPECT_LE(taken.size(), 20u) << "of 180 pictures";
    EXPECT_GE(taken.size(), 8u) << "it does go on";
}

// A scene that is moved as a whole, eye and all, has the same steps.
TEST(Eye, StepsMoveWithTheScene) {
    const trace::SceneTracer tracer = tracerOf(roomRow(1));
    const trace::CentredBox here = boxOfDiagonal(8, tracer);
    trace::CentredBox there = here;
    const dvec3 moved(0.3, -0.2, 0.1);
    there.lower += moved;
    there.upper += moved;
    Eye eye{inRoom(0), kSize};
    for (int i = 0; i < 20; ++i) {
        eye.camera.positionWorld.x = 0.81 + 0.049 * i;
        Eye other = eye;
        other.camera.positionWorld += moved;
        other.camera.targetWorld += moved;
        EXPECT_LT(glm::distance(inSteps(eye, here, tracer).camera.positionWorld + moved, inSteps(other, there, tracer).camera.positionWorld), 1e-12) << i;
    }
}

TEST(Eye, ItNeverGoesThroughAWall) {
    const scene::Scene scene = roomRow(2);
    const trace::SceneTracer tracer = tracerOf(scene);
    int kept = 0, moved = 0;
    for (int i = 0; i < 200; ++i) {
        Eye eye{inRoom(0), kSize};
        eye.camera.positionWorld = {0, 1.2, 2.2};
        eye.camera.positionWorld.x = 0.01 + i * (kRoomWidth - 0.02) / 200;
        const double x = inSteps(eye, boxOfDiagonal(16, tracer), tracer).camera.positionWorld.x; // steps of 1 m: walls are places of an eye
        EXPECT_GT(x, 0) << i;
        EXPECT_LT(x, kRoomWidth) << i;
        (x == eye.camera.positionWorld.x ? kept : moved)++;
    }
    EXPECT_GT(kept, 20);
    EXPECT_GT(moved, 20);
}

TEST(Eye, WhereThereIsNothingToSeeItStays) {
    const trace::SceneTracer tracer = tracerOf(roomRow(1));
    const Eye eye{inRoom(0), kSize};
    EXPECT_EQ(inSteps(eye, boxOfDiagonal(0, tracer), tracer), eye);
    EXPECT_EQ(inSteps(eye, trace::CentredBox{}, tracer), eye);
}

// A step of the direction may be that of "up".
TEST(Eye, ItAlwaysHasAView) {
    const trace::SceneTracer tracer = tracerOf(roomRow(1));
    Eye eye{inRoom(0), kSize};
    eye.camera.targetWorld = eye.camera.positionWorld + dvec3(0.02, -1, 0.03);
    ASSERT_TRUE(scene::hasView(eye.camera));
    EXPECT_TRUE(scene::hasView(inSteps(eye, boxOfDiagonal(8, tracer), tracer).camera));
}

} // namespace
} // namespace shadowlab::radiosity
