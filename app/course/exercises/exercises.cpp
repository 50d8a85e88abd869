// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/course/exercises/kinds.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::course {

namespace {

constexpr std::array kKinds{
    ExerciseKind{"projection", "Direct projection", askForProjection},
    ExerciseKind{"plane", "Points and a plane", askForPlaneHeights},
    ExerciseKind{"pixels", "Pixels in shadow", askForShadowedPixels},
    ExerciseKind{"depths", "Shadow map: two depths", askForMapDepths},
    ExerciseKind{"texel", "Shadow map: the texel", askForTexel},
    ExerciseKind{"counts", "Shadow volumes: counting faces", askForFaceCounts},
    ExerciseKind{"extrusion", "Shadow volumes: extrusion", askForExtrusion},
    ExerciseKind{"reflection", "Ray tracing: the reflected ray", askForReflection},
    ExerciseKind{"refraction", "Ray tracing: the refracted ray", askForRefraction},
    ExerciseKind{"tree", "Ray tracing: the size of a tree", askForTreeSize},
    ExerciseKind{"intensity", "Ray tracing: intensities in a tree", askForIntensity},
    ExerciseKind{"shades", "Supersampling", askForShades},
    ExerciseKind{"penumbra", "Soft shadows", askForPenumbra},
    ExerciseKind{"form-factor", "Radiosity: a form factor", askForFormFactor},
    ExerciseKind{"row-sum", "Radiosity: form factors of a box", askForRowSum},
    ExerciseKind{"two-patches", "Radiosity: two patches", askForTwoPatches},
};

/// One that asks for something else than those of its kind that are there.
Exercise differentExercise(const ExerciseKind& kind, Chance& chance, std::span<const Exercise> others) {
    // The kind with the fewest has 64 different ones: the last of 48 is found in 1 of 4 tries, and fails all of these once in 10^124.
    constexpr int kMostTries = 1000;
    for (int i = 0; i < kMostTries; ++i) {
        Exercise exercise = kind.make(chance);
        const bool isThere = std::ranges::any_of(others, [&](const Exercise& other) {
            return other.kind == kind.name && other.given == exercise.given && other.data == exercise.data;
        });
        if (!isThere) return exercise;
    }
    throw Error(ExitStatus::usage, "there are not so many different exercises of the kind '" + std::string(kind.name) +
                                       "'; ask for fewer, or for more kinds");
}

} // namespace

std::span<const ExerciseKind> exerciseKinds() { return kKinds; }

const ExerciseKind& findExerciseKind(std::string_view name) {
    const auto found = std::ranges::find(kKinds, name, &ExerciseKind::name);
    if (found != kKinds.end()) return *found;
    std::vector<std::string> known;
    for (const ExerciseKind& kind : kKinds)
        known.emplace_back(kind.name);
    throw Error(ExitStatus::usage,
                "there is no kind of exercise '" + std::string(name) + "'; " + suggestion(name, known));
}

std::vector<Exercise> makeExercises(std::uint64_t seed, int count, const std::vector<const ExerciseKind*>& kinds) {
    Chance chance(seed);
    std::vector<const ExerciseKind*> order, chosen;
    while (chosen.size() < static_cast<std::size_t>(count)) {
        if (order.empty()) {
            order = kinds;
            chance.shuffle(order);
        }
        chosen.push_back(order.back());
        order.pop_back();
    }
    std::ranges::stable_sort(chosen, {}, [](const ExerciseKind* kind) { return kind - kKinds.data(); });
    std::vector<Exercise> exercises;
    for (const ExerciseKind* kind : chosen) {
        exercises.push_back(differentExercise(*kind, chance, exercises));
        exercises.back().kind = kind->name;
        exercises.back().title = kind->title;
    }
    return exercises;
}

std::string printed(double value) {
    // 1/32 has five digits after the point. What differs from such a number by less than a millionth of its last digit differs by rounding.
    constexpr int kUsualDigits = 3, kMostDigits = 5;
    const auto isExactWith = [&](int digits) {
        const double scaled = value * std::pow(10, digits);
        return std::abs(scaled - std::round(scaled)) < 1e-6;
    };
    int digits = kUsualDigits;
    while (digits < kMostDigits && !isExactWith(digits))
        ++digits;
    if (!isExactWith(digits)) digits = kUsualDigits;
    const double scale = std::pow(10, digits), rounded = std::round(value * scale) / scale + 0.0; // no "-0"
    std::array<char, 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed, digits);
    if (error != std::errc{}) return "?";
    std::string text(buffer.data(), end);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string printed(const dvec3& vector) {
    return "(" + printed(vector.x) + ", " + printed(vector.y) + ", " + printed(vector.z) + ")";
}

void addVector(std::vector<NamedNumber>& numbers, const std::string& name, const dvec3& vector) {
    numbers.insert(numbers.end(), {{name + ".x", vector.x}, {name + ".y", vector.y}, {name + ".z", vector.z}});
}

} // namespace shadowlab::course
