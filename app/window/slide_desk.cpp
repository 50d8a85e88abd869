// SPDX-License-Identifier: MIT
#include "app/window/slide_desk.h"

#include <algorithm>
#include <utility>

#include "app/course/slide_file.h"
#include "app/window/desk.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::window {

namespace {

/// The slide of that number, on show. Throws what reading it throws; then nothing has changed.
void show(Desk& desk, course::Deck& deck, std::size_t slide, bool atItsEnd) {
    SlideDesk& on = desk.slides;
    course::Slide read = deck.read(slide);
    on.stops = course::stopsOf(read);
    on.slide = std::move(read);
    on.at = slide;
    on.stop = atItsEnd && !on.stops.empty() ? on.stops.size() - 1 : 0;
}

void showStop(Desk& desk) {
    const SlideDesk& on = desk.slides;
    if (on.stops.empty()) return; // words alone: the picture before stays
    desk.selection = {};
    desk.shown.blink = false;
    desk.bench.showDocument(on.stops[on.stop].document);
}

/// The deck as it is now. Somebody may have made it shorter.
void replaceDeck(SlideDesk& on, const std::filesystem::path& file) {
    on.deck.emplace(file.string(), on.loading);
    on.at = std::min(on.at, on.deck->slides().size() - 1);
}

} // namespace

void openDeck(Desk& desk, const std::string& nameOrPath, const std::string& slide) {
    SlideDesk& on = desk.slides;
    try {
        course::Deck deck(nameOrPath, on.loading);
        const std::vector<std::string>& names = deck.slides();
        const auto found = slide.empty() ? names.begin() : std::ranges::find(names, slide);
        if (found == names.end())
            throw Error(ExitStatus::usage,
                        "deck '" + deck.name() + "' has no slide '" + slide + "'; " + suggestion(slide, names));
        leaveLesson(desk);
        show(desk, deck, static_cast<std::size_t>(found - names.begin()), false);
        if (!on.earlier) on.earlier = desk.bench.document();
        on.deck.emplace(std::move(deck));
    } catch (const Error& fault) {
        return complain(desk, fault.what());
    }
    showStop(desk);
}

void stepSlides(Desk& desk, int by) {
    SlideDesk& on = desk.slides;
    if (!on.deck) {
        if (!on.decks.empty()) openDeck(desk, on.decks.front());
        return;
    }
    if (by > 0 ? on.stop + 1 < on.stops.size() : on.stop > 0) {
        on.stop += by > 0 ? 1 : std::size_t(-1);
        return showStop(desk);
    }
    const std::size_t count = on.deck->slides().size();
    if (by > 0 ? on.at + 1 >= count : on.at == 0) {
        desk.requests.news = by > 0 ? "This was the last slide." : "This is the first slide.";
        return;
    }
    const std::size_t next = by > 0 ? on.at + 1 : on.at - 1;
    try {
        show(desk, *on.deck, next, by < 0);
    } catch (const Error& fault) { // the slides behind it can be shown all the same
        on.at = next;
        on.slide = course::Slide();
        on.slide.name = on.deck->slides()[next];
        on.slide.title = on.slide.name + " cannot be shown";
        on.stops.clear();
        on.stop = 0;
        return complain(desk, fault.what());
    }
    showStop(desk);
}

void leaveSlides(Desk& desk) {
    if (!desk.slides.isOn()) return;
    desk.slides.deck.reset();
    desk.slides.stops.clear();
    if (desk.slides.earlier) desk.bench.showDocument(*desk.slides.earlier);
    desk.slides.earlier.reset();
}

void saveAsSlide(Desk& desk) {
    try {
        const course::SavedSlide saved = course::saveSlide(desk.bench.document(), *desk.bench.shownScene(),
                                                             course::currentFolder(), desk.slides.loading);
        desk.requests.news = "saved as slide " + saved.name + " of " + saved.deck.string() +
                             (saved.sceneFile.empty() ? "" : ", with its scene " + saved.sceneFile.filename().string());
        // Whoever goes through that very deck finds the slide at its end.
        std::error_code ignored;
        if (desk.slides.deck && std::filesystem::equivalent(desk.slides.deck->file(), saved.deck, ignored))
            replaceDeck(desk.slides, saved.deck);
    } catch (const std::exception& fault) {
        complain(desk, fault.what());
    }
}

} // namespace shadowlab::window
