// Where the labels of a picture stand: beside what they name, apart from one another, within the picture.
//
// Best places are found greedily, the most important label first (after Christensen, Marks and Shieber, "An Empirical Study of
// Algorithms for Point-Feature Label Placement", 1995, of which this is the simplest): of all rectangles around all points of
// the thing, the one that costs least. A label that finds none is left out.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/picture/outside/cover_grid.h"

namespace shadowlab::picture {

/// What wants a label.
struct LabelWish {
    std::string text;
    vec3 colorLinear{0.0f};
    std::size_t thing = 0;     ///< its number in the cover grid
    std::vector<dvec2> places; ///< points of the thing in the picture, pixels from the upper left corner, the clearest first
};

struct PlacedLabel {
    std::string text;
    vec3 colorLinear{0.0f};
    PixelBox box;
    dvec2 place{0.0}; ///< the point of the thing that it stands at
    [[nodiscard]] bool standsOnIt() const { return box.holds(place); }
    /// Where the line to the thing begins.
    [[nodiscard]] dvec2 lineStart() const { return box.nearest(place); }
};

struct LabelRoom {
    ivec2 pictureSize{0};
    double em = 0;        ///< size of the type in pixels: gaps and distances are multiples of it
    double topPixels = 0; ///< of the picture that are kept for a title
};

/// `wishes`: the most important first. `sizeOf`: of a label with that text, pixels.
std::vector<PlacedLabel> placeLabels(const std::vector<LabelWish>& wishes, const CoverGrid& cover, const LabelRoom& room,
                                     const std::function<dvec2(const std::string&)>& sizeOf);

} // namespace shadowlab::picture
