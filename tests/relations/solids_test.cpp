// Random solids are closed, wound outward, and on the grid; without that the relations would be about something else.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "tests/relations/random_recipes.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {
namespace {

void expectSolid(const Solid& solid, const std::string& what) {
    const scene::Mesh mesh = meshOf(solid, false);
    const scene::MeshReport report = scene::reportMesh(mesh, scene::buildTopology(mesh));
    EXPECT_TRUE(report.isClosed()) << what;
    EXPECT_EQ(report.components, 1u) << what;
    double volume = 0;
    for (const uvec3& t : mesh.triangles)
        volume += glm::dot(dvec3(mesh.positionsMesh[t.x]),
                           glm::cross(dvec3(mesh.positionsMesh[t.y]), dvec3(mesh.positionsMesh[t.z])));
    EXPECT_GT(volume, 0) << what << " is inside out";
    for (const vec3& position : mesh.positionsMesh)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(position[axis] / kGrid, std::round(position[axis] / kGrid)) << what;
}

TEST(Solids, AreClosedAndWoundOutward) {
    std::mt19937 random(1);
    const auto even = [&] { return 384 + 2 * static_cast<int>(random() % 640); };
    for (unsigned shape = 0; shape < 200; ++shape) {
        const ivec3 size(even(), even(), even());
        expectSolid(makeBoxSolid(size), "box");
        expectSolid(makeBallSolid(size), "ball");
        expectSolid(makePrismSolid(size, shape), "prism " + std::to_string(shape));
        expectSolid(makeHullSolid(size, shape), "hull " + std::to_string(shape));
    }
}

TEST(RandomRecipes, HoldSomeOfEverythingAndFollowFromTheirSeed) {
    constexpr int kRecipes = 60;
    const std::vector<Recipe> recipes = randomRecipes(5, kRecipes), again = randomRecipes(5, kRecipes);
    ASSERT_EQ(recipes.size(), std::size_t{kRecipes});
    int kinds[4] = {}, lights[3] = {}, several = 0;
    for (std::size_t i = 0; i < recipes.size(); ++i) {
        std::ostringstream a, b;
        a << recipes[i], b << again[i];
        EXPECT_EQ(a.str(), b.str());
        for (const SolidRecipe& solid : recipes[i].solids)
            ++kinds[static_cast<int>(solid.kind)];
        for (const LightRecipe& light : recipes[i].lights)
            ++lights[static_cast<int>(light.kind)];
        several += recipes[i].solids.size() > 2;
    }
    for (const int count : kinds)
        EXPECT_GE(count, kRecipes / 8);
    for (const int count : lights)
        EXPECT_GE(count, kRecipes / 4);
    EXPECT_GE(several, kRecipes / 4);
}

/// A made-up relation that two large solids break: the counterexample has no more than what breaks it.
TEST(RandomRecipes, AreShrunk) {
    const auto found = findCounterexample(3, 200, [](const Recipe& recipe) -> Verdict {
        int large = 0;
        for (const SolidRecipe& solid : recipe.solids)
            large += solid.size.x >= 600;
        return large >= 2 ? Verdict("two of them are large") : Verdict();
    });
    ASSERT_TRUE(found);
    ASSERT_EQ(found->recipe.solids.size(), 2u);
    EXPECT_EQ(found->recipe.lights.size(), 1u);
    for (const SolidRecipe& solid : found->recipe.solids) {
        EXPECT_EQ(solid.size, ivec3(600, 0, 0));
        EXPECT_EQ(solid.kind, SolidKind::box);
    }
}

} // namespace
} // namespace shadowlab::relations
