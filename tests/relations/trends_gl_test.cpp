// What is true over many scenes, though not of each pixel: a finer shadow map is wrong in fewer pixels, a larger bias trades acne
// for lost contacts, and finer patches come nearer to the finest. For every registered technique that has the parameters.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>

#include "app/judge/verdict.h"
#include "tests/relations/painters_fixture.h"
#include "tests/relations/random_recipes.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {
namespace {

constexpr int kRecipes = 12;
constexpr std::uint64_t kSeed = 8;

struct Wrong {
    int falseLit = 0, falseShadow = 0;
    [[nodiscard]] int all() const { return falseLit + falseShadow; }
};

class Trends : public PaintersTest {
protected:
    /// Wrong pixels over all recipes and lights.
    static Wrong wrong(Painter& painter, const std::vector<Recipe>& recipes) {
        Wrong sum;
        for (const Recipe& recipe : recipes) {
            const scene::Scene scene = sceneOf(recipe);
            const Picture picture = painter.paint(scene);
            picture::Session session(testing::snapshot(scene));
            View view;
            view.camera = scene.camera;
            view.size = picture.size;
            for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
                const auto& seen = picture.visibility[static_cast<std::size_t>(light)];
                const judge::Counts counts = judge::judge(session.truth(view, light), seen.greyAlpha).counts;
                sum.falseLit += counts.falseLit;
                sum.falseShadow += counts.falseShadow;
            }
        }
        return sum;
    }
    /// Of the techniques that have all these parameters.
    static std::vector<std::string> techniquesWith(const std::vector<std::string>& params) {
        std::vector<std::string> ids;
        for (const std::string& id : registeredIds()) {
            const picture::Slot slot = picture::Session::makeSlot(id);
            const auto has = [&](const std::string& param) {
                return std::ranges::any_of(slot.params, [&](const params::Param& p) { return p.id == param; });
            };
            if (std::ranges::all_of(params, has)) ids.push_back(id);
        }
        EXPECT_GE(ids.size(), 1u);
        return ids;
    }
};

/// Wrong are the pixels along the edges, as far as a texel is wide: half as many with twice the texels on each side.
TEST_F(Trends, TwiceTheResolutionHalvesWhatIsWrong) {
    const std::vector<Recipe> recipes = randomRecipes(kSeed, kRecipes);
    for (const std::string& id : techniquesWith({"resolution", "filter"})) {
        std::vector<int> sums;
        for (const char* resolution : {"64", "128", "256", "512"}) {
            Painter painter(id, {std::string("resolution=") + resolution, "filter=hard"});
            sums.push_back(wrong(painter, recipes).all());
            std::cout << id << " with " << resolution << " texels on a side: " << sums.back() << " pixels wrong\n";
        }
        EXPECT_GE(sums.back(), 50) << "too little is wrong to prove anything";
        for (std::size_t i = 1; i < sums.size(); ++i) {
            // By chance of how edges lie on the grid, not exactly half.
            EXPECT_LE(sums[i], 0.7 * sums[i - 1]) << id;
            EXPECT_GE(sums[i], 0.3 * sums[i - 1]) << id;
        }
    }
}

TEST_F(Trends, ALargerBiasTradesAcneForLostContacts) {
    const std::vector<Recipe> recipes = randomRecipes(kSeed, kRecipes);
    for (const std::string& id : techniquesWith({"bias-mode", "constant-bias", "resolution"})) {
        Wrong before, first;
        bool isFirst = true;
        for (const char* bias : {"0", "0.5", "1", "2", "4", "8", "16", "32"}) {
            Painter painter(id, {"resolution=256", "filter=hard", "bias-mode=constant", "rounding-bias=0",
                                 std::string("constant-bias=") + bias});
            const Wrong now = wrong(painter, recipes);
            std::cout << id << " with a bias of " << bias << " texels: " << now.falseShadow << " pixels of acne, "
                      << now.falseLit << " that lost their shadow\n";
            if (!isFirst) {
                EXPECT_LE(now.falseShadow, before.falseShadow) << id;
                EXPECT_GE(now.falseLit, before.falseLit) << id;
            } else {
                first = now;
            }
            before = now;
            isFirst = false;
        }
        EXPECT_GE(first.falseShadow, 4 * before.falseShadow) << id << ": no acne that a bias could cure";
        // Of those that lose their shadow many do so at edges, whatever the bias.
        EXPECT_GE(before.falseLit, 2 * first.falseLit) << id << ": no contact that a bias could lose";
    }
}

TEST_F(Trends, FinerPatchesComeNearerToTheFinest) {
    constexpr int kRooms = 4; // some seconds each at their finest
    const std::vector<Recipe> recipes = randomRecipes(kSeed, kRooms);
    for (const std::string& id : techniquesWith({"patches", "display"})) {
        std::vector<std::vector<Picture>> pictures;
        for (const char* patches : {"40", "160", "640"}) {
            Painter painter(id, {std::string("patches=") + patches, "display=flat"});
            pictures.emplace_back();
            for (const Recipe& recipe : recipes)
                pictures.back().push_back(painter.paint(sceneOf(recipe)));
        }
        std::vector<double> off; // mean difference from the finest
        for (const std::vector<Picture>& some : pictures) {
            double sum = 0, pixels = 0;
            for (std::size_t room = 0; room < recipes.size(); ++room)
                for (std::size_t i = 0; i < some[room].radiance.size(); ++i, ++pixels)
                    sum += std::abs(some[room].radiance[i].g - pictures.back()[room].radiance[i].g);
            off.push_back(sum / pixels);
        }
        std::cout << id << ": 40 patches are off the finest by " << off[0] << ", 160 by " << off[1] << "\n";
        EXPECT_GT(off[0], 1e-3) << "too little differs to prove anything";
        EXPECT_LE(off[1], 0.8 * off[0]) << id;
    }
}

} // namespace
} // namespace shadowlab::relations
