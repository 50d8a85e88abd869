// What lamps take of the exchange of patches, held against closed forms and against bodies in their place.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamps_between.h"

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

/// What a lamp takes of what the patches of each wall exchange with others, m^2; and of all pairs of opposite walls, and of others.
struct Taken {
    explicit Taken(const scene::Scene& scene, int patches = 150) {
        const Prepared with(scene, patches), without(scene, patches, RadiosityParams::Direct::patches);
        const Room& room = with.cache.room();
        const ExchangeMatrix &is = with.cache.exchange().matrix, &was = without.cache.exchange().matrix;
        EXPECT_EQ(is.size(), was.size());
        for (std::size_t i = 0; i < is.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_LE(is(i, j), was(i, j));
                EXPECT_GE(is(i, j), 0);
                const double part = was(i, j) - is(i, j);
                const std::uint32_t a = room.faceOf(room.patches()[i]).object, b = room.faceOf(room.patches()[j]).object;
                ofWall[a] += part;
                ofWall[b] += part;
                (a / 2 == b / 2 ? opposite : beside) += part;
            }
    }
    std::array<double, 6> ofWall{};
    double opposite = 0, beside = 0;
};

// What a ball takes is what walls would send it: by symmetry each has a sixth of the view from there.
TEST(LampsBetween, BallsTakeWhatWallsWouldSendThem) {
    constexpr double kRadius = 0.2;
    const Taken taken(cubeWith(sphereLight(kMiddle, kRadius)));
    const double truth = 4 * kPi * kRadius * kRadius / 6; // the ball that is drawn has faces, and less of a surface by 0.3 %
    double sum = 0;
    for (const double ofWall : taken.ofWall) {
        EXPECT_NEAR(ofWall, truth, 0.02 * truth) << "some thousand lines meet the ball";
        sum += ofWall;
    }
    EXPECT_NEAR(sum, 6 * truth, 0.01 * 6 * truth);
    EXPECT_LT(taken.beside, 0.25 * taken.opposite) << "through the middle of a cube lines go to the opposite wall";
    EXPECT_GT(taken.beside, 0.05 * taken.opposite);
}

// A rect is in the way from both sides: 2 m^2 for one of 1 m^2. Of the floor's light it meets what the floor sends to the side that it sees.
TEST(LampsBetween, RectsMeetLightFromBothSides) {
    const Taken taken(cubeWith(rectLight(kMiddle, {1, 0, 0}, {0, 0, 1})));
    EXPECT_NEAR(taken.opposite + taken.beside, 1, 0.01) << "each line has two ends";
    const Polygon floor{{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, below{{1.5, 2, 1.5}, {2.5, 2, 1.5}, {2.5, 2, 2.5}, {1.5, 2, 2.5}};
    const double truth = unoccludedExchange(floor, below).area;
    EXPECT_GT(truth, 0.5);
    EXPECT_NEAR(taken.ofWall[0], truth, 0.01 * truth);
    EXPECT_NEAR(taken.ofWall[1], truth, 0.01 * truth) << "the ceiling";
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
TEST(LampsBetween, LeaveWhatABodyInItsPlaceLeaves) {
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
    EXPECT_NEAR(exchangedBetweenWalls(lamp.cache), truth, 0.02) << "a hundredth of what the lamp takes";
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

// Half of the ball is outside, 2 pi r^2. By its silhouettes 1.5 pi r^2 of that is lines from above the wall's plane, so the wall sends it 0.5 pi r^2 from around it. What
// the wall has within the ball sends nothing, and what arrives there is taken in (lamp_cover.h): the rest of that wall exchanges the same share, so as much less as it is smaller.
TEST(LampsBetween, ABallInAWallTakesWhatIsAroundIt) {
    constexpr double kRadius = 0.5;
    const Taken taken(cubeWith(sphereLight({2, 0, 2}, kRadius)), 600);
    const double around = 0.5 * kPi * kRadius * kRadius;
    EXPECT_GT(taken.ofWall[0], around);
    EXPECT_LT(taken.ofWall[0], 1.5 * around) << "patches that the ball cuts";
    EXPECT_GT(taken.ofWall[0], 0.8 * (taken.opposite + taken.beside)) << "other lines lie so flat that they end beyond the wall";
}

// A lamp that fills a doorway: all that comes through passes it, and lines through the walls beside it do not count.
TEST(LampsBetween, ALampInADoorwayClosesIt) {
    scene::Scene scene = cubeWith(rectLight({2, 0.5, 2}, {0, 1, 0}, {0, 0, 1}));
    addObject(scene, scene::makeBox({0.02, 4, 1.5}), translation({2, 2, 0.75}));
    addObject(scene, scene::makeBox({0.02, 4, 1.5}), translation({2, 2, 3.25}));
    addObject(scene, scene::makeBox({0.02, 3, 1}), translation({2, 2.5, 2}));
    const auto through = [&](RadiosityParams::Direct direct) {
        const Prepared room(scene, 300, direct);
        double sum = 0;
        for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const auto isLeft = [&](std::size_t k) { return room.cache.room().patches()[k].centre.x + room.cache.room().world().originWorld.x < 2; };
                if (isLeft(i) != isLeft(j)) sum += room.cache.exchange().matrix(i, j);
            }
        return sum;
    };
    const double open = through(RadiosityParams::Direct::patches);
    EXPECT_NEAR(open, 1, 0.05) << "1 m^2 from one half to the other";
    EXPECT_LT(through(RadiosityParams::Direct::pixels), 0.03 * open) << "past its edges, through a wall 2 cm thick";
}

// Where the lamp goes elsewhere, or is of no account, form factors are what they were.
TEST(LampsBetween, GoWithTheLamp) {
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
