// What passes through lamps, held against closed forms and against bodies in their place.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lines_through_lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "tests/radiosity/prepared.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/area_lights.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kPi = glm::pi<double>();
const dvec3 kMiddle(2);

/// A cube of 4 m, with that lamp in it.
scene::Scene cubeWith(const scene::Light& lamp, float reflectance = 0.5f) {
    scene::Scene scene = emptyRoom({4, 4, 4});
    scene.materials[0].diffuse = vec3(reflectance);
    scene.lights.push_back(lamp);
    scene::addEmitterSurfaces(scene);
    return scene;
}

std::vector<ExchangeArea> throughLampsOf(const Prepared& room) {
    LampLinesBuilder builder(room.cache.room(), room.cache.cells(), room.snapshot, {1});
    while (!builder.advance(Deadline::max())) {
    }
    return builder.take();
}

/// Of each object, what passes from its patches to others, m^2; and how many of the pairs are of opposite walls.
struct OfWalls {
    explicit OfWalls(const Prepared& room) {
        const Room& of = room.cache.room();
        for (const auto& [i, j, part] : throughLampsOf(room)) {
            const std::uint32_t a = of.faceOf(of.patches()[i]).object, b = of.faceOf(of.patches()[j]).object;
            EXPECT_LT(i, j);
            area[a] += part;
            area[b] += part;
            (a / 2 == b / 2 ? opposite : beside) += part;
        }
    }
    std::array<double, 6> area{};
    double opposite = 0, beside = 0;
};

// What passes through a ball is what a wall would send it: by symmetry each has a sixth of the view from there.
TEST(LinesThroughLamps, AreWhatWallsWouldSendToABall) {
    constexpr double kRadius = 0.05;
    const Prepared room(cubeWith(sphereLight(kMiddle, kRadius)), 150);
    const OfWalls found(room);
    // The ball that is drawn has faces, and less of a surface by a hundredth.
    for (const double area : found.area)
        EXPECT_NEAR(area, 4 * kPi * kRadius * kRadius / 6, 0.02 * area);
    EXPECT_LT(found.beside, 0.05 * found.opposite) << "through the middle of a cube lines go to the opposite wall";
}

// A rect is in the way from both sides: 2 m^2 for one of 1 m^2. Of the floor's light it meets what the floor sends to the side that it sees.
TEST(LinesThroughLamps, MeetBothSidesOfARect) {
    const Prepared room(cubeWith(rectLight(kMiddle, {1, 0, 0}, {0, 0, 1})), 150);
    const OfWalls found(room);
    EXPECT_NEAR(found.opposite + found.beside, 1, 1e-3) << "each line has two ends";
    const Polygon floor{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, below{{1.5, 2, 1.5}, {2.5, 2, 1.5}, {2.5, 2, 2.5}, {1.5, 2, 2.5}};
    const double truth = unoccludedExchange(floor, below).area;
    EXPECT_GT(truth, 0.5);
    EXPECT_NEAR(found.area[0], truth, 1e-3);
    EXPECT_NEAR(found.area[1], truth, 1e-3) << "the ceiling";
}

/// What walls send each other, all of it, m^2.
double exchangedBetweenWalls(const RoomCache& cache) {
    double sum = 0;
    const std::vector<Patch>& patches = cache.room().patches();
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t j = 0; j < patches.size(); ++j)
            if (cache.room().faceOf(patches[i]).object < 6 && cache.room().faceOf(patches[j]).object < 6) sum += cache.exchange().matrix(i, j);
    return sum;
}

// A panel that is a body, with patches of its own, is in the way of form factors.
TEST(LinesThroughLamps, LeaveWhatABodyInItsPlaceLeaves) {
    scene::Scene withPanel = emptyRoom({4, 4, 4});
    withPanel.materials.resize(2);
    withPanel.materials[0].diffuse = vec3(0.9f);
    withPanel.materials[1].diffuse = vec3(0);
    withPanel.materials[1].emission = vec3(1);
    addObject(withPanel, scene::makeQuad({1, 1}), glm::rotate(translation(kMiddle), kPi, dvec3(1, 0, 0))).partMaterials = {1};
    scene::Light light = rectLight(kMiddle, {1, 0, 0}, {0, 0, 1});
    light.intensity = 1;
    const Prepared panel(withPanel, 600), lamp(cubeWith(light, 0.9f), 600);
    const Prepared naive(cubeWith(light, 0.9f), 600, RadiosityParams::Direct::patches);
    const double truth = exchangedBetweenWalls(panel.cache);
    EXPECT_NEAR(truth, 96 - 2, 0.02) << "all that walls send, less what the panel meets";
    EXPECT_NEAR(exchangedBetweenWalls(lamp.cache), truth, 0.02);
    EXPECT_NEAR(exchangedBetweenWalls(naive.cache), 96, 1e-4);

    const auto watts = [](const Prepared& room) { // that the walls send
        double sum = 0;
        for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
            const Patch& patch = room.cache.room().patches()[i];
            if (room.cache.room().faceOf(patch).object < 6) sum += patch.area * room.balance.radiosity()[i].x;
        }
        return sum;
    };
    const double truthWatts = watts(panel);
    EXPECT_NEAR(watts(lamp) / truthWatts, 1, 0.002);
    EXPECT_GT(watts(naive) / truthWatts, 1.1) << "at each of ten reflections a fiftieth";
}

// Half of the ball is outside, 2 pi r^2. By its silhouettes 1.5 pi r^2 of that is lines from above the wall's plane, so the wall sends it 0.5 pi r^2. What
// the wall has within the ball sends nothing, and is not counted.
TEST(LinesThroughLamps, OfABallInAWallAreThoseOutside) {
    constexpr double kRadius = 0.1;
    const Prepared room(cubeWith(sphereLight({2, 0, 2}, kRadius)), 150);
    const OfWalls found(room);
    const double all = found.opposite + found.beside;
    EXPECT_NEAR(all, 0.5 * kPi * kRadius * kRadius, 0.02 * all) << "the ball that is drawn has faces";
    EXPECT_GT(found.area[0], 0.95 * all) << "other lines lie so flat that they end beyond the wall";
}

// Where the lamp goes elsewhere, or is of no account, form factors are what they were.
TEST(LinesThroughLamps, GoWithTheLamp) {
    const scene::Light lamp = sphereLight(kMiddle, 0.3);
    Prepared room(cubeWith(lamp), 150);
    const ExchangeMatrix before = room.cache.exchange().matrix;
    const std::uint64_t version = room.cache.version();
    const auto isBefore = [&] {
        for (std::size_t i = 0; i < before.size(); ++i)
            if (!std::ranges::equal(before.row(i), room.cache.exchange().matrix.row(i))) return false;
        return true;
    };
    const auto advance = [&](const scene::Light& now) {
        while (!room.cache.advance(scene::withLights(room.snapshot, {now}), room.params, Deadline::max())) {
        }
    };
    scene::Light brighter = lamp, moved = lamp;
    brighter.intensity *= 2;
    moved.positionWorld.x += 0.5;
    advance(brighter);
    EXPECT_EQ(room.cache.version(), version) << "brightness changes no form factor";
    advance(moved);
    EXPECT_NE(room.cache.version(), version);
    EXPECT_FALSE(isBefore());
    advance(lamp);
    EXPECT_TRUE(isBefore());
    room.params.direct = RadiosityParams::Direct::patches;
    advance(lamp);
    EXPECT_FALSE(isBefore());
    EXPECT_NEAR(exchangedBetweenWalls(room.cache), 96, 1e-4);
    room.params.direct = RadiosityParams::Direct::pixels;
    advance(lamp);
    EXPECT_TRUE(isBefore());
}

} // namespace
} // namespace shadowlab::radiosity
