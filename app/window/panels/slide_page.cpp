// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/drawing/formula.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/story_page.h"

namespace shadowlab::window {

namespace {

/// "7 of 17", and which picture, where there are more.
std::string placeInDeck(const SlideState& on) {
    std::string text = std::to_string(on.at + 1) + " of " + std::to_string(on.deck->slides().size());
    if (on.stops.size() > 1)
        text += ", picture " + std::to_string(on.stop + 1) + " of " + std::to_string(on.stops.size());
    return text;
}

std::string ifFormula(const std::string& written) { return written.find('$') == std::string::npos ? "" : written; }

/// Set as a formula where it has one.
StoryLine lineOf(StoryLine::Kind kind, const std::string& plain, const std::string& written) {
    return {.kind = kind, .text = plain, .written = ifFormula(written)};
}

} // namespace

StoryPage slidePage(const WindowState& ui) {
    const SlideState& on = ui.slides;
    StoryPage page{.title = on.slide.title, .writtenTitle = ifFormula(on.slide.written.title), .place = "Slide " + placeInDeck(on), .shortPlace = placeInDeck(on)};
    if (!on.stops.empty()) {
        // A slide without pictures is shown whole, with its text and its formulas, in their place.
        const course::SlideStop& stop = on.stops[on.stop];
        if (!stop.label.empty()) page.lines.push_back(lineOf(StoryLine::Kind::accent, stop.label, stop.writtenLabel));
        for (std::size_t i = 0; i < on.slide.text.size(); ++i)
            page.lines.push_back(lineOf(StoryLine::Kind::text, on.slide.text[i], on.slide.written.text[i]));
        for (const std::string& tex : on.slide.formulas)
            page.lines.push_back({.text = drawing::Formula(tex).spoken(), .written = "$" + tex + "$"});
        for (std::size_t i = 0; i < on.slide.pseudocode.size(); ++i)
            page.code.push_back({on.slide.pseudocode[i],
                                 std::ranges::find(on.slide.marked, static_cast<int>(i) + 1) != on.slide.marked.end()});
    }
    if (!on.slide.caption.empty()) page.lines.push_back(lineOf(StoryLine::Kind::text, on.slide.caption, on.slide.written.caption));
    return page;
}

void deckChoices(WindowState& ui) {
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
