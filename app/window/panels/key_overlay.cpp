// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/window/actions.h"

namespace shadowlab::window {

namespace {

/// Keys that do the same thing stand in one row.
struct KeyRow {
    std::string_view group;
    std::string keys;
    const char* help;
    float keysEm = 0; ///< room for the keys, in heights of type: the same for all rows of a group
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
                                                               {"drop", "a .json or .obj file: shows it"}}};

constexpr float kBesideKeysEm = 0.8f; ///< between the keys and what they do
constexpr float kColumnEm = 16;       ///< width of a column at least: keys, and three or four words
constexpr float kBetweenEm = 1; ///< columns
constexpr float kRowEm = 0.35f; ///< between rows
constexpr int kMostColumns = 4;

/// The list in one size of type: which rows begin a column, and how high the highest is.
struct KeyColumns {
    float em = 0, columnWidth = 0, height = 0;
    std::vector<std::size_t> begins;
};

/// As wide as the widest keys of the group.
void giveRoomToKeys(std::vector<KeyRow>& rows, const Theme& theme) {
    std::map<std::string_view, float> widest;
    for (const KeyRow& row : rows)
        widest[row.group] = std::max(widest[row.group], theme.text->CalcTextSizeA(theme.em, FLT_MAX, 0, row.keys.c_str()).x);
    for (KeyRow& row : rows)
        row.keysEm = widest[row.group] / theme.em + kBesideKeysEm;
}

float rowHeight(const KeyRow& row, const Theme& theme, const KeyColumns& layout) {
    const float room = layout.columnWidth - row.keysEm * layout.em;
    return theme.text->CalcTextSizeA(layout.em, FLT_MAX, room, row.help).y + kRowEm * layout.em;
}

/// A heading, with the space before it where it is not the first of its column.
float headingHeight(const KeyColumns& layout, bool first) { return (first ? 1.4f : 2.2f) * layout.em; }

/// Fills one column after the other up to `most`, a heading always with its first row.
KeyColumns filled(const std::vector<KeyRow>& rows, const Theme& theme, KeyColumns layout, float most) {
    layout.begins = {0};
    layout.height = 0;
    float height = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool newGroup = i == 0 || rows[i].group != rows[i - 1].group;
        const float row = rowHeight(rows[i], theme, layout);
        float with = height + row + (newGroup ? headingHeight(layout, height == 0) : 0);
        if (with > most && height > 0) {
            layout.begins.push_back(i);
            with = row + (newGroup ? headingHeight(layout, true) : 0);
        }
        height = with;
        layout.height = std::max(layout.height, height);
    }
    return layout;
}

/// The largest type in which all of it is seen at once.
KeyColumns largestThatFits(const std::vector<KeyRow>& rows, const Theme& theme, ImVec2 room) {
    KeyColumns layout;
    for (layout.em = theme.em; layout.em > 0.4f * theme.em; layout.em -= 0.5f)
        for (int columns = 1; columns <= kMostColumns; ++columns) {
            layout.columnWidth = room.x / static_cast<float>(columns) - kBetweenEm * layout.em;
            if (layout.columnWidth < kColumnEm * layout.em && columns > 1) break;
            layout = filled(rows, theme, layout, room.y);
            if (layout.begins.size() <= static_cast<std::size_t>(columns) && layout.height <= room.y) return layout;
        }
    return layout; // a tiny window: what is below is cut off
}

} // namespace

void keyOverlay(ivec2 windowSize, const Theme& theme) {
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
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const KeyColumns layout = largestThatFits(rows, theme, room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto text = [&](float x, float y, ImU32 color, const std::string& words, float width = 0) {
        list.AddText(theme.text, layout.em, {x, y}, color, words.c_str(), nullptr, width);
    };
    const ImU32 plain = ImGui::GetColorU32(ImGuiCol_Text);
    float x = corner.x, y = corner.y;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool top = std::ranges::find(layout.begins, i) != layout.begins.end();
        if (top && i > 0) x += layout.columnWidth + kBetweenEm * layout.em;
        if (top) y = corner.y;
        if (i == 0 || rows[i].group != rows[i - 1].group) {
            y += headingHeight(layout, top);
            text(x, y - 1.3f * layout.em, kAccent, std::string(rows[i].group));
        }
        text(x, y, plain, rows[i].keys);
        const float keys = rows[i].keysEm * layout.em;
        text(x + keys, y, plain, rows[i].help, layout.columnWidth - keys);
        y += rowHeight(rows[i], theme, layout);
    }
    ImGui::End();
}

} // namespace shadowlab::window
