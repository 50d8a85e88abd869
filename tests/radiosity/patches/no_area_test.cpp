// Where patches are as small as what rounding leaves of positions, cutting them further makes no patch whose corners lie in a line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/room/refinement.h"
#include "techniques/radiosity/room_cache.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// Two heaps of a few millimetres, so far from each other that neighbouring places in them are a sixty-fifth of a millimetre apart.
scene::Scene farHeaps() {
    constexpr double kFar = 1e11;
    scene::Scene scene;
    scene.materials.emplace_back();
    for (const double z : {-kFar, kFar}) {
        addObject(scene, scene::makeQuad({3e-3, 3e-3}), translation({0, 0, z}));
        addObject(scene, scene::makeSphere(1e-3, 8), translation({2e-4, 6e-4, z}));
        addObject(scene, scene::makeBox({4e-4, 4e-4, 4e-4}),
                  glm::rotate(translation({-9e-4, 2e-4, z}), 0.4, dvec3(0, 1, 0)));
    }
    return scene;
}

std::size_t withoutArea(const std::vector<Patch>& patches) {
    return static_cast<std::size_t>(std::ranges::count_if(patches, [](const Patch& patch) {
        return !(patch.area > 0) || !(glm::length(patch.normal) > 0.5) || patch.centre != patch.centre;
    }));
}

std::vector<Refinement> allOf(const std::vector<Patch>& patches) {
    std::vector<Refinement> all;
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        all.push_back({i, Refinement::Reason::gradient});
    return all;
}

TEST(NoArea, ThreeCornersInALineHaveNone) {
    EXPECT_TRUE(hasNoArea({}));
    EXPECT_TRUE(hasNoArea({dvec3(0), dvec3(1, 0, 0)}));
    EXPECT_TRUE(hasNoArea({dvec3(0), dvec3(1, 2, 3), dvec3(0)}));
    EXPECT_TRUE(hasNoArea({dvec3(0), dvec3(1, 2, 3), dvec3(2, 4, 6)}));
    EXPECT_FALSE(hasNoArea({dvec3(0), dvec3(1e-60, 0, 0), dvec3(0, 1e-60, 0)}));
}

TEST(NoArea, NoPatchIsCutIntoLines) {
    const scene::Scene scene = farHeaps();
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    ASSERT_GT(faces.all.size(), 100u);
    EXPECT_EQ(withoutArea(cutIntoPatches(faces, 1e-5)), 0u) << "finer than places lie";
    std::vector<Patch> patches = cutIntoPatches(faces, 2e-4);
    ASSERT_GT(patches.size(), 500u);
    EXPECT_EQ(withoutArea(patches), 0u) << "evenly";
    const std::size_t before = patches.size();
    patches = cutAtContacts(faces, std::move(patches));
    EXPECT_GT(patches.size(), before + 50);
    EXPECT_EQ(withoutArea(patches), 0u) << "where things touch";
    std::erase_if(patches,
                  [](const Patch& patch) { return patch.area > 3e-9; }); // the smallest come to their end soonest
    ASSERT_GT(patches.size(), 50u);
    std::size_t uncut = 0;
    for (int round = 0; round < 4; ++round) {
        Refined finer = refined(patches, allOf(patches), {});
        ASSERT_EQ(withoutArea(finer.patches), 0u) << round;
        std::vector<std::size_t> pieces(patches.size());
        for (const std::uint32_t parent : finer.parent)
            ++pieces[parent];
        EXPECT_EQ(std::ranges::count(pieces, 0u), 0) << "none is lost";
        uncut += static_cast<std::size_t>(std::ranges::count(pieces, 1u));
        patches = std::move(finer.patches);
    }
    EXPECT_GT(uncut, 50u) << "the case is too easy: all could be cut again";
}

TEST(NoArea, TheRoomIsSolved) {
    scene::Scene scene = farHeaps();
    RadiosityParams params;
    params.patches = 2000;
    RoomCache kept;
    ASSERT_NO_THROW((void)kept.advance(std::make_shared<const scene::Scene>(scene), params, Deadline::max()));
    EXPECT_GT(kept.room().patches().size(), 500u);
}

} // namespace
} // namespace shadowlab::radiosity
