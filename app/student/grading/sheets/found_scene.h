// What a sheet says of a search for a failing scene (search/search.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::student {

struct FoundScene {
    std::string idea;     ///< of the random scene: "a caster above the lamp"
    std::string sentence; ///< what is observed
    std::string counted;  ///< in what picture, and which pixels
    std::vector<int> blanks; ///< that it may be about
    int number = 0;          ///< of the random scene, counted from 1
    int triangles = 0, trianglesBefore = 0, attempts = 0;
    int wrong = 0, falseLit = 0, falseShadow = 0;
    std::string picture, figure;    ///< PNG and SVG; empty: there is none
    std::string scene, lesson;      ///< names of the files that were written; empty: none
};

struct SearchReport {
    int asked = 0, tried = 0, unfair = 0;
    std::uint64_t seed = 0;
    bool isOutOfTime = false;
    std::optional<FoundScene> found;
};

/// "15 of 60 random scenes (seed 1) were tried ...": what came of it, in a sentence or two.
std::string toText(const SearchReport& report);

} // namespace shadowlab::student
