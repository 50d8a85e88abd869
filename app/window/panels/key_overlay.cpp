// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/window/actions.h"
#include "app/window/line_breaks.h"

namespace shadowlab::window {

namespace {

/// Keys that do the same thing stand in one row.
struct KeyRow {
    std::string_view group;
    std::string keys;
    const char* help;
    float keysWidth = 0; ///< room for the keys, pixels: the same for all rows of a group
};

std::vector<KeyRow> keyRows() {
    std::vector<KeyRow> rows;
    for (const Action& action : actions()) {
        if (rows.empty() || std::string_view(rows.back().help) != action.help) {
            rows.push_back({.group = action.group, .keys = action.keys, .help = action.help});
            continue;
        }
        std::string& keys = rows.back().keys;
        // "1, 2, 3" and on: the first and the last say it.
        const bool digits = keys[0] >= '1' && keys[0] <= '9';
        keys = digits ? keys.substr(0, 1) + " ... " + action.keys : keys + ", " + action.keys;
    }
    return rows;
}

constexpr std::array<std::array<const char*, 2>, 9> kMouse = {{{"left", "orbits; drags lights, objects, the split line"},
                                                               {"Shift+left", "pans; lifts what is dragged"},
                                                               {"Alt+left", "orbits, whatever lies there"},
                                                               {"Ctrl+left", "picks a pixel, as X does"},
                                                               {"Shift+Ctrl+left", "picks a second one"},
                                                               {"middle", "pans"},
                                                               {"right", "looks around; with W A S D E Q flies"},
                                                               {"wheel", "nearer, farther"},
                                                               {"drop", "a scene or a mesh: shows it"}}};

constexpr float kBesideKeysEm = 0.8f; ///< between the keys and what they do
constexpr float kColumnEm = 17;       ///< width of a column at least: keys, and three or four words
constexpr float kBetweenEm = 1;       ///< columns
constexpr std::array kRowsEm = {0.35f, 0.25f, 0.15f}; ///< between rows: narrower where that saves a page
constexpr float kFootEm = 1.6f;       ///< for the line that leads to the next page
constexpr std::size_t kMostColumns = 4;

/// Where the rows stand: which of them begin a column, and how many columns a page has.
struct KeyColumns {
    float width = 0, gap = 0; ///< pixels; the gap is that between rows
    std::size_t perPage = 1;
    std::vector<std::size_t> begins;
    [[nodiscard]] std::size_t pages() const { return (begins.size() + perPage - 1) / perPage; }
    /// The first row of a page; of the page after the last one, `rows`.
    [[nodiscard]] std::size_t firstRow(std::size_t page, std::size_t rows) const {
        return page * perPage < begins.size() ? begins[page * perPage] : rows;
    }
};

/// As wide as the widest keys of the group.
void giveRoomToKeys(std::vector<KeyRow>& rows, const Theme& theme) {
    std::map<std::string_view, float> widest;
    for (const KeyRow& row : rows)
        widest[row.group] = std::max(widest[row.group], theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, row.keys.c_str()).x);
    for (KeyRow& row : rows)
        row.keysWidth = widest[row.group] + kBesideKeysEm * theme.em;
}

/// What the keys do, in lines: names of files stay whole.
std::string helpLines(const KeyRow& row, const Theme& theme, const KeyColumns& columns) {
    const auto pixelsOf = [&](const std::string& line) { return theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, line.c_str()).x; };
    std::string lines;
    for (const std::string& line : brokenText(row.help, columns.width - row.keysWidth, pixelsOf))
        lines += (lines.empty() ? "" : "\n") + line;
    return lines;
}

float rowHeight(const KeyRow& row, const Theme& theme, const KeyColumns& columns) {
    return theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, helpLines(row, theme, columns).c_str()).y + columns.gap;
}

/// A heading, with the space before it where it is not the first of its column.
float headingHeight(const Theme& theme, bool first) { return (first ? 1.4f : 2.2f) * theme.em; }

bool beginsGroup(const std::vector<KeyRow>& rows, std::size_t i) { return i == 0 || rows[i].group != rows[i - 1].group; }

/// Fills one column after the other, a heading always with its first row; a page begins with a heading.
KeyColumns filledColumns(const std::vector<KeyRow>& rows, const Theme& theme, ImVec2 room, float gapEm) {
    KeyColumns columns;
    columns.gap = gapEm * theme.em;
    columns.perPage = std::clamp<std::size_t>(static_cast<std::size_t>(room.x / ((kColumnEm + kBetweenEm) * theme.em)), 1, kMostColumns);
    columns.width = room.x / static_cast<float>(columns.perPage) - kBetweenEm * theme.em;
    float height = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float row = rowHeight(rows[i], theme, columns);
        const float heading = beginsGroup(rows, i) ? headingHeight(theme, height == 0) : 0;
        if (i > 0 && height + heading + row <= room.y) {
            height += heading + row;
            continue;
        }
        const bool headed = beginsGroup(rows, i) || columns.begins.size() % columns.perPage == 0;
        columns.begins.push_back(i);
        height = row + (headed ? headingHeight(theme, true) : 0);
    }
    return columns;
}

/// In the window's own type, however many pages that takes: smaller type is not read from the last row.
KeyColumns columnsOf(const std::vector<KeyRow>& rows, const Theme& theme, ImVec2 room) {
    KeyColumns fewest = filledColumns(rows, theme, room, kRowsEm.front());
    for (const float gapEm : kRowsEm)
        if (KeyColumns columns = filledColumns(rows, theme, room, gapEm); columns.pages() < fewest.pages()) fewest = std::move(columns);
    return fewest;
}

/// The rows of one page.
void drawPage(const std::vector<KeyRow>& rows, const KeyColumns& columns, std::size_t page, ImVec2 corner, const Theme& theme) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 plain = ImGui::GetColorU32(ImGuiCol_Text);
    const auto text = [&](float x, float y, ImU32 color, const std::string& words) {
        list.AddText(theme.text, theme.em, {x, y}, color, words.c_str());
    };
    const std::size_t first = columns.firstRow(page, rows.size());
    float x = corner.x, y = corner.y;
    for (std::size_t i = first; i < columns.firstRow(page + 1, rows.size()); ++i) {
        const bool top = std::ranges::find(columns.begins, i) != columns.begins.end();
        if (top && i > first) x += columns.width + kBetweenEm * theme.em;
        if (top) y = corner.y;
        if (i == first || beginsGroup(rows, i)) {
            y += headingHeight(theme, top);
            text(x, y - 1.3f * theme.em, kAccent, std::string(rows[i].group));
        }
        text(x, y, plain, rows[i].keys);
        text(x + rows[i].keysWidth, y, plain, helpLines(rows[i], theme, columns));
        y += rowHeight(rows[i], theme, columns);
    }
}

} // namespace

void keyOverlay(WindowState& ui, ivec2 windowSize, const Theme& theme) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({static_cast<float>(windowSize.x), static_cast<float>(windowSize.y)});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    std::vector<KeyRow> rows = keyRows();
    for (const auto& [what, does] : kMouse)
        rows.push_back({.group = "Mouse", .keys = what, .help = does});
    giveRoomToKeys(rows, theme);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImVec2 room = ImGui::GetContentRegionAvail();
    room.y -= kFootEm * theme.em;
    const KeyColumns columns = columnsOf(rows, theme, room);
    ui.keyPages = static_cast<int>(columns.pages());
    ui.keyPage = std::min(ui.keyPage, ui.keyPages - 1); // after the window has grown there are fewer
    drawPage(rows, columns, static_cast<std::size_t>(ui.keyPage), corner, theme);
    const bool isLast = ui.keyPage + 1 == ui.keyPages;
    const std::string foot = (ui.keyPages == 1 ? "" : "Page " + std::to_string(ui.keyPage + 1) + " of " + std::to_string(ui.keyPages) + "     ") +
                             (isLast ? "H, Esc: close" : "H: next page     Esc: close");
    ImGui::SetCursorScreenPos({corner.x, corner.y + room.y + 0.4f * theme.em});
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", foot.c_str());
    ImGui::End();
}

} // namespace shadowlab::window
