// Where a slide has its parts. Lengths are in units of which a slide is 1080 high, so that all sizes look alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/drawing/formula.h"
#include "app/drawing/labels.h"

namespace shadowlab::course {

using drawing::Box;

constexpr double kSlideHeight = 1080;
constexpr double kLeastType = kSlideHeight / 45; ///< what is read from the last row of a lecture hall

/// The fonts of a slide.
struct Fonts {
    const image::Font &upright, &bold;
    [[nodiscard]] drawing::FormulaFonts formula() const { return {upright, bold}; }
};

struct SlideLayout {
    double width = 1920;
    Box pictures;                   ///< all of them together; empty: none
    std::vector<Box> cells;         ///< of each picture, its label above it left out
    std::vector<double> roomBelow;  ///< of each: how much higher it may become for its legend
    Box content;                    ///< all between title and caption
    Box words;                      ///< text, formulas, pseudocode; empty: none
    std::vector<std::string> title; ///< lines
    std::vector<std::string> caption;
};

/// The layout of a slide of that width.
SlideLayout layOut(const Slide& slide, double width, const Fonts& fonts);

constexpr double kMargin = 56, kTitleType = 48, kCaptionType = 28, kFootType = kLeastType, kLabelType = 26;
/// From foot to foot of lines, in em.
constexpr double kLineHeight = 1.3;

} // namespace shadowlab::course
