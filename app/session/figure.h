// A finished figure from the pictures of several slots: layout, titles, legends.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/image/text.h"
#include "techniques/frame.h"

namespace shadowlab::session {

enum class Layout {
    single, ///< one picture
    side,   ///< side by side, each a picture of its own
    split,  ///< one picture in vertical bands, each drawn by another slot
    grid,   ///< rows and columns
};

/// Where slot `index` of `count` is drawn: its rectangle in the figure, and the size its picture is rendered at.
struct Cell {
    int x = 0, y = 0, width = 0, height = 0;
    ivec2 pictureSize{0};
    int cropX = 0; ///< column of the picture that comes to the cell's left edge
};
std::vector<Cell> layoutCells(Layout layout, int count, ivec2 size);

/// One slot's part of the figure.
struct Panel {
    image::Image picture;
    std::string title;    ///< empty: no label
    StageKind kind = StageKind::radiance;
    Display display;      ///< for the legend
};

/// Puts the panels into their cells, with titles and legends. `font` may be null when nothing is to be labelled.
image::Image composeFigure(const std::vector<Cell>& cells, const std::vector<Panel>& panels, ivec2 size,
                           const image::Font* font);

/// Does a figure of this panel need a legend?
bool hasLegend(const Panel& panel);

} // namespace shadowlab::session
