// The pictures of the panes, with what is drawn over them and the legends below, and the split line.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/panels/probe_card.h"

namespace shadowlab::window {

/// What is written over one pane's picture, and beside what.
struct PaneSigns {
    int pane = 0;
    FreePlaces places; ///< taken by things, and by icons and names
    std::vector<PlaceBox> names;
    std::optional<ProbeCard> card;
};

/// Draws them behind all widgets.
std::vector<PaneSigns> drawPictures(WindowState& ui, const lab::LiveErrors& errors, const std::vector<ShownPane>& panes,
                                    const PaneFrames& frames, const Theme& theme);

/// What is to be said of the pane while its picture is not finished: in full, and shorter. One empty text when there is nothing.
std::vector<std::string> progressOf(const WindowState& ui, const lab::LiveErrors& errors, int pane);

} // namespace shadowlab::window
