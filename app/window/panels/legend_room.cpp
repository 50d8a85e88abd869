// SPDX-License-Identifier: MIT
#include "app/window/panels/legend_room.h"

#include <algorithm>

#include "app/window/panels/legend.h"

namespace shadowlab::window {

namespace {

/// The pane's legend as it is now; nothing while its picture is still that of something else.
const lab::PanePicture* legendOf(const WindowState& ui, const lab::LiveErrors& errors, int number) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(number)];
    if (document.layout == picture::Layout::diff || state.stage.isJudged()) {
        const lab::JudgedPicture* const judged = errors.shownOn(document, number);
        return judged ? &judged->legend : nullptr;
    }
    const lab::Pane& pane = ui.bench.pane(number);
    const lab::PaneState& asked = pane.drawnFor().state;
    const bool isAsked = asked.technique == state.technique && asked.stage == state.stage;
    return isAsked && !pane.showsAnother() ? &pane.picture() : nullptr;
}

} // namespace

bool LegendRoom::follow(const WindowState& ui, const lab::LiveErrors& errors, const Area& whole, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const bool isSingle = document.layout == picture::Layout::single;
    OnShow now{document.layout, {}, whole.size, theme.em};
    std::vector<int> numbers;
    for (int i = 0; i < lab::shownPanes(document.layout); ++i)
        numbers.push_back(isSingle ? document.active : i);
    for (const int number : numbers) {
        const lab::PaneState& state = document.panes[static_cast<std::size_t>(number)];
        now.panes.emplace_back(state.technique, state.stage);
    }
    if (now != onShow_) {
        onShow_ = std::move(now);
        isNew_ = true;
    }
    if (document.layout == picture::Layout::diff) numbers.resize(1); // one picture of both
    const int rows = document.layout == picture::Layout::grid ? 2 : 1;
    const int width = legendWidth(document.layout, whole.size.x);
    // One line stands below the pictures of every layout. The difference has no more, so that its picture is as large as the others,
    // and the same pixels are counted.
    const int most = document.layout == picture::Layout::diff ? 1 : mostLegendLines(theme, whole.size.y / rows);
    LegendLines lines{0, 0};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const lab::PanePicture* const legend = legendOf(ui, errors, numbers[i]);
        if (!legend && ui.bench.pane(numbers[i]).failure().empty()) return false;
        int& row = lines[rows == 2 ? i / 2 : 0];
        if (legend) row = std::max(row, legendLines(*legend, width, most, theme));
    }
    if (!isNew_)
        for (std::size_t row = 0; row < lines.size(); ++row)
            lines[row] = std::max(lines[row], lines_[row]);
    isNew_ = false;
    const bool isChanged = lines != lines_;
    lines_ = lines;
    return isChanged;
}

} // namespace shadowlab::window
