// The deck that the window shows: which slide, which of its pictures, and what was shown before it.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/course/slide_stops.h"

namespace shadowlab::window {

struct WindowState;

struct SlideState {
    std::vector<std::string> decks; ///< built-in ones
    scene::LoadOptions loading;
    std::optional<course::Deck> deck;        ///< none: no deck is on
    std::size_t at = 0;                       ///< the slide
    course::Slide slide;                     ///< that slide
    std::vector<course::SlideStop> stops;    ///< its pictures; none: words alone
    std::size_t stop = 0;                     ///< the one on show
    std::optional<lab::Document> earlier; ///< what was shown before the deck was opened
    std::string leftDeck, leftSlide;      ///< what was on when a deck was last closed; empty: none was

    [[nodiscard]] bool isOn() const { return deck.has_value(); }
};

/// Opens a deck, a built-in name or a file, at the slide of that name; empty: the first. What cannot be read
/// only leads to a message.
void openDeck(WindowState& ui, const std::string& nameOrPath, const std::string& slide = {});
/// One picture on (1) or back (-1), into the next or the last slide where this one ends. Without a deck: opens the one that was closed last, at its slide,
/// else the first.
void stepSlides(WindowState& ui, int by);
/// Closes the deck and restores what was shown before it.
void leaveSlides(WindowState& ui);
/// Adds what is on show to the deck of the current folder (course/slide_file.h), and says so.
void saveAsSlide(WindowState& ui);

} // namespace shadowlab::window
