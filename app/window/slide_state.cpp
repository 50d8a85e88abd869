// SPDX-License-Identifier: MIT
#include "app/window/slide_state.h"

#include <algorithm>
#include <utility>

#include "app/course/slide_file.h"
#include "app/window/window_state.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::window {

namespace {

/// The slide of that number, on show. Throws what reading it throws; then nothing has changed.
void show(WindowState& ui, course::Deck& deck, std::size_t slide, bool atItsEnd) {
    SlideState& on = ui.slides;
    course::Slide read = deck.read(slide);
    on.stops = course::stopsOf(read);
    on.slide = std::move(read);
    on.at = slide;
    on.stop = atItsEnd && !on.stops.empty() ? on.stops.size() - 1 : 0;
}

void showStop(WindowState& ui) {
    const SlideState& on = ui.slides;
    ui.innerSteps = {};
    if (on.stops.empty()) return; // words alone: the picture before stays
    ui.selection = {};
    ui.shown.blink = false;
    ui.bench.showDocument(on.stops[on.stop].document);
}

/// Reads the deck again. It may have become shorter in the meantime.
void replaceDeck(SlideState& on, const std::filesystem::path& file) {
    on.deck.emplace(file.string(), on.loading);
    on.at = std::min(on.at, on.deck->slides().size() - 1);
}

} // namespace

void openDeck(WindowState& ui, const std::string& nameOrPath, const std::string& slide) {
    SlideState& on = ui.slides;
    try {
        course::Deck deck(nameOrPath, on.loading);
        const std::vector<std::string>& names = deck.slides();
        const auto found = slide.empty() ? names.begin() : std::ranges::find(names, slide);
        if (found == names.end())
            throw Error(ExitStatus::usage,
                        "deck '" + deck.name() + "' has no slide '" + slide + "'; " + suggestion(slide, names));
        leaveLesson(ui);
        show(ui, deck, static_cast<std::size_t>(found - names.begin()), false);
        if (!on.earlier) on.earlier = ui.bench.document();
        on.deck.emplace(std::move(deck));
    } catch (const Error& fault) {
        return complain(ui, fault.what());
    }
    showStop(ui);
}

void stepSlides(WindowState& ui, int by) {
    SlideState& on = ui.slides;
    if (!on.deck) {
        if (!on.leftDeck.empty()) return openDeck(ui, on.leftDeck, on.leftSlide);
        if (!on.decks.empty()) openDeck(ui, on.decks.front());
        return;
    }
    if (by > 0 ? on.stop + 1 < on.stops.size() : on.stop > 0) {
        on.stop += by > 0 ? 1 : std::size_t(-1);
        return showStop(ui);
    }
    const std::size_t count = on.deck->slides().size();
    if (by > 0 ? on.at + 1 >= count : on.at == 0) {
        ui.requests.news = by > 0 ? "This was the last slide." : "This is the first slide.";
        return;
    }
    const std::size_t next = by > 0 ? on.at + 1 : on.at - 1;
    try {
        show(ui, *on.deck, next, by < 0);
    } catch (const Error& fault) { // the slides behind it can be shown all the same
        on.at = next;
        on.slide = course::Slide();
        on.slide.name = on.deck->slides()[next];
        on.slide.title = on.slide.name + " cannot be shown";
        on.stops.clear();
        on.stop = 0;
        return complain(ui, fault.what());
    }
    showStop(ui);
}

void leaveSlides(WindowState& ui) {
    if (!ui.slides.isOn()) return;
    ui.slides.leftDeck = ui.slides.deck->file().string();
    ui.slides.leftSlide = ui.slides.slide.name;
    ui.slides.deck.reset();
    ui.slides.stops.clear();
    ui.innerSteps = {};
    if (ui.slides.earlier) ui.bench.showDocument(*ui.slides.earlier);
    ui.slides.earlier.reset();
}

void saveAsSlide(WindowState& ui) {
    try {
        const course::SavedSlide saved = course::saveSlide(ui.bench.document(), *ui.bench.shownScene(),
                                                             course::currentFolder(), ui.slides.loading);
        ui.requests.news = "saved as slide " + saved.name + " of " + saved.deck.string() +
                             (saved.sceneFile.empty() ? "" : ", with its scene " + saved.sceneFile.filename().string());
        // If that deck is the one on show, its new slide can be reached at once.
        std::error_code ignored;
        if (ui.slides.deck && std::filesystem::equivalent(ui.slides.deck->file(), saved.deck, ignored))
            replaceDeck(ui.slides, saved.deck);
    } catch (const std::exception& fault) {
        complain(ui, fault.what());
    }
}

} // namespace shadowlab::window
