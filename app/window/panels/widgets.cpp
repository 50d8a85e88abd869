// SPDX-License-Identifier: MIT
#include "app/window/panels/widgets.h"

#include "app/window/line_breaks.h"

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

void wholeNumbersText(const std::string& text) {
    const auto widthOf = [](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x; };
    std::string lines;
    for (const std::string& line : brokenText(text, ImGui::GetContentRegionAvail().x, widthOf))
        lines += (lines.empty() ? "" : "\n") + line;
    ImGui::TextUnformatted(lines.c_str());
}

std::string cutTo(const std::string& text, float width, float size) {
    constexpr const char* kEllipsis = "\u2026";
    const auto fits = [&](const std::string& words) {
        return ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, words.c_str()).x <= width;
    };
    if (fits(text)) return text;
    std::string cut = text;
    while (!cut.empty() && !fits(cut + kEllipsis)) {
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) // a letter in UTF-8 goes as a whole
            cut.pop_back();
        if (!cut.empty()) cut.pop_back();
    }
    while (!cut.empty() && cut.back() == ' ')
        cut.pop_back();
    return cut + kEllipsis;
}

std::string cutTo(const std::string& text, float width) { return cutTo(text, width, ImGui::GetFontSize()); }

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
