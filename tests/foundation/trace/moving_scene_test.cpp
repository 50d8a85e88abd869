// A scene in motion, asked at one moment, against the same scene with its objects put where they are at that moment.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/moving_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using Clock = std::chrono::steady_clock;

scene::Scene inMotion() {
    scene::Scene scene = testing::simpleScene();
    // Two of one velocity, one of another, the rest at rest.
    scene.objects[1].velocityWorld = {0.5, 0.25, -1};
    scene.objects[2].velocityWorld = {0.5, 0.25, -1};
    scene.objects[3].velocityWorld = {-2, 0, 0.5};
    return scene;
}

/// The same, `time` later, at rest.
scene::Scene later(double time) {
    scene::Scene scene = inMotion();
    for (scene::Object& object : scene.objects)
        object.worldFromObject[3] += dvec4(time * object.velocityWorld, 0);
    scene.revisions = {};
    return scene;
}

SceneTracer tracerOf(scene::Scene scene) {
    SceneTracer tracer;
    EXPECT_TRUE(tracer.advance(testing::snapshot(std::move(scene)), Clock::time_point::max()));
    return tracer;
}

TEST(MovingScene, IsWhatTheSceneIsAtThatMoment) {
    const SceneTracer tracer = tracerOf(inMotion());
    std::mt19937_64 numbers(3);
    std::uniform_real_distribution<double> place(-3, 3), height(0.05, 4);
    int ties = 0, met = 0, ofMoving = 0, blocked = 0;
    for (const Structure structure : {Structure::bvh, Structure::grid, Structure::none}) {
        MovingScene moving(tracer, structure);
        EXPECT_TRUE(moving.moves());
        while (!moving.advance(Clock::now()))
            EXPECT_LE(moving.done(), 1);
        for (const double time : {0.0, 0.3, 1.0, 7.0}) {
            const SceneTracer there = tracerOf(later(time));
            // Each scene has an origin of its own.
            const dvec3 apart = tracer.world().originWorld - there.world().originWorld;
            for (int i = 0; i < 2000; ++i) {
                Ray ray;
                ray.originCentred = dvec3(place(numbers), height(numbers), place(numbers)) - tracer.world().originWorld;
                ray.directionCentred = {place(numbers), place(numbers), place(numbers)};
                Ray thereRay = ray;
                thereRay.originCentred += apart;
                const SurfacePoint found = moving.met(ray, kNoPrimitive, time);
                const SurfacePoint expected = there.met(thereRay, kNoPrimitive);
                if (found && expected && found.primitive != expected.primitive) { // one stands on the other: a tie
                    EXPECT_LT(
                        glm::length(moving.positionCentred(found, time) + apart - there.positionCentred(expected)),
                        1e-12);
                    ++ties;
                    continue;
                }
                ASSERT_EQ(found.primitive, expected.primitive) << i;
                ASSERT_EQ(found.eyeOnFront, expected.eyeOnFront);
                const bool isBlocked = moving.isBlocked(ray, found.primitive, time);
                ASSERT_EQ(isBlocked, there.isBlocked(thereRay, expected.primitive));
                blocked += isBlocked ? 1 : 0;
                if (!found) continue;
                ++met;
                ofMoving += tracer.objectOf(found).velocityWorld != dvec3(0.0) ? 1 : 0;
                // Rounding of coordinates of some metres, a few operations long.
                EXPECT_LT(glm::length(moving.positionCentred(found, time) + apart - there.positionCentred(expected)),
                          1e-12);
            }
        }
    }
    EXPECT_LT(ties, 300);
    EXPECT_GT(met, 8000);
    EXPECT_GT(ofMoving, 1000);
    EXPECT_GT(blocked, 1000);
}

TEST(MovingScene, NothingIsBuiltWhereNothingMoves) {
    const SceneTracer tracer = tracerOf(testing::simpleScene());
    MovingScene still(tracer, Structure::bvh);
    EXPECT_FALSE(still.moves());
    EXPECT_TRUE(still.advance(Clock::time_point::min()));
    EXPECT_EQ(still.done(), 1);
}

} // namespace
} // namespace shadowlab::trace
