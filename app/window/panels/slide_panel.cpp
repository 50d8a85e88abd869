// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/drawing/formula.h"
#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

constexpr const char* kSlideHint = "S: on   Shift+S: back   Esc: out";

/// "7 of 17", and which picture, where there are more.
std::string placeInDeck(const SlideState& on) {
    std::string text = std::to_string(on.at + 1) + " of " + std::to_string(on.deck->slides().size());
    if (on.stops.size() > 1)
        text += ", picture " + std::to_string(on.stop + 1) + " of " + std::to_string(on.stops.size());
    return text;
}

/// The lines below the title.
std::vector<std::string> slideLines(const SlideState& on) {
    std::vector<std::string> lines;
    if (!on.stops.empty()) {
        const course::SlideStop& stop = on.stops[on.stop];
        if (!stop.label.empty()) lines.push_back(stop.label);
        if (!stop.figure.empty())
            lines.push_back("On the slide: the drawing '" + stop.figure + "' of the pixel that is marked.");
    }
    if (on.stops.empty()) lines.insert(lines.end(), on.slide.text.begin(), on.slide.text.end());
    for (const std::string& tex : on.slide.formulas)
        lines.push_back(drawing::Formula(tex).spoken());
    if (!on.slide.caption.empty()) lines.push_back(on.slide.caption);
    return lines;
}

} // namespace

float slidePanelHeight(const WindowState& ui, const Theme& theme, float width) {
    if (!ui.slides.isOn()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = std::max(theme.em, width - 2 * style.WindowPadding.x);
    float height = std::max(ImGui::GetFrameHeight(), theme.headingSize);
    for (const std::string& line : slideLines(ui.slides))
        height += wrappedHeight(theme.text, theme.em, line, room) + style.ItemSpacing.y;
    return std::ceil(height + 2 * style.WindowPadding.y + 2 * style.ItemSpacing.y);
}

void slidePanel(WindowState& ui, const Area& area, const Theme& theme) {
    const SlideState& on = ui.slides;
    const int by = beginBand({"slide", on.slide.title, placeInDeck(on), kSlideHint}, area, theme);
    for (const std::string& line : slideLines(on))
        ImGui::TextWrapped("%s", line.c_str());
    ImGui::End();
    if (by != 0) stepSlides(ui, by);
}

void deckList(WindowState& ui) {
    if (ui.slides.decks.empty() || !ImGui::CollapsingHeader("Slides")) return;
    const SlideState& on = ui.slides;
    const std::string open = on.deck ? on.deck->name() : "";
    std::string chosenDeck, chosenSlide;
    std::vector<std::string> decks = on.decks;
    if (on.deck && std::ranges::find(decks, open) == decks.end()) decks.push_back(on.deck->file().string());
    for (const std::string& deck : decks) {
        const bool isOpen = on.deck && (deck == open || deck == on.deck->file().string());
        if (ImGui::Selectable(deck.c_str(), isOpen)) chosenDeck = deck;
        if (!isOpen) continue;
        ImGui::Indent();
        const std::vector<std::string>& names = on.deck->slides();
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable((std::to_string(i + 1) + "  " + names[i]).c_str(), i == on.at)) {
                chosenDeck = deck;
                chosenSlide = names[i];
            }
        ImGui::Unindent();
    }
    if (!chosenDeck.empty()) openDeck(ui, chosenDeck, chosenSlide);
}

} // namespace shadowlab::window
