// SPDX-License-Identifier: MIT
#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

} // namespace

bool beginIn(const char* name, const Area& area, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({static_cast<float>(area.corner.x), static_cast<float>(area.corner.y)});
    ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
    return ImGui::Begin(name, nullptr, kFixed | flags);
}

int beginBand(const BandHeading& heading, const Area& area, const Theme& theme) {
    beginIn(heading.name, area, ImGuiWindowFlags_NoNav);
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

void hint(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

bool toggleButton(const char* label, bool on, const char* help) {
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_HeaderActive]);
    if (on) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    const bool pressed = ImGui::Button(label);
    if (on) ImGui::PopStyleColor(2);
    hint(help);
    return pressed;
}

} // namespace shadowlab::window
