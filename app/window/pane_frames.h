// Where the panes lie in the window: their pictures, the bands above them with technique and verdict, and those below with legends.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

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

/// Height of a line of a legend, in em.
inline constexpr float kLegendLineEm = 1.25f;

/// Lines of the legends below each row of panes: what the pictures on show need (panels/legend_room.h).
using LegendLines = std::array<int, 2>;

/// How the area between the bars is divided. Where there is room, the bands of all layouts are equally high for pictures without a
/// legend, or with one of a line, so that a picture keeps its size.
struct PaneFrames {
    Area whole;
    int header = 0;                  ///< height in pixels; 0 where the window has no room for it
    std::array<int, 2> footers{0, 0}; ///< heights in pixels, below each row of panes
    bool isCompact = false;          ///< one line of small controls: the header of a low pane
    int headerLines = 1;             ///< two where technique and verdict do not fit into one
    int rows = 1;                    ///< of panes
    /// Below the last row.
    [[nodiscard]] int lastFooter() const { return footers[static_cast<std::size_t>(rows - 1)]; }
    /// What the pictures have together: the size that the workbench divides.
    [[nodiscard]] ivec2 pictureSize() const {
        return {whole.size.x, std::max(0, whole.size.y - rows * header - footers[0] - footers[1])};
    }
    /// From the first picture to the last.
    [[nodiscard]] Area pictures() const {
        return {whole.corner + ivec2(0, header), {whole.size.x, std::max(0, whole.size.y - header - lastFooter())}};
    }
};
/// `isCompact`: with low headers also where there is room for higher ones.
PaneFrames paneFrames(const WindowState& ui, const Theme& theme, const Area& whole, const LegendLines& legends, bool isCompact);
/// The height of the bands around one picture of that height with a compact header.
int compactBands(const Theme& theme, int pictureHeight, const LegendLines& legends);

/// Lines that a legend may have at most below a pane of that height, so that its picture keeps the larger part.
int mostLegendLines(const Theme& theme, int paneHeight);
/// Width that a legend is laid out for. In the split picture half of it, wherever the line is.
int legendWidth(picture::Layout layout, int wholeWidth);

/// Where one pane's picture lies in the window.
struct ShownPane {
    int pane = 0;
    Area area;            ///< what is seen of it
    ImVec2 pictureCorner; ///< of the whole picture, which may reach beyond the area
    ImVec2 pictureSize;
    Area footer; ///< below it
    /// Where a place of the document (lab/document.h) is on the screen.
    [[nodiscard]] ImVec2 at(const dvec2& place) const {
        const dvec2 share = lab::shareOf(place, {pictureSize.x, pictureSize.y});
        return {pictureCorner.x + static_cast<float>(share.x) * pictureSize.x,
                pictureCorner.y + static_cast<float>(share.y) * pictureSize.y};
    }
    /// The place there.
    [[nodiscard]] dvec2 placeAt(const dvec2& onScreen) const {
        const dvec2 size(pictureSize.x, pictureSize.y);
        return lab::placeOf((onScreen - dvec2(pictureCorner.x, pictureCorner.y)) / size, size);
    }
};

/// The panes that are visible now: those of the layout, or while two of them blink the one that is shown at that time.
std::vector<ShownPane> shownPanes(const WindowState& ui, const PaneFrames& frames, double seconds);

/// The band above a pane. The difference is one picture with two of them: each technique has its own.
struct PaneHeader {
    int pane = 0;
    Area area;
};
std::vector<PaneHeader> paneHeaders(const WindowState& ui, const PaneFrames& frames);

/// Whether the picture is split by a line, and where that line is: x in pixels of the window.
bool hasSplitLine(const WindowState& ui);
float splitLineX(const WindowState& ui, const Area& pictures);

} // namespace shadowlab::window
