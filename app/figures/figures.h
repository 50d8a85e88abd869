// The figures that are drawn from one pixel of a scene, by name. Each is a function from what a technique's probe says of
// the pixel to a drawing; a new one is a line in figures.cpp.
// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <span>
#include <string_view>

#include "app/drawing/formula.h"
#include "app/figures/pixel_diagram.h"
#include "techniques/technique.h"

namespace shadowlab::figures {

/// What a figure is drawn from.
struct FigureSource {
    const Probe& probe;
    std::string_view technique; ///< whose probe that is: its id, for messages
    const scene::Scene& scene;
    const View& view; ///< that the pixel belongs to: its camera, and the picture's size
    int light = kNoLight;
    const image::Font& font; ///< DejaVu Sans, by whose measures labels are placed
    const image::Font& bold; ///< DejaVu Sans Bold: vectors of formulas
    /// The room it is drawn for, in pixels of a slide 1080 high, on which kText is the least that is read. A figure whose size is
    /// given by what it shows may be of another size; it is then scaled.
    dvec2 size{1920, 1080};
    /// Two figures of one kind side by side are compared by eye, so both are drawn at the smaller of their scales
    /// (Diagram::pixelsPerMetre). With such a limit what is drawn begins at the same border in each of them.
    double mostPixelsPerMetre = std::numeric_limits<double>::infinity();

    [[nodiscard]] drawing::FormulaFonts fonts() const { return {font, bold}; }
};

struct Figure {
    std::string_view name;
    std::string_view techniques; ///< that it can be drawn of, in words
    std::string_view shows;      ///< in one line
    /// Same source, same drawing. Throws Error (badInput), which says why, where the pixel has nothing to draw.
    Diagram (*draw)(const FigureSource& source);
    double border = 24; ///< pixels of its sheet that stay empty on all sides
};

/// In the order of the lectures; the first is drawn where none is named.
std::span<const Figure> figures();

/// Throws Error (usage) with the nearest name for one that is not there.
const Figure& findFigure(std::string_view name);

} // namespace shadowlab::figures
