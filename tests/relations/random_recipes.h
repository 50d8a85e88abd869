// Relations tried on random recipes, by RapidCheck: what fails is shrunk to the smallest recipe that still fails.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/relations/recipe.h"

namespace shadowlab::relations {

/// What is wrong with a recipe; nothing: it holds.
using Verdict = std::optional<std::string>;

/// A recipe for which it does not hold, after shrinking, and what is wrong with it.
struct Counterexample {
    Recipe recipe;
    std::string wrong;
    int triedBefore = 0; ///< recipes for which it held
};

/// Numbers that the random recipes follow from. One is always the same. The other is SHADOWLAB_SEED, else with SHADOWLAB_LONG=1 another one each
/// time, so that every run tries new scenes; it is printed, and goes into messages.
std::vector<std::uint64_t> seeds();

/// Calls `check` with so many recipes (that stand free), until one is wrong. While that one is shrunk it is called with many
/// smaller ones. The last recipe it finds fault with is the counterexample.
std::optional<Counterexample> findCounterexample(std::uint64_t seed, int recipes,
                                                 const std::function<Verdict(const Recipe&)>& check);

/// The same recipes, without any check.
std::vector<Recipe> randomRecipes(std::uint64_t seed, int recipes);

/// That many are tried per seed; with SHADOWLAB_LONG=1 so many times as many.
int recipesPerSeed(int ordinary);

} // namespace shadowlab::relations
