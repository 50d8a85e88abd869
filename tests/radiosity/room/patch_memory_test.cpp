// Patches beyond what the limit of memory leaves are refused before their matrix is made, and no fewer than those.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/patch_memory.h"

#include <gtest/gtest.h>

#include "techniques/foundation/base/error.h"
#include "techniques/radiosity/room_cache.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// What is said about an empty room with that budget of memory; empty: it is drawn.
std::string refusalOf(const scene::MemoryBudget& memory, const RadiosityParams& params) {
    scene::Scene scene = emptyRoom({1, 1, 1});
    scene.name = "cell";
    scene.memory = memory;
    RoomCache kept;
    try {
        EXPECT_TRUE(kept.advance(std::make_shared<const scene::Scene>(scene), params, Deadline::max()));
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::overLimit);
        return error.what();
    }
    return {};
}

std::uint64_t patchesOf(const RadiosityParams& params) {
    RoomCache kept;
    EXPECT_TRUE(kept.advance(std::make_shared<const scene::Scene>(emptyRoom({1, 1, 1})), params, Deadline::max()));
    return kept.room().patches().size();
}

TEST(PatchMemory, ManyTrianglesTakeTheirsBeforeThereArePatches) {
    constexpr std::uint64_t kTaken = 160'000'000;
    const std::uint64_t triangles = scene::triangleCount(emptyRoom({1, 1, 1}));
    ASSERT_GE(triangles, 12u);
    const std::string said = refusalOf({kTaken, kTaken + triangles * kBytesPerTriangleSimplified - 1}, {});
    EXPECT_NE(said.find(" triangles, for which some 161 MB of memory are needed"), std::string::npos) << said;
}

TEST(PatchMemory, ExactlyWhatTheLimitLeaves) {
    using enum SolverKind;
    constexpr std::uint64_t kTaken = 160'000'000;
    RadiosityParams params;
    params.patches = 600;
    params.refine = 0;
    const std::uint64_t patches = patchesOf(params);
    ASSERT_GT(patches, 100u);
    for (const SolverKind solver : {conjugateGradients, direct}) {
        params.solver = solver;
        const std::uint64_t needed = patches * patches * bytesPerPair(solver);
        EXPECT_EQ(refusalOf({kTaken, kTaken + needed}, params), "");
        const std::string said = refusalOf({kTaken, kTaken + needed - 1}, params);
        EXPECT_NE(said.find("radiosity: scene \"cell\" makes " + std::to_string(patches) + " patches"),
                  std::string::npos)
            << said;
        EXPECT_NE(said.find("MB of memory"), std::string::npos) << said;
        EXPECT_NE(said.find("--limit memory=VALUE"), std::string::npos) << said;
    }
    EXPECT_GT(bytesPerPair(direct), bytesPerPair(conjugateGradients));
    EXPECT_NE(refusalOf({kTaken, kTaken - 1}, params), "");
    EXPECT_EQ(refusalOf({}, params), "") << "a scene that nobody loaded has no limit";
}

/// Patches that are cut by their light are judged again: the first of them alone would be let through.
TEST(PatchMemory, RefinedPatchesAreJudged) {
    RadiosityParams params;
    params.patches = 600;
    params.refine = 0;
    scene::Scene scene = emptyRoom({1, 1, 1});
    scene.lights.resize(1);
    scene.lights[0].positionWorld = dvec3(0.3, 0.2, 0.4);
    params.refine = 4;
    params.refineThreshold = 0;
    RoomCache kept;
    ASSERT_TRUE(kept.advance(std::make_shared<const scene::Scene>(scene), params, Deadline::max()));
    const std::uint64_t refined = kept.room().patches().size();
    ASSERT_GT(refined, 300u) << "more than the third that it begins with";
    scene.memory = {0, refined * refined * kBytesPerPair - 1};
    scene.revisions = {};
    RoomCache again;
    EXPECT_THROW((void)again.advance(std::make_shared<const scene::Scene>(scene), params, Deadline::max()), Error);
    EXPECT_FALSE(again.room().patches().empty()) << "the room was made, and then cut";
}

/// Numbers that no machine has do not wrap around; the limit is the largest that can be set.
TEST(PatchMemory, NoNumberIsTooLarge) {
    scene::Scene scene;
    scene.memory.limitBytes = 1'000'000'000'000'000;
    for (int bits = 28; bits < 64; ++bits)
        EXPECT_THROW(requireMemory(scene, std::size_t{1} << bits), Error) << bits;
    EXPECT_NO_THROW(requireMemory(scene, 1'000'000));
}

} // namespace
} // namespace shadowlab::radiosity
