// SPDX-License-Identifier: MIT
#include "app/window/pane_frames.h"

#include <cmath>

#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr double kBlinkSeconds = 0.6; ///< of each picture: slow enough to see it, quick enough that differences jump
constexpr float kHeaderEm = 1.75f, kSecondLineEm = 1.25f; ///< heights of a header's line of widgets, and of its line of text
constexpr float kCompactEm = 1.45f;                       ///< height of a header in a low pane
constexpr float kLegendRimEm = 0.25f;
constexpr float kOneLineEm = 40; ///< width in which technique, view and verdict stand side by side
constexpr float kLowEm = 9;      ///< a picture that would be lower than that has a compact header,
constexpr float kLowestEm = 3;   ///< and one that would be lower than that has no bands
constexpr float kLegendShare = 0.4f; ///< of a pane's height, for its legend at most

int footerHeight(const Theme& theme, int lines) {
    return lines == 0 ? 0 : static_cast<int>(std::round((static_cast<float>(lines) * kLegendLineEm + kLegendRimEm) * theme.em));
}

int compactHeader(const Theme& theme) { return static_cast<int>(std::round(kCompactEm * theme.em)); }

} // namespace

int compactBands(const Theme& theme, int pictureHeight, const LegendLines& legends) {
    // The legend's share is one of the pane, which is at least as high as its picture: so these lines fit there.
    return compactHeader(theme) + footerHeight(theme, std::min(legends[0], mostLegendLines(theme, pictureHeight)));
}

int mostLegendLines(const Theme& theme, int paneHeight) {
    return std::max(1, static_cast<int>((kLegendShare * static_cast<float>(paneHeight)) / (kLegendLineEm * theme.em)));
}

int legendWidth(Layout layout, int wholeWidth) {
    return layout == Layout::single || layout == Layout::diff ? wholeWidth : wholeWidth / 2;
}

PaneFrames paneFrames(const WindowState& ui, const Theme& theme, const Area& whole, const LegendLines& legends, bool isCompact) {
    PaneFrames frames{.whole = whole};
    frames.rows = ui.bench.document().layout == Layout::grid ? 2 : 1;
    const int paneHeight = whole.size.y / frames.rows;
    // By half of the width in every layout, so that single pictures are as large as split ones.
    frames.headerLines = static_cast<float>(whole.size.x) / 2 < kOneLineEm * theme.em ? 2 : 1;
    int header = static_cast<int>(std::round((kHeaderEm + static_cast<float>(frames.headerLines - 1) * kSecondLineEm) * theme.em));
    frames.isCompact = isCompact || static_cast<float>(paneHeight - header - footerHeight(theme, 1)) < kLowEm * theme.em;
    if (frames.isCompact) {
        frames.headerLines = 1;
        header = compactHeader(theme);
    }
    std::array<int, 2> footers{0, 0};
    for (int row = 0; row < frames.rows; ++row) {
        const auto index = static_cast<std::size_t>(row);
        const int lines = std::min(legends[index], mostLegendLines(theme, paneHeight));
        footers[index] = footerHeight(theme, frames.isCompact ? lines : std::max(1, lines));
    }
    const int pictures = whole.size.y - frames.rows * header - footers[0] - footers[1];
    if (static_cast<float>(pictures / frames.rows) < kLowestEm * theme.em) return frames;
    frames.header = header;
    frames.footers = footers;
    return frames;
}

std::vector<ShownPane> shownPanes(const WindowState& ui, const PaneFrames& frames, double seconds) {
    std::vector<ShownPane> panes;
    for (const lab::PlacedPane& placed : ui.bench.placed(frames.pictureSize())) {
        const picture::Cell& cell = placed.cell;
        const int row = cell.y > 0 ? 1 : 0, footer = frames.footers[static_cast<std::size_t>(row)];
        ShownPane shown;
        shown.pane = placed.pane;
        shown.area = {frames.whole.corner + ivec2(cell.x, cell.y + (row + 1) * frames.header + row * frames.footers[0]),
                      {cell.width, cell.height}};
        shown.pictureCorner = imVec(shown.area.corner - ivec2(cell.cropX, 0));
        shown.pictureSize = imVec(cell.pictureSize);
        shown.footer = {shown.area.corner + ivec2(0, cell.height), {cell.width, footer}};
        panes.push_back(shown);
    }
    if (ui.bench.document().layout == Layout::diff && panes.size() > 1) panes.pop_back(); // one picture of both
    if (ui.shown.blink && panes.size() >= 2) {
        const int turn = static_cast<int>(seconds / kBlinkSeconds) % 2;
        ShownPane shown = panes[static_cast<std::size_t>(turn)];
        shown.area = frames.pictures();
        shown.pictureCorner = imVec(shown.area.corner);
        shown.pictureSize = imVec(shown.area.size);
        shown.footer = {shown.area.corner + ivec2(0, shown.area.size.y), {shown.area.size.x, frames.lastFooter()}};
        return {shown};
    }
    return panes;
}

std::vector<PaneHeader> paneHeaders(const WindowState& ui, const PaneFrames& frames) {
    std::vector<PaneHeader> headers;
    if (frames.header == 0) return headers;
    const Layout layout = ui.bench.document().layout;
    const int columns = layout == Layout::single ? 1 : 2, half = frames.whole.size.x / columns;
    const int below = frames.header + frames.pictureSize().y / 2 + frames.footers[0]; // where the grid's second row begins
    const int count = ui.shown.blink ? std::min(2, lab::shownPanes(layout)) : lab::shownPanes(layout); // the picture covers the others
    for (int i = 0; i < count; ++i)
        headers.push_back({layout == Layout::single ? ui.bench.document().active : i,
                           {frames.whole.corner + ivec2(i % columns * half, i / columns * below),
                            {i % columns + 1 == columns ? frames.whole.size.x - i % columns * half : half, frames.header}}});
    return headers;
}

float splitLineX(const WindowState& ui, const Area& pictures) {
    return std::round(static_cast<float>(pictures.corner.x) +
                      static_cast<float>(ui.bench.document().split) * static_cast<float>(pictures.size.x));
}

bool hasSplitLine(const WindowState& ui) { return ui.bench.document().layout == Layout::split && !ui.shown.blink; }

} // namespace shadowlab::window
