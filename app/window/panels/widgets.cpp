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
