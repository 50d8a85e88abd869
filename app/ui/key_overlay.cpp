// SPDX-License-Identifier: MIT
#include "app/ui/key_overlay.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/actions.h"

namespace shadowlab::ui {

namespace {

/// Keys that do the same thing stand in one row.
struct KeyRow {
    std::string_view group;
    std::string keys;
    const char* help;
};

std::vector<KeyRow> keyRows() {
    std::vector<KeyRow> rows;
    for (const Action& action : actions()) {
        if (rows.empty() || std::string_view(rows.back().help) != action.help) {
            rows.push_back({action.group, action.keys, action.help});
            continue;
        }
        std::string& keys = rows.back().keys;
        // "1, 2, 3" and on: the first and the last say it.
        const bool digits = keys[0] >= '1' && keys[0] <= '9';
        keys = digits ? keys.substr(0, 1) + " ... " + action.keys : keys + ", " + action.keys;
    }
    return rows;
}

constexpr float kKeysEm = 9.5f; ///< room for the longest name of keys
constexpr std::size_t kMouseRows = 8;

constexpr std::size_t kHeadings = 12; ///< lines that the headings of the groups take

/// How large the type can be so that the whole list is seen at once, and in how many columns.
struct Fit {
    float scale = 1;
    int columns = 1;
};

Fit fitOf(std::size_t rows, const Theme& theme) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    Fit fit;
    for (; fit.scale > 0.5f; fit.scale -= 0.05f) { // half of the size that is right for all else is the least
        const float em = theme.em * fit.scale;
        fit.columns = std::clamp(static_cast<int>(room.x / (26 * em)), 1, 3);
        // A fifth of the rows takes two lines.
        const float lines =
            1.2f * static_cast<float>(rows + kMouseRows + kHeadings) / static_cast<float>(fit.columns) + 3;
        if (lines * em * 1.3f < room.y) break;
    }
    return fit;
}

} // namespace

void keyOverlay(ivec2 windowSize, const Theme& theme) {
    const float margin = theme.em;
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSize(
        {static_cast<float>(windowSize.x) - 2 * margin, static_cast<float>(windowSize.y) - 2 * margin});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("All keys", nullptr,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    const std::vector<KeyRow> rows = keyRows();
    const Fit fit = fitOf(rows.size(), theme);
    ImGui::SetWindowFontScale(fit.scale);
    const float keysWidth = theme.em * kKeysEm * fit.scale;
    const int columns = fit.columns;
    // Columns of about equal length; the mouse stands below the keys of the last.
    const std::size_t perColumn = (rows.size() + kMouseRows + kHeadings) / static_cast<std::size_t>(columns) + 1;
    if (ImGui::BeginTable("keys", columns)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        std::size_t lines = 0;
        std::string_view group;
        for (const KeyRow& row : rows) {
            const bool newGroup = row.group != group;
            if (lines >= perColumn) {
                ImGui::TableNextColumn();
                lines = 0;
            }
            if (newGroup && lines > 0) ImGui::Spacing();
            if (newGroup) {
                ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", std::string(row.group).c_str());
                lines += 2;
            }
            group = row.group;
            ImGui::TextUnformatted(row.keys.c_str());
            ImGui::SameLine(keysWidth);
            ImGui::TextWrapped("%s", row.help);
            ++lines;
        }
        ImGui::Spacing();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "Mouse");
        constexpr std::array<std::array<const char*, 2>, 6> kMouse = {
            {{"left", "orbits; drags handles and the split line"},
             {"Shift+left", "pans; lifts a handle"},
             {"middle", "pans"},
             {"right", "looks around; with W A S D E Q flies"},
             {"wheel", "nearer, farther"},
             {"drop", "a .json or .obj file: shows it"}}};
        for (const auto& [what, does] : kMouse) {
            ImGui::TextUnformatted(what);
            ImGui::SameLine(keysWidth);
            ImGui::TextWrapped("%s", does);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace shadowlab::ui
