// Rooms in an open scene: they lose no light, whatever lies outside.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/prepared_exchange.h"

#include <gtest/gtest.h>

#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/radiosity/prepared.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

/// Patches 0, 3 and 5 are a room, found with row sums that are a little off; 1 and 2 face each other in the open; 4 sees nothing.
struct HouseAndGarden {
    ExchangeMatrix exchange{6};
    std::vector<Patch> patches{6};
    std::vector<double> areas = {2, 1, 1, 3, 1, 2.5}, surroundings = {0, 0.75, 0.8, 0, 0, 0};
    HouseAndGarden() {
        exchange.set(0, 3, 1.25);
        exchange.set(0, 5, 0.76);
        exchange.set(3, 5, 1.74);
        exchange.set(1, 2, 0.25);
        for (std::size_t i = 0; i < 6; ++i)
            patches[i].area = areas[i];
    }
};

TEST(ClosedParts, AreFoundByTheLightThatGoesFromPatchToPatch) {
    HouseAndGarden scene;
    const auto parts = closedParts(scene.exchange, scene.areas, scene.surroundings);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0], (std::vector<std::size_t>{0, 3, 5}));
    scene.exchange.set(2, 5, 1e-4); // a line that slipped past an edge
    EXPECT_EQ(closedParts(scene.exchange, scene.areas, scene.surroundings).size(), 1u);
    scene.exchange.set(2, 5, 0.01); // a door
    EXPECT_TRUE(closedParts(scene.exchange, scene.areas, scene.surroundings).empty());
}

TEST(ClosedParts, AreScaledToOneWhileTheRestOfTheSceneStaysOpen) {
    const HouseAndGarden scene;
    const PreparedExchange made = preparedExchange(scene.exchange, scene.patches, scene.surroundings, true);
    EXPECT_FALSE(made.isClosed);
    EXPECT_EQ(made.patchesInClosedRooms, 3u);
    const std::vector<double> sums = rowSums(made.matrix, scene.areas);
    for (const std::size_t i : {0, 3, 5})
        EXPECT_NEAR(sums[i], 1, 1e-11) << i; // scaled to 1e-12, and brought down below 1 once more
    EXPECT_EQ(made.matrix(1, 2), 0.25);
    EXPECT_EQ(sums[4], 0);
    EXPECT_GT(made.scalingChanged, 1e-3);
    EXPECT_LT(made.scalingChanged, 0.02);
    // As it was found, the room loses light.
    const std::vector<double> naive = rowSums(scene.exchange, scene.areas);
    EXPECT_GT(std::abs(naive[3] - 1), 3e-3);
}

// Its one half stands in the room, and the other out in the open; of the wall the ball cuts out a disc with many corners.
TEST(ClosedParts, ARoomIntoWhichABallReachesLosesNothing) {
    constexpr double kReflectance = 0.99;
    scene::Scene scene = testing::emptyRoom({4, 3, 4});
    scene.materials[0].diffuse = vec3(static_cast<float>(kReflectance));
    scene.materials[0].emission = vec3(static_cast<float>(1 - kReflectance));
    const dvec3 middle(1.5, 1.2, 0.2);
    testing::addObject(scene, scene::makeSphere(0.5, 48), testing::translation(middle));
    const testing::Prepared prepared(std::move(scene), 600);
    const Room& room = prepared.cache.room();
    double light = 0, area = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        const Patch& patch = room.patches()[i];
        const dvec3 place = room.world().originWorld + patch.centre, off = place - middle;
        const bool isOfBall = room.faceOf(patch).object == 6, isOutOfBall = glm::dot(off, patch.normal) > 0;
        const bool isInward = glm::dot(dvec3(2, 1.5, 2) - place, patch.normal) > 0;
        if (isOfBall ? place.z < 0 || !isOutOfBall : glm::length(off) < 0.5 || !isInward) continue;
        light += patch.area * prepared.balance.radiosity()[i].g / glm::pi<double>(); // a radiance of 1 everywhere
        area += patch.area;
        ++count;
    }
    EXPECT_GT(count, 200u);
    EXPECT_NEAR(area, 80 - M_PI * 0.21 + 2 * M_PI * 0.5 * 0.7, 0.15) << "walls without a disc, and the cap of a ball that is simplified";
    EXPECT_NEAR(light / area, 1, 0.005);
}

} // namespace
} // namespace shadowlab::radiosity
