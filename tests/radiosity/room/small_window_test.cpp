// A room with a small window: most of its patches see the sky in a thousandth of their view, and its outsides see nothing else.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>

#include "techniques/radiosity/display/openings.h"
#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

constexpr double kWindow = 0.7; // metres to a side

/// 4 x 3 x 6 m of sheets. The one with the window is larger than the room, so that the outsides of the others see a border of it.
scene::Scene roomOfSheets() {
    scene::Scene scene = testing::emptyRoom({4, 3, 6});
    scene.objects.erase(scene.objects.begin() + 2); // the wall z = 0; in its place four pieces around the window
    const auto piece = [&](double left, double right, double below, double above) {
        testing::addObject(scene, scene::makeQuad({right - left, above - below}),
                           glm::rotate(testing::translation({(left + right) / 2, (below + above) / 2, 0}), glm::radians(90.0), dvec3(1, 0, 0)));
    };
    const double left = 1, right = left + kWindow, sill = 1.2, top = sill + kWindow;
    piece(-0.2, left, -0.2, 3.2);
    piece(right, 4.2, -0.2, 3.2);
    piece(left, right, -0.2, sill);
    piece(left, right, top, 3.2);
    return scene;
}

// What comes in through a window lies on the inside: the sum of area times view is the area of the window.
TEST(SmallWindow, AllThatSeeItTogetherSeeAsMuchAsItHas) {
    const scene::Scene scene = roomOfSheets();
    Room room(scene, {600, true, std::vector<bool>(scene.objects.size(), false)});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    double seen = 0, outside = 0;
    int little = 0;
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        const double view = room.surroundings()[i], area = room.patches()[i].area;
        (view < 0.5 ? seen : outside) += area * view;
        little += view > 0 && view < 1.0 / 256;
    }
    std::cout << "seen " << seen << " of " << kWindow * kWindow << " m^2, " << little << " patches see less than a 256th, outsides " << outside << " m^2\n";
    // Some 6,000 rays go out, and what they count for differs by the size of the patches: four standard deviations.
    EXPECT_NEAR(seen, kWindow * kWindow, 0.08 * kWindow * kWindow) << "where only patches look again of which one of 256 rays went out, it is 0.43";
    EXPECT_GT(little, 50);
    EXPECT_GT(outside, 40);

    const Openings openings(room);
    EXPECT_FALSE(openings.isEmpty()) << "the mean view of all is a half, but that of the inside is small";
    EXPECT_TRUE(openings.exit({2, 1.5, 3}, glm::normalize(dvec3(1 + kWindow / 2, 1.2 + kWindow / 2, 0) - dvec3(2, 1.5, 3))));
    EXPECT_FALSE(openings.exit({2, 1.5, 3}, {0, 0, 1})) << "a wall is no opening, though its outside sees the sky";
    EXPECT_LT(1 / openings.density(), 6 * kWindow * kWindow) << "with the cells around, which its rays go through beside";
}

// Under the open sky there are none.
TEST(SmallWindow, OutdoorsThereIsNone) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.6, 0}));
    Room room(scene, {300, true, std::vector<bool>(scene.objects.size(), false)});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_TRUE(Openings(room).isEmpty());
}

} // namespace
} // namespace shadowlab::radiosity
