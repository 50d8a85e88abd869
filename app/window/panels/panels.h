// The panels around the pictures, and what is drawn over them. Each draws into the area it is given; heights are in pixels.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/lab/errors/live_errors.h"
#include "app/lab/stage_strip.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "app/window/window_state.h"

namespace shadowlab::window {

// The line at the top: the scene, and buttons with icons for what is used most. It never wraps: where it is too short, some are left out.
float topBarHeight();
void topBar(WindowState& ui, const Area& area, const Theme& theme);

/// The type of all panes' headers, as a share of the type's size: smaller where technique and view of one of them would be cut.
float headerTypeShare(const WindowState& ui, const lab::LiveErrors& errors, const PaneFrames& frames, const Theme& theme);
/// The band above a pane: its technique, what is shown of it, and how wrong it is. True while its list of views is open.
bool paneHeader(WindowState& ui, const lab::LiveErrors& errors, const lab::StageStrip& strip, const PaneHeader& header,
                const PaneFrames& frames, float typeShare, const Theme& theme);

// Beside the pictures: all about the active pane.
void sidePanel(WindowState& ui, const lab::LiveErrors& errors, const Area& area, const Theme& theme);
/// What the panel beside the pictures shows: all about the pane, or the source of its step.
void panelTabs(WindowState& ui);
/// The settings of the active pane's technique, made from its parameter list: the basic ones, then the groups, folded. Each is a
/// checkbox, slider or choice with its label, value, help, range and a way back to its default.
void parameterPanel(WindowState& ui, const Theme& theme);
/// Of the view from outside: all shadow volumes or one, and the near-clip pyramid. For panes that look from there.
void outsidePanel(WindowState& ui);
/// What the active pane's technique reports about the picked pixel: facts, and the tree of its rays. Nothing while none is picked.
void pixelPanel(WindowState& ui);
/// Errors and frame times, a row for each pane on show.
void errorTable(const WindowState& ui, const lab::LiveErrors& errors);
/// Frame times above, edge errors below, one curve for each pane on show.
void historyPlot(const WindowState& ui, const lab::LiveErrors& errors, const Theme& theme);

// Below the pictures, and below the band (story_bar.h).
/// How large the strip is.
struct StripShape {
    int height = 0;
    ivec2 thumbnail{0}; ///< the size of one small picture
    int captionLines = 0;
};
/// As high as it needs, in `most` pixels; not lower than pictures need in which something is seen.
StripShape stripShape(const Theme& theme, float most);
/// All stages as small pictures; a click fills the active pane with one.
void stripPanel(WindowState& ui, const lab::StageStrip& strip, const Area& area, const StripShape& shape, const Theme& theme);

// Over the pictures.
/// The same place of every pane's picture, enlarged until single pixels are seen, in the lower right corner of each pane. Of a
/// stage that is judged it shows the verdicts, each wrong pixel as one.
void drawMagnifiers(WindowState& ui, const lab::LiveErrors& errors, const std::vector<ShownPane>& panes, const Theme& theme);
/// One magnifier's glass: squares of `cell` pixels of the window, each a pixel of the picture.
struct Glass {
    ImVec2 corner; ///< upper left, in pixels of the window
    int cell = 0, across = 0;
    ivec2 firstPixel{0}; ///< of the picture, in the upper left cell; may lie outside of it
};
/// Around the pixel `middle` (counted from the upper left) of the pane's picture. Nothing where there is no room to enlarge it.
std::optional<Glass> glassOver(const ShownPane& pane, ivec2 middle, const Theme& theme);
/// The list of all keys, made from the actions.
void keyOverlay(WindowState& ui, ivec2 windowSize, const Theme& theme);

} // namespace shadowlab::window
