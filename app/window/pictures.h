// The picture area: the panes' pictures with their titles and legends, the split line, and what the mouse does there.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/desk.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// A rectangle of the window, in pixels from its upper left corner.
struct Area {
    ivec2 corner{0}, size{0};
    [[nodiscard]] bool contains(ImVec2 point) const {
        return point.x >= static_cast<float>(corner.x) && point.y >= static_cast<float>(corner.y) &&
               point.x < static_cast<float>(corner.x + size.x) && point.y < static_cast<float>(corner.y + size.y);
    }
};

/// Where one pane's picture lies in the window.
struct ShownPane {
    int pane = 0;
    Area area;            ///< what is seen of it
    ImVec2 pictureCorner; ///< of the whole picture, which may reach beyond the area
    ImVec2 pictureSize;
    ImVec2 legendSize{0, 0}; ///< of the plate in its lower left corner, once it is drawn
};

/// The panes that are seen now: those of the layout, or of two that take turns the one whose turn it is.
std::vector<ShownPane> shownPanes(const Desk& desk, const Area& area, double seconds);

/// Draws pictures, titles, legends and the split line, behind all widgets.
void drawPictures(Desk& desk, const lab::LiveErrors& errors, std::vector<ShownPane>& panes, const Area& area,
                  const Theme& theme);

/// Where the mouse went down, when it did since the last frame; else where it is.
ImVec2 pressPlace(const Desk& desk);

/// What the mouse does over the pictures: orbit, pan, zoom, fly, drag the split line, choose the active pane. True while
/// it moves something.
bool handleMouse(Desk& desk, const std::vector<ShownPane>& panes, const Area& area, const Theme& theme);

} // namespace shadowlab::window
