// SPDX-License-Identifier: MIT
#include "app/window/theme.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::window {

namespace {

/// Latin with what formulas and units of this program use.
constexpr ImWchar kLetters[] = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2010, 0x2026, 0x2032, 0x2033, // primes
                                0x2070, 0x208E, 0x2190, 0x2193, 0x2202, 0x222C, 0x2248, 0x2248, // raised numbers; about
                                0x2260, 0x2265, 0x22EE, 0x22F1, 0x25A0, 0x25CF, 0};

void setColors(bool presenter) {
    ImGui::StyleColorsDark();
    ImVec4* const colors = ImGui::GetStyle().Colors;
    const auto grey = [](float value, float alpha = 1) { return ImVec4(value, value, value * 1.04f, alpha); };
    const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
    colors[ImGuiCol_WindowBg] = grey(presenter ? 0.03f : 0.09f);
    colors[ImGuiCol_PopupBg] = grey(presenter ? 0.03f : 0.07f, 0.98f);
    colors[ImGuiCol_Text] = grey(presenter ? 1.0f : 0.92f);
    colors[ImGuiCol_TextDisabled] = grey(presenter ? 0.75f : 0.62f);
    colors[ImGuiCol_Border] = grey(presenter ? 0.45f : 0.26f);
    colors[ImGuiCol_FrameBg] = grey(0.18f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.26f);
    colors[ImGuiCol_FrameBgActive] = grey(0.30f);
    colors[ImGuiCol_Button] = grey(0.20f);
    colors[ImGuiCol_ButtonHovered] = grey(0.30f);
    colors[ImGuiCol_ButtonActive] = grey(0.38f);
    colors[ImGuiCol_Header] = grey(0.24f);
    colors[ImGuiCol_HeaderHovered] = grey(0.30f);
    colors[ImGuiCol_HeaderActive] = grey(0.36f);
    colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_NavHighlight] = accent;
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_Tab] = grey(0.14f);
    colors[ImGuiCol_TabHovered] = grey(0.30f);
    colors[ImGuiCol_TabActive] = grey(0.26f);
    colors[ImGuiCol_PlotLines] = accent;
}

} // namespace

float typeSize(ivec2 windowPixels, float contentScale, bool presenter) {
    const auto height = static_cast<float>(windowPixels.y), width = static_cast<float>(windowPixels.x);
    // On a screen: the usual 15 pixels at 96 dots an inch, more on one that is large but says it is not fine.
    const float onDesk = std::max(15 * contentScale, std::min(height / 60, width / 100));
    const float inHall = std::max(onDesk * 1.35f, height / 32);
    const float largest = std::max(10.0f, std::min(height / 18, width / 28)); // small windows keep room for pictures
    return std::round(std::min(presenter ? inHall : onDesk, largest));
}

Theme applyTheme(float em, bool presenter, const std::filesystem::path& fontFile) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    Theme theme;
    theme.em = em;
    theme.presenter = presenter;
    const auto load = [&](const std::filesystem::path& file, float size) {
        if (!std::filesystem::exists(file))
            throw Error(ExitStatus::badInput, file.string() + ": the font is missing; restore the assets folder");
        ImFontConfig config;
        config.OversampleH = 3; // said, because each version of ImGui thinks otherwise: letters look the same with all
        config.OversampleV = 1;
        ImFont* const font = io.Fonts->AddFontFromFileTTF(file.string().c_str(), size, &config, kLetters);
        if (!font)
            throw Error(ExitStatus::badInput,
                        file.string() + ": is no font that can be read; restore the assets folder");
        return font;
    };
    theme.headingSize = std::round(em * 1.25f);
    // Its letters look larger than those of the text, and lines of source are long.
    theme.codeSize = std::round(em * 0.88f);
    theme.text = load(fontFile, em);
    theme.heading = load(fontFile, theme.headingSize);
    theme.code = load(fontFile.parent_path() / "DejaVuSansMono.ttf", theme.codeSize);
    io.FontDefault = theme.text;
    theme.faces = std::make_shared<Faces>(fontFile.parent_path());

    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.ScaleAllSizes(em / 13); // ImGui's own distances are made for type of 13 pixels
    style.WindowRounding = style.PopupRounding = 0;
    style.FrameRounding = style.GrabRounding = std::round(em * 0.2f);
    style.ScrollbarSize = std::round(em * 0.9f);
    style.GrabMinSize = em;
    style.WindowBorderSize = 1;
    style.WindowMinSize = {1, 1}; // every panel knows its place; the bar is lower than ImGui thinks a window can be
    setColors(presenter);
    return theme;
}

Theme withType(Theme theme, float share) {
    theme.em *= share;
    theme.headingSize *= share;
    theme.codeSize *= share;
    return theme;
}

ImU32 shownColor(const vec3& linear, float alpha) {
    return IM_COL32(image::srgbFromLinear(linear.r), image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b),
                    static_cast<int>(std::lround(255 * alpha)));
}

} // namespace shadowlab::window
