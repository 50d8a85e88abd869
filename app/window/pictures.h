// The picture area: the panes' pictures with their titles and legends, and the split line.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/theme.h"
#include "app/window/window_state.h"

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

/// The panes that are visible now: those of the layout, or while two of them blink the one that is shown at that time.
std::vector<ShownPane> shownPanes(const WindowState& ui, const Area& area, double seconds);

/// Draws pictures, titles, legends and the split line, behind all widgets.
void drawPictures(WindowState& ui, const lab::LiveErrors& errors, std::vector<ShownPane>& panes, const Area& area,
                  const Theme& theme);

/// Whether the picture is split by a line, and where that line is: x in pixels of the window.
bool hasSplitLine(const WindowState& ui);
float splitLineX(const WindowState& ui, const Area& area);

} // namespace shadowlab::window
