// Two hundred sheets of random exercises, made once for all tests.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/course/exercises/exercise.h"

namespace shadowlab::course {

constexpr int kSeeds = 200;

inline std::vector<const ExerciseKind*> allKinds() {
    std::vector<const ExerciseKind*> kinds;
    for (const ExerciseKind& kind : exerciseKinds())
        kinds.push_back(&kind);
    return kinds;
}

/// All sheets, each with every kind once; made once for all tests.
inline const std::vector<std::vector<Exercise>>& sheets() {
    static const std::vector<std::vector<Exercise>> made = [] {
        std::vector<std::vector<Exercise>> all;
        for (int seed = 1; seed <= kSeeds; ++seed)
            all.push_back(
                makeExercises(static_cast<std::uint64_t>(seed), static_cast<int>(exerciseKinds().size()), allKinds()));
        return all;
    }();
    return made;
}

inline double in(const std::vector<NamedNumber>& numbers, const std::string& name) {
    const auto found = std::ranges::find(numbers, name, &NamedNumber::name);
    EXPECT_NE(found, numbers.end()) << name;
    return found == numbers.end() ? std::nan("") : found->value;
}

} // namespace shadowlab::course
