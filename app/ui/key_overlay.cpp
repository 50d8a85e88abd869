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
    const float widest = theme.em * 26;
    const int columns = std::clamp(static_cast<int>(ImGui::GetContentRegionAvail().x / widest), 1, 3);
    const std::vector<KeyRow> rows = keyRows();
    // Columns of about equal length; the mouse stands below the keys of the last.
    const std::size_t perColumn = (rows.size() + kMouseRows + 12) / static_cast<std::size_t>(columns) + 1;
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
            ImGui::SameLine(theme.em * kKeysEm);
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
            ImGui::SameLine(theme.em * kKeysEm);
            ImGui::TextWrapped("%s", does);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace shadowlab::ui
