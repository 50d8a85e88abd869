// SPDX-License-Identifier: MIT
#include "app/window/panels/band.h"

#include <imgui.h>

namespace shadowlab::window {

int beginBand(const BandHeading& heading, const Area& area, const Theme& theme) {
    ImGui::SetNextWindowPos({static_cast<float>(area.corner.x), static_cast<float>(area.corner.y)});
    ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
    ImGui::Begin(heading.name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    int by = 0;
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) by = -1;
    ImGui::SameLine();
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) by = 1;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.heading);
    ImGui::TextUnformatted(heading.title.c_str());
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", heading.place.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    const float hintX =
        static_cast<float>(area.size.x) - ImGui::CalcTextSize(heading.hint).x - ImGui::GetStyle().WindowPadding.x;
    if (hintX > ImGui::GetCursorPosX()) {
        ImGui::SetCursorPosX(hintX);
        ImGui::TextDisabled("%s", heading.hint);
    } else {
        ImGui::NewLine();
    }
    return by;
}

float wrappedHeight(ImFont* font, float size, const std::string& text, float width) {
    return font->CalcTextSizeA(size, FLT_MAX, width, text.c_str()).y;
}

} // namespace shadowlab::window
