// Where a slide has its parts. Lengths are in units of which a slide is 1080 high, so that all sizes look alike.
//
// Title, first picture, caption and, where there is no picture, the words begin at one left edge. Pictures of a row are equally high; what
// stands above one (its label) and below it (its legend) covers nothing of it. Words take no more of the width than they need. Where
// pictures would leave a side of the slide empty, the caption stands there, beside them. One picture of any shape before three square ones,
// as a scene before the maps of three lights, is large: the three stand beside it, two above one, with the caption in the fourth place.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/drawing/labels.h"
#include "app/drawing/prose.h"

namespace shadowlab::course {

using drawing::Box;

constexpr double kSlideHeight = 1080;
constexpr double kLeastType = kSlideHeight / 45; ///< what is read from the last row of a lecture hall
constexpr double kMargin = 56, kTitleType = 48, kCaptionType = 28, kFootType = kLeastType, kLabelType = 26;
/// From foot to foot of lines, in em.
constexpr double kLineHeight = 1.3;

/// The fonts of a slide.
struct Fonts {
    const image::Font &upright, &bold;
    [[nodiscard]] drawing::FormulaFonts formula() const { return {upright, bold}; }
};

/// What a picture asks of the layout.
struct PictureNeeds {
    std::string label{}; ///< above it, with formulas between $; empty: none
    bool isDrawing = false;                           ///< of any shape; others are seen in the shapes that scenes are framed for
    std::optional<double> aspect{};                   ///< width / height that it has of its own, as a light's square view; none: any
    std::function<double(double width)> legendHeight{}; ///< of its legend in that width; empty: it has none
};

struct SlideLayout {
    double width = 1920;
    Box pictures;                          ///< all of them together, with labels and legends; empty: none
    std::vector<Box> labels;               ///< of each picture: the lines above it; empty where no picture has a label
    std::vector<Box> cells;                ///< of each picture, label and legend left out
    std::vector<Box> legends;              ///< of each picture: the room below it, as wide as it is
    Box content;                           ///< all between title and caption
    Box words;                             ///< text, formulas, pseudocode, or the caption; empty: none
    bool isFirstLarge = false;             ///< beside the first picture all others stand in two rows
    bool hasCaptionBeside = false;         ///< the caption stands in `words`, and `caption` is empty
    double captionTop = 0;                 ///< of the first line of the caption
    std::vector<drawing::ProseLine> title; ///< lines
    std::vector<drawing::ProseLine> caption;
    double captionType = kCaptionType; ///< em
};

/// The layout of a slide of that width; `needs` of its pictures, in order. As large pictures as fit: of all numbers of columns the one
/// that gives them most room.
SlideLayout layOut(const Slide& slide, double width, const Fonts& fonts, std::span<const PictureNeeds> needs);

} // namespace shadowlab::course
