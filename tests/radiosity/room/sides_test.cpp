// Which sides of faces exchange light, and what else patches see.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/sides.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

Sides sidesIn(const scene::Scene& scene, const std::vector<bool>& lightWithin) {
    const trace::WorldTriangles world = trace::worldTriangles(scene);
    return sidesOf(scene, world, facesOf(scene, world), lightWithin);
}

TEST(Sides, WallsOfARoomExchangeLightByTheirInsides) {
    const Sides sides = sidesIn(emptyRoom({3, 2, 4}), std::vector<bool>(6, false));
    EXPECT_EQ(sides.exchanging, 6u); // fronts, which face inward
    EXPECT_EQ(sides.faces.all.size(), 12u) << "backs are there as well, and see nothing";
    for (std::size_t t = 0; t < 12; ++t) {
        EXPECT_LT(sides.faces.ofTriangle[t], 6u);
        EXPECT_GE(sides.backOfTriangle[t], 6u);
        const Face &front = sides.faces.all[sides.faces.ofTriangle[t]],
                   &back = sides.faces.all[sides.backOfTriangle[t]];
        EXPECT_EQ(front.plane.normal, -back.plane.normal);
        EXPECT_EQ(front.triangles, back.triangles);
    }
}

TEST(Sides, OfAClosedBodyTheInsideCountsOnlyWithALightInIt) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({1, 1, 1}), translation({0, 2, 0}));
    EXPECT_EQ(sidesIn(scene, {false, false}).faces.all.size(), 2u + 6u); // floor twice, box once
    const Sides lit = sidesIn(scene, {false, true});
    EXPECT_EQ(lit.faces.all.size(), 2u + 12u);
    // Of the box the side that looks down sees the floor, and within all see each other. The floor's front sees the box.
    EXPECT_EQ(lit.exchanging, 1u + 4u + 1u + 6u) << "the upper side sees nothing, the others see the floor";
    scene.objects[1].castsShadow = false;
    EXPECT_EQ(sidesIn(scene, {false, false}).faces.all.size(), 2u + 12u) << "light gets in";
}

// The two skins of a thin sheet that have fallen together: each has one side that counts, and the other's front is its back.
// Taken twice, every patch would see all others in the place of two, and rows would sum to 2.
TEST(Sides, SkinsThatHaveFallenTogetherCountOnce) {
    scene::Scene scene = floorScene();
    scene::Mesh sheet = scene::makeQuad({1, 1});
    const std::vector<uvec3> above = sheet.triangles;
    for (const uvec3& t : above)
        sheet.triangles.emplace_back(t.x, t.z, t.y);
    sheet.parts.front().triangleCount *= 2;
    addObject(scene, std::move(sheet), translation({0, 2, 0}));
    const Sides sides = sidesIn(scene, {false, false});
    EXPECT_EQ(sides.faces.all.size(), 2u + 2u);
    int compared = 0;
    for (std::size_t t = 2; t < 6; ++t) {
        const std::uint32_t front = sides.faces.ofTriangle[t], back = sides.backOfTriangle[t];
        ASSERT_NE(front, kNoFace);
        ASSERT_NE(back, kNoFace);
        EXPECT_EQ(sides.faces.all[front].plane.normal, -sides.faces.all[back].plane.normal);
        EXPECT_NE(std::ranges::find(sides.faces.ofTriangle, back), sides.faces.ofTriangle.end()) << "a front";
        ++compared;
    }
    EXPECT_EQ(compared, 4);
}

/// Within the rounding of so large a floor, whatever stands on it lies in it; cut as fine as a box, it would be patches without end.
TEST(Sides, AFloorWithoutEndIsNotCutLikeABox) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({2e7, 2e7}));
    addObject(scene, scene::makeBox({1, 1, 1}), translation({0, 2, 0}));
    addObject(scene, scene::makeBox({1, 1, 1}), translation({2, 2, 0}));
    constexpr std::size_t kMost = 200;
    Room room(scene, {kMost, true, {false, false, false}});
    while (!room.advance(std::chrono::steady_clock::now())) {
    }
    std::size_t ofFloor = 0;
    for (const Patch& patch : room.allPatches())
        ofFloor += room.faceOf(patch).object == 0;
    EXPECT_GE(room.patches().size(), 20u) << "of the boxes";
    EXPECT_EQ(std::ranges::count(room.patches(), 0u, [&](const Patch& p) { return room.faceOf(p).object; }), 0)
        << "the case is too easy: the floor exchanges light with them";
    EXPECT_GE(ofFloor, 2u);
    EXPECT_LE(ofFloor, kMost);
}

TEST(Sides, PatchesUnderABoxAreLeftOut) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({2, 1, 2}), translation({0, 0.5, 0}));
    Room room(scene, {200, true, {false, false}});
    while (!room.advance(std::chrono::steady_clock::now())) {
    }
    EXPECT_GE(room.coveredPatches(), 4u);
    double area = 0;
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        const Patch& patch = room.patches()[i];
        if (room.faceOf(patch).object == 0) area += patch.area;
        EXPECT_GT(room.surroundings()[i], 0.2) << "it stands in the open";
        EXPECT_LE(room.surroundings()[i], 1);
    }
    EXPECT_NEAR(area, 100 - 4, 1e-6); // floor less box; vertices are floats
    EXPECT_EQ(room.surroundings().size(), room.patches().size());
}

// Two boxes that stand on the floor and pierce one another: no side of one that lies in the other is left, nor any floor below.
// In there each sees fronts of the others, so that it does not help to look for what sees nothing but insides.
TEST(Sides, WhatLiesInAnotherBodyIsLeftOut) {
    scene::Scene scene = emptyRoom({2, 2, 2});
    const auto turned = [](const dvec3& at, double degrees) {
        return glm::rotate(translation(at), glm::radians(degrees), dvec3(0, 1, 0));
    };
    const double sides[] = {0.6, 0.5};
    const dmat4 places[] = {turned({1, 0.3, 0.7}, 20), turned({1.2, 0.25, 0.8}, 50)};
    for (int box = 0; box < 2; ++box)
        addObject(scene, scene::makeBox(dvec3(sides[box])), places[box]);
    Room room(scene, {500, true, std::vector<bool>(8, false)});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_GT(room.coveredPatches(), 20u);
    int compared = 0;
    for (const Patch& patch : room.patches()) {
        const dvec3 before = room.world().originWorld + patch.centre + 1e-4 * patch.normal;
        for (int box = 0; box < 2; ++box) {
            const dvec3 inBox = glm::abs(dvec3(glm::inverse(places[box]) * dvec4(before, 1)));
            EXPECT_GT(std::max({inBox.x, inBox.y, inBox.z}), sides[box] / 2) << "it lies in box " << box;
            ++compared;
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(Sides, InAClosedRoomNobodySeesTheSurroundings) {
    const scene::Scene scene = emptyRoom({3, 2, 4});
    Room room(scene, {150, true, std::vector<bool>(6, false)});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    ASSERT_GT(room.patches().size(), 80u);
    for (const double share : room.surroundings())
        EXPECT_EQ(share, 0);
    EXPECT_EQ(room.coveredPatches(), 0u);
}

// From the floor before a wall that has, as good as, no end to the sides: the wall isBlocked (1 - cos of its elevation) / 2.
TEST(Sides, TheSurroundingsAreWhatIsNotHidden) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({200, 3, 0.1}), translation({0, 1.5, -5.05}));
    Room room(scene, {1500, true, {false, false}});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    int compared = 0;
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        const Patch& patch = room.patches()[i];
        if (room.faceOf(patch).object != 0) continue;
        const double distance = patch.centre.z + room.world().originWorld.z + 5;
        const double hidden = (1 - distance / std::hypot(distance, 3.0)) / 2;
        EXPECT_NEAR(room.surroundings()[i], 1 - hidden, 0.03) << distance; // 256 rays, from all over the patch
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

} // namespace
} // namespace shadowlab::radiosity
