// What one page of the band below the pictures says: a step, a part of a lesson, a slide. The band lays all of them out alike.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/window/theme.h"
#include "app/window/window_state.h"

namespace shadowlab::window {

struct StoryLine {
    enum class Kind {
        text,
        quiet,  ///< what may be left unread: GL state, how to paint
        accent, ///< the setting that was changed, and counts
        large,  ///< a score
        choice, ///< of a question, to be clicked
        key,    ///< a colour and what it means
    };
    Kind kind = Kind::text;
    std::string text;
    std::string written{}; ///< the same with formulas between $; empty: it has none
    ImU32 color = 0;      ///< of a key
    bool isChosen = false; ///< of a choice
};

struct CodeLine {
    std::string text;
    bool isMarked = false;
};

struct StoryPage {
    std::string title;
    std::string writtenTitle{}; ///< the same with formulas between $; empty: it has none
    std::string place{}; ///< "Step 3 of 5": how far one has come
    std::string shortPlace{}; ///< where that has no room; empty: there is no shorter one
    std::vector<StoryLine> lines{};
    std::vector<CodeLine> code{}; ///< pseudocode, at the right
};

/// The page of the algorithm's step on show.
StoryPage stepPage(const WindowState& ui);
/// Those of all steps that the technique has: the band keeps room for the longest.
std::vector<StoryPage> stepPages(const WindowState& ui);
StoryPage lessonPage(const WindowState& ui);
std::vector<StoryPage> lessonPages(const WindowState& ui);
StoryPage slidePage(const WindowState& ui);

// Lists to choose from, in a menu.
/// All lessons of the course, chapter by chapter.
void lessonChoices(WindowState& ui);
/// All built-in decks, to be opened; of the open one, its slides.
void deckChoices(WindowState& ui);

} // namespace shadowlab::window
