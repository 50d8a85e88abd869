// The budget of patches is a bound, whatever the meshes are.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

std::vector<Patch> patchesWithin(const scene::Scene& scene, std::size_t budget) {
    Room room(scene, {budget, true, std::vector<bool>(scene.objects.size(), false)});
    room.advance(std::chrono::steady_clock::time_point::max());
    return room.patches();
}

// An open mesh exchanges light on both sides, each of which takes its part of the budget. Walls are left enough to be cut.
TEST(PatchBudget, AnOpenMeshLeavesTheWallsTheirPart) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    scene::Mesh torus = scene::makeTorus(0.5, 0.2, {48, 24});
    torus.triangles.pop_back();
    torus.parts.back().triangleCount -= 1;
    addObject(scene, torus, translation({1.5, 1, 2}));
    ASSERT_FALSE(scene.objects.back().mesh->outward);
    for (const std::size_t budget : {300u, 600u, 1500u}) {
        const std::vector<Patch> patches = patchesWithin(scene, budget);
        EXPECT_LE(patches.size(), budget);
        EXPECT_GT(patches.size(), budget / 2);
        const auto ofWalls = std::ranges::count_if(patches, [](const Patch& patch) { return patch.face < 6; });
        EXPECT_GT(ofWalls, static_cast<std::ptrdiff_t>(budget / 5)) << budget;
    }
}

// Of very many bodies each becomes about a box where even coarse cells would leave too much.
TEST(PatchBudget, ManyBodiesBecomeBoxes) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    for (int i = 0; i < 12; ++i) {
        const dmat4 place = translation({0.4 + 0.7 * (i % 4), 1, 0.6 + 1.2 * (i / 4)}); // narrow and high: columns
        addObject(scene, scene::makeSphere(0.25, 32), glm::scale(place, dvec3(1, 3.6, 1)));
    }
    for (const std::size_t budget : {200u, 400u, 1000u}) {
        const std::vector<Patch> patches = patchesWithin(scene, budget);
        EXPECT_LE(patches.size(), budget);
        EXPECT_GT(patches.size(), budget / 3);
    }
}

// What lies under bodies is no patch, so it takes nothing from the budget.
TEST(PatchBudget, WhatIsCoveredIsNotCounted) {
    scene::Scene scene = floorScene();
    for (int i = 0; i < 16; ++i)
        addObject(scene, scene::makeBox({1.8, 0.5, 1.8}), translation({-3.1 + 2.0 * (i % 4), 0.25, -2.9 + 2.0 * (i / 4)}));
    for (const std::size_t budget : {300u, 600u, 1500u}) {
        Room room(scene, {budget, true, std::vector<bool>(scene.objects.size(), false)});
        ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
        EXPECT_GT(room.coveredPatches(), budget / 10);
        EXPECT_LE(room.patches().size(), budget);
        EXPECT_GT(static_cast<double>(room.patches().size()), 0.8 * static_cast<double>(budget)) << "sizes go in steps";
    }
}

} // namespace
} // namespace shadowlab::radiosity
