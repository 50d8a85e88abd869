// Where a mesh that was made coarser has folded onto itself, no light comes in: patches there would be black spots in the picture.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/radiosity/exchange/exchange_builder.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {
namespace {

struct Dark {
    std::size_t patches = 0, folded = 0;
    int dark = 0; ///< neither the sky nor any patch that light comes to sends anything there
};

Dark darkPatches(const std::string& name, bool leavesOutFolds) {
    const std::filesystem::path assets = std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "assets";
    const scene::Snapshot scene =
        scene::loadScene(assets / "scenes" / (name + ".json"), {.assetsRoot = assets, .allowed = {}, .limits = {}});
    RoomSettings settings;
    settings.patches = 600;
    settings.lightWithin.assign(scene->objects.size(), false);
    settings.leavesOutFolds = leavesOutFolds;
    Room room(*scene, settings);
    constexpr auto kNever = std::chrono::steady_clock::time_point::max();
    EXPECT_TRUE(room.advance(kNever));
    constexpr double kLines = 500; // they say whether any light comes through, not how much
    ExchangeBuilder builder(room.exchangingFaces(), room.patches(), room.occlusion(), kLines);
    EXPECT_TRUE(builder.advance(kNever));
    const std::size_t count = room.patches().size();
    std::vector<bool> isLit(count, false);
    std::vector<std::size_t> next;
    const auto light = [&](std::size_t i) {
        if (isLit[i]) return;
        isLit[i] = true;
        next.push_back(i);
    };
    for (std::size_t i = 0; i < count; ++i)
        if (room.surroundings()[i] > 0) light(i);
    while (!next.empty()) {
        const std::size_t from = next.back();
        next.pop_back();
        for (std::size_t to = 0; to < count; ++to)
            if (builder.exchange()(from, to) > 1e-3 * room.patches()[to].area) light(to);
    }
    return {count, room.foldedPatches(), static_cast<int>(std::ranges::count(isLit, false))};
}

TEST(Folds, LightComesToAllPatchesOfSimplifiedMeshes) {
    int naive = 0;
    for (const char* name : {"leafy", "still-life", "candle"}) {
        const Dark kept = darkPatches(name, false), leftOut = darkPatches(name, true);
        EXPECT_GT(leftOut.patches, 100u);
        EXPECT_EQ(kept.patches, leftOut.patches + leftOut.folded);
        EXPECT_EQ(leftOut.dark, 0) << name;
        naive += kept.dark;
    }
    EXPECT_GT(naive, 10) << "with folds kept";
}

} // namespace
} // namespace shadowlab::radiosity
