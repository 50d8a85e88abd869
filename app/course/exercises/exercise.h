// Exercises with random numbers, for paper and pencil: what stands on the question sheet, and what in the key.
//
// Numbers are chosen so that a student can calculate with them, and so that nothing that is asked lies near a limit. What depends on a scene is
// answered by a technique's probe, or by the rays that judge techniques; the rest by the lecture's formulas.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/course/exercises/chance.h"
#include "app/drawing/drawing.h"

namespace shadowlab::course {

/// A number by its name.
struct NamedNumber {
    std::string name;
    double value = 0;
    bool operator==(const NamedNumber&) const = default;
};

struct ExerciseFigure {
    drawing::Drawing drawing;
    std::string title; ///< what it shows, for who cannot see it; nothing of the answer
};

/// Texts are prose with formulas between two $ (drawing/prose.h).
struct Exercise {
    std::string kind, title;
    std::string given;                  ///< all that is needed beside the figure
    std::vector<std::string> questions; ///< one or more
    std::vector<std::string> answers;   ///< as many, for the key
    std::string working;                ///< how they are found, for the key
    std::string mistake;                ///< the usual one, for the key
    std::optional<ExerciseFigure> figure;
    std::vector<NamedNumber> data;    ///< what the sheet says, for those who compute the answers again
    std::vector<NamedNumber> results; ///< the answers as they were computed, not rounded
};

struct ExerciseKind {
    std::string_view name;  ///< on the command line
    std::string_view title; ///< of the exercise
    Exercise (*make)(Chance& chance);
};

/// In the order of the lectures.
std::span<const ExerciseKind> exerciseKinds();

/// Throws Error (usage) with the nearest name for one that is not there.
const ExerciseKind& findExerciseKind(std::string_view name);

/// So many exercises of those kinds, in the order of the lectures, no two the same; each kind is asked before one is asked again. The same
/// seed, the same exercises. Throws Error (usage) where a kind has fewer; each has 48 and more.
std::vector<Exercise> makeExercises(std::uint64_t seed, int count, const std::vector<const ExerciseKind*>& kinds);

} // namespace shadowlab::course
