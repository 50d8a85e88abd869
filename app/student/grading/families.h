// What a technique is graded by: families of techniques, and the hard cases of each.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

namespace shadowlab::student {

/// One scene that asks about one idea. Every case is a picture of kCaseWidth x kCaseHeight pixels of the scene's own camera, judged
/// for its first light.
struct Case {
    std::string_view id;     ///< also its scene: assets/grading/ID.json
    std::string_view idea;   ///< what is tested, in words
    int limit = 0;           ///< as many pixels may be wrong
    std::string_view reason; ///< why that many
    int points = 1;
    std::string_view hint; ///< where to look if more are
};

struct Family {
    std::string_view id, title;
    std::span<const Case> cases;
};

// A shadow's outline is some 300 pixels long in such a picture, and a case takes less than a second without a graphics card.
constexpr int kCaseWidth = 320, kCaseHeight = 240;

/// planar, shadow-map, shadow-volume.
std::span<const Family> families();

/// Throws Error (usage) naming the families there are.
const Family& findFamily(std::string_view id);

std::span<const Case> planarCases();
std::span<const Case> shadowMapCases();
std::span<const Case> shadowVolumeCases();

} // namespace shadowlab::student
