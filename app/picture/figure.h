// A finished figure from the pictures of several slots: layout, titles, legends.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/image/text.h"
#include "techniques/frame.h"

namespace shadowlab::picture {

enum class Layout {
    single, ///< one picture
    side,   ///< side by side, each a picture of its own
    split,  ///< one picture in vertical bands, each drawn by another slot
    grid,   ///< rows and columns; the last row may have empty places at its end
    diff,   ///< one picture of where two slots differ, and which of them is right
};

/// Where a slot is drawn: its rectangle in the figure, and the size its picture is rendered at.
struct Cell {
    int x = 0, y = 0, width = 0, height = 0;
    ivec2 pictureSize{0};
    int cropX = 0; ///< column of the picture at the cell's left edge
};
/// One cell for each of `count` slots (of `diff`: one for all), in rows from the upper left. Their sizes differ by one
/// pixel at most; but of two bands of `split` the left one has that share of the width.
std::vector<Cell> layoutCells(Layout layout, int count, ivec2 size, double splitShare = 0.5);

/// One slot's part of the figure.
struct Panel {
    image::Image picture;
    std::string title; ///< empty: no label
    StageKind kind = StageKind::radiance;
    Display display;  ///< for the legend
    std::string note{}; ///< how it is shown, where that is not as it is: "shown 8 times brighter"; empty: as it is
};

struct Figure {
    image::Image picture;
    std::vector<std::string> notes; ///< what was left out because the picture is too small for it
};

/// Puts the panels into their cells, with titles above and legends below. Type is at least 1/45 of the figure's height
/// and 10 pixels high. Where titles, or legends, would then cover more than a third of a cell, all of them are left
/// out. `font` may be null when nothing is to be labelled.
Figure composeFigure(const std::vector<Cell>& cells, const std::vector<Panel>& panels, ivec2 size,
                     const image::Font* font);

/// Does a figure of this panel need a legend?
bool hasLegend(const Panel& panel);

} // namespace shadowlab::picture
