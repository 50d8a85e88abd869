// A ground of any size costs about the same, and walls are no ground.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/ground.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

scene::Scene boxOnGround(double metres) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({metres, metres}));
    addObject(scene, scene::makeBox({1, 1, 1}), translation({0.3, 0.5, 0.2}));
    return scene;
}

struct Cut {
    std::ptrdiff_t ofGround = 0, ofBox = 0;
    double finest = 1e300; ///< the longest side of the smallest patch of the ground, metres
    double area = 0;
};

Cut cutOf(double metres, bool coarsens) {
    const scene::Scene scene = boxOnGround(metres);
    RoomSettings settings{600, true, {false, false}};
    settings.coarsensGround = coarsens;
    Room room(scene, settings);
    room.advance(std::chrono::steady_clock::time_point::max());
    Cut cut;
    for (const Patch& patch : room.patches()) {
        const bool isGround = room.faceOf(patch).object == 0;
        (isGround ? cut.ofGround : cut.ofBox) += 1;
        if (isGround) cut.finest = std::min(cut.finest, std::sqrt(patch.area));
        if (isGround) cut.area += patch.area;
    }
    EXPECT_LE(room.patches().size(), 600u);
    return cut;
}

TEST(Ground, OfAnySizeCostsAboutTheSame) {
    for (const double metres : {20.0, 200.0, 2000.0, 20000.0}) {
        const Cut cut = cutOf(metres, true);
        EXPECT_NEAR(cut.area, metres * metres - 1, 1e-4 * metres * metres) << "all of it, but for what the box stands on";
        EXPECT_GE(cut.ofGround, 50) << metres;
        EXPECT_GE(cut.ofBox, 15) << metres;
        EXPECT_LT(cut.finest, 0.75) << metres;
    }
    // Cut evenly, a wide ground leaves the box the fewest that it can have, and has itself none as small as the box's shadow.
    const Cut even = cutOf(2000, false);
    EXPECT_LE(even.ofBox, 5);
    EXPECT_GT(even.finest, 4) << "and even that is cut by the box alone";
}

TEST(Ground, IsOneAloneAndOutdoors) {
    const auto groundFaces = [](const scene::Scene& scene) {
        const Faces faces = facesOf(scene, trace::worldTriangles(scene));
        const Ground ground(faces);
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < faces.all.size(); ++i)
            count += ground.holds(i) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(groundFaces(boxOnGround(20)), 1u);
    EXPECT_EQ(groundFaces(boxOnGround(3)), 0u) << "a table";
    scene::Scene room = emptyRoom({3, 2, 4});
    addObject(room, scene::makeBox({0.1, 0.1, 0.1}), translation({1.5, 0.05, 2}));
    EXPECT_EQ(groundFaces(room), 0u) << "floor and walls light each other";
    scene::Scene alley = boxOnGround(2000);
    addObject(alley, scene::makeBox({5, 8, 30}), translation({4, 4, 0}));
    EXPECT_EQ(groundFaces(alley), 1u) << "a house is much larger than the box, too";
    scene::Scene twoSquares = boxOnGround(20);
    addObject(twoSquares, scene::makeQuad({20, 20}), translation({20, 0, 0}));
    EXPECT_EQ(groundFaces(twoSquares), 2u) << "one ground of two objects";
    scene::Scene cellar = boxOnGround(20);
    addObject(cellar, scene::makeQuad({20, 20}), translation({0, -5, 0}));
    EXPECT_EQ(groundFaces(cellar), 0u) << "two planes";
    scene::Scene alone;
    alone.materials.emplace_back();
    addObject(alone, scene::makeQuad({20, 20}));
    EXPECT_EQ(groundFaces(alone), 0u);
}

} // namespace
} // namespace shadowlab::radiosity
