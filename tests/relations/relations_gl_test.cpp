// Every relation, for every registered technique, on random scenes: see docs/relations.md.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <map>

#include "tests/relations/painters_fixture.h"
#include "tests/relations/random_recipes.h"
#include "tests/relations/relation.h"

namespace shadowlab::relations {
namespace {

// For each seed, technique and relation; each costs two pictures or more.
constexpr int kRecipes = 3;
// Of all pictures of a relation and technique together, at edges.
constexpr double kShareOfAll = 0.0002;
// Of the same, away from edges (as in tests/shadow_volume/volume_case.h).
constexpr double kCrackShare = 3e-5;

/// Every relation has scenes of its own, and all techniques the same ones. (FNV-1a, by Fowler, Noll and Vo.)
std::uint64_t seedFor(std::string_view relation, std::uint64_t seed) {
    for (const char letter : relation)
        seed = (seed ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    return seed;
}

/// A relation tried with one technique: the sum of all scenes for which it held, and how many these were.
struct Trial {
    const Relation& relation;
    Painter& painter;
    Comparison sum = {};
    int scenes = 0;
    std::vector<scene::Scene> painted = {}; ///< for the last recipe for which it did not hold

    Verdict operator()(const Recipe& recipe) {
        painter.forget();
        const Comparison comparison = relation.check(recipe, painter);
        const std::string wrong = complaint(comparison, painter.traits());
        if (wrong.empty()) {
            if (painted.empty()) sum += comparison, ++scenes; // else it is a smaller one, which would count too much
            return {};
        }
        painted = painter.painted();
        return wrong;
    }
};

class RelationTest : public PaintersTest, public ::testing::WithParamInterface<Relation> {
protected:
    static void expectNoCounterexample(Trial& trial, std::uint64_t seed) {
        const Relation& relation = trial.relation;
        const std::string& id = trial.painter.technique();
        trial.painted.clear();
        const auto found = findCounterexample(seedFor(relation.id, seed), recipesPerSeed(kRecipes),
                                              [&](const Recipe& r) { return trial(r); });
        if (found)
            ADD_FAILURE() << id << ": " << relation.says << "; but " << found->wrong << ". SHADOWLAB_SEED=" << seed
                          << ", after " << found->triedBefore << " scenes that held; shrunk to " << found->recipe
                          << "; scenes: " << keep(trial.painted, std::string(relation.id) + "-" + id);
    }
};

TEST_P(RelationTest, HoldsForEveryTechnique) {
    const Relation& relation = GetParam();
    int techniques = 0, scenes = 0;
    Comparison ofAll;
    for (auto& [id, painter] : painters()) {
        const Traits& traits = painter->traits();
        if (relation.appliesTo && !relation.appliesTo(traits)) continue;
        Trial trial{relation, *painter};
        for (const std::uint64_t seed : seeds())
            expectNoCounterexample(trial, seed);
        const Comparison& sum = trial.sum;
        const auto compared = static_cast<double>(sum.compared);
        EXPECT_LE(static_cast<double>(sum.stray), std::max(1.0, kCrackShare * compared)) << id << ": " << sum;
        if (!mayDifferAtAllEdges(sum.gate, traits)) {
            EXPECT_LE(static_cast<double>(sum.different), kShareOfAll * compared) << id << ": " << sum;
        }
        std::cout << relation.id << ", " << id << ": " << sum << "\n";
        ++techniques;
        scenes += trial.scenes;
        ofAll += sum;
    }
    EXPECT_GE(techniques, 3) << "a relation that holds for few techniques is a test of those";
    // A sixteenth of a picture for each scene at least; most have ten times as much light and shadow.
    const long pixels = long{kSize.x} * kSize.y * scenes;
    EXPECT_GE(ofAll.compared, pixels / 16);
    EXPECT_GE(ofAll.lit, pixels / 20) << "too little light to prove anything";
    EXPECT_GE(ofAll.shadowed, pixels / 200) << "too little shadow to prove anything";
}

INSTANTIATE_TEST_SUITE_P(All, RelationTest, ::testing::ValuesIn(allRelations()), [](const auto& info) {
    std::string name(info.param.id);
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace shadowlab::relations
