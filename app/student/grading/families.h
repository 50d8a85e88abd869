// What a technique is graded by: families of techniques, and the hard cases of each.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shadowlab::student {

/// What of a technique a case is about.
enum class Judged {
    visibility, ///< of the scene's first light, by the truth: the stage `visibility`
    picture,    ///< the finished picture, by that of the family's reference
    treeDepth,  ///< the stage `tree-depth`, by that of the family's reference
};

/// "visibility", "picture", "tree-depth".
std::string_view toText(Judged judged);

/// "1 2": the numbers.
std::vector<int> numbersIn(std::string_view text);

/// One scene that asks about one idea. Every case is a picture of kCaseWidth x kCaseHeight pixels of the scene's own camera.
struct Case {
    std::string_view id;     ///< also its scene: assets/grading/ID.json
    std::string_view idea;   ///< what is tested, in words
    /// Numbers of the blanks of the family's skeleton that it is about, with blanks between.
    std::string_view blanks;
    int limit = 0;           ///< as many pixels may be wrong
    std::string_view reason; ///< why that many
    int points = 1;
    std::string_view hint; ///< where to look if more are
    Judged judged = Judged::visibility;
};

struct Family {
    std::string_view id, title;
    std::span<const Case> cases;
    /// The technique whose pictures are right: the lecture's own. Empty: all cases are about visibility.
    std::string_view reference = {};
    /// A channel of a pixel is right if it is at most so many of 255 levels off that picture.
    int levels = 0;
};

// A shadow's outline is some 300 pixels long in such a picture, and a case takes less than a second without a graphics card.
constexpr int kCaseWidth = 320, kCaseHeight = 240;

/// planar, shadow-map, shadow-volume, ray-tracing, radiosity.
std::span<const Family> families();

/// Their ids as a list: "planar, shadow-map or ...".
std::string familyNames();

/// Throws Error (usage) naming the families there are.
const Family& findFamily(std::string_view id);

std::span<const Case> planarCases();
std::span<const Case> shadowMapCases();
std::span<const Case> shadowVolumeCases();
std::span<const Case> rayTracingCases();
std::span<const Case> radiosityCases();

} // namespace shadowlab::student
