// "did you mean ...?": the known names closest to a mistyped one.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab {

/// Names within a few edits (Levenshtein distance at most a third of the length, at least 2), nearest first, at most 3.
std::vector<std::string> nearestNames(std::string_view typed, std::span<const std::string> known);

/// `did you mean "a" or "b"?` when something is near, else `known: a, b, c`.
std::string suggestion(std::string_view typed, std::span<const std::string> known);

} // namespace shadowlab
