// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/window/panels/widgets.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

/// The colour of a pane's curve, and of its number in the table.
ImU32 paneColor(int pane) {
    // Okabe and Ito, without those that mean false lit and false shadow.
    static const std::array<vec3, lab::kPanes> kColors = {
        look::linearFromSrgb8(0xF0, 0xE4, 0x42), look::linearFromSrgb8(0x56, 0xB4, 0xE9),
        look::linearFromSrgb8(0x00, 0x9E, 0x73), look::linearFromSrgb8(0xCC, 0x79, 0xA7)};
    return shownColor(kColors[static_cast<std::size_t>(pane)]);
}

constexpr double kPlotSeconds = 30; ///< the plot shows the last half minute

int panesOf(const WindowState& ui) { return lab::shownPanes(ui.bench.document().layout); }

int paneAt(const WindowState& ui, int i) {
    return ui.bench.document().layout == picture::Layout::single ? ui.bench.document().active : i;
}

/// One curve chart: `value(sample)` of each pane over the last seconds, from zero to the largest.
template <typename ValueOf>
void chart(const WindowState& ui, const lab::LiveErrors& errors, const Theme& theme, const char* label,
           const char* unit, const ValueOf& valueOf) {
    const std::deque<lab::Sample>& samples = errors.history().samples();
    const float width = ImGui::GetContentRegionAvail().x, height = theme.em * 4;
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, IM_COL32(12, 12, 14, 255));
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    double largest = 0;
    const double end = samples.empty() ? 0 : samples.back().seconds;
    for (const lab::Sample& sample : samples)
        for (const lab::SlotSample& slot : sample.slots)
            if (end - sample.seconds <= kPlotSeconds) largest = std::max(largest, valueOf(slot).value_or(0));
    // Up to a round number, so that the scale does not move with every sample.
    double top = 1e-3;
    for (int i = 0; top < largest; ++i)
        top *= i % 3 == 1 ? 2.5 : 2;
    for (int i = 0; i < panesOf(ui); ++i) {
        const int pane = paneAt(ui, i);
        ImVec2 before{};
        bool joined = false;
        for (const lab::Sample& sample : samples) {
            const std::optional<double> value = valueOf(sample.slots[static_cast<std::size_t>(pane)]);
            const double age = end - sample.seconds;
            if (!value || age > kPlotSeconds) {
                joined = false;
                continue;
            }
            const ImVec2 at(high.x - static_cast<float>(age / kPlotSeconds) * width,
                            high.y - static_cast<float>(*value / top) * (height - theme.em * 1.1f) - 1);
            if (joined) list.AddLine(before, at, paneColor(pane), 2);
            list.AddCircleFilled(at, 2, paneColor(pane));
            before = at;
            joined = true;
        }
    }
    char text[64];
    std::snprintf(text, sizeof text, "%s, 0 to %.3g %s", label, top, unit);
    list.AddText(theme.text, theme.em * 0.85f, {low.x + theme.em * 0.3f, low.y + theme.em * 0.1f}, kPlateText, text);
}

} // namespace

void errorTable(const WindowState& ui, const lab::LiveErrors& errors) {
    struct Column {
        const char *title, *help;
    };
    constexpr std::array<Column, 5> kColumns = {
        {{"", "the pane"},
         {"false lit", "pixels of the whole picture that are lit and should lie in shadow"},
         {"false sh.", "pixels of the whole picture that lie in shadow and should be lit"},
         {"edge", "how far on average the shadow's edge is from where it belongs, in pixels of the picture; not said where most wrong pixels are elsewhere"},
         {"frame", "milliseconds for the whole picture"}}};
    if (!ImGui::BeginTable("errors", static_cast<int>(kColumns.size()), ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableNextRow();
    for (const Column& column : kColumns) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", column.title);
        hint(column.help);
    }
    for (int i = 0; i < panesOf(ui); ++i) {
        const int pane = paneAt(ui, i);
        const lab::PaneErrors* const known = errors.errors(pane);
        ImGui::TableNextRow();
        const auto cell = [&](std::size_t column, const std::string& text) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
            hint(kColumns[column].help);
        };
        ImGui::TableNextColumn();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(paneColor(pane)), "%d", pane + 1);
        char edge[32] = "-";
        if (known && known->saidEdgeErrorPx()) std::snprintf(edge, sizeof edge, "%.3f px", *known->saidEdgeErrorPx());
        cell(1, known ? std::to_string(known->counts.falseLit) : "-");
        cell(2, known ? std::to_string(known->counts.falseShadow) : "-");
        cell(3, edge);
        cell(4, ui.live && ui.showsTimes ? std::to_string(std::lround(ui.bench.pane(pane).rendered().frameMs)) + " ms" : "- ms");
    }
    ImGui::EndTable();
    ImGui::TextDisabled(errors.isDone() ? "of the whole picture, exact" : "without ties; exact when all is at rest");
}

void historyPlot(const WindowState& ui, const lab::LiveErrors& errors, const Theme& theme) {
    if (!ui.live || !ui.showsTimes) return; // a plot over time is never the same twice
    chart(ui, errors, theme, "frame", "ms",
          [](const lab::SlotSample& s) { return s.frameMs > 0 ? std::optional(s.frameMs) : std::nullopt; });
    chart(ui, errors, theme, "edge error", "px", [](const lab::SlotSample& s) { return s.edgeErrorPx; });
}

} // namespace shadowlab::window
