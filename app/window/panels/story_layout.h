// How much room the band below the pictures takes, and how its parts share it. Nothing is drawn here.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>
#include <vector>

#include "app/window/pane_frames.h"
#include "app/window/panels/story_page.h"
#include "app/window/story.h"

namespace shadowlab::window {

/// Where pictures, band and drawing are. An empty size: it is not there.
struct StoryLayout {
    Area room; ///< all of it
    Area pictures, band, figure;
    bool hasCompactHeader = false; ///< the picture beside a drawing is small
    float typeShare = 1;           ///< of the type's size, in which the band's text is set so that all of it is seen
};

/// Divides the room between the top bar and the strip. `legends`: lines of the legends on show.
StoryLayout layStory(const WindowState& ui, const Area& room, const LegendLines& legends, const Theme& theme);

// What the band is made of, measured in pixels. Within an ImGui frame.

/// A mode, to be chosen in the band.
struct StoryTab {
    StoryMode mode;
    const char *label, *help;
};
inline constexpr std::array<StoryTab, 4> kStoryTabs = {{
    {StoryMode::explore, "Explore", "nothing is told: the scene, the techniques and their settings (Esc)"},
    {StoryMode::steps, "Steps", "the algorithm step by step (N; PageDown, PageUp)"},
    {StoryMode::lesson, "Lessons", "an artefact and its remedy, chapter by chapter (J)"},
    {StoryMode::slides, "Slides", "the lectures' slides, live (S)"},
}};
/// Of all four, side by side.
float storyTabsWidth();
/// Of a button with that label.
float storyButtonWidth(const std::string& label);
/// "Esc: leave": where leaving leads.
std::string leaveLabel(const WindowState& ui);

/// The page on show, which is the last, and before it those that the band keeps room for, so that the pictures do not jump from one
/// to the next.
std::vector<StoryPage> pagesOfBand(const WindowState& ui);

/// How the band is divided at a width.
struct BandShape {
    float controls = 0;   ///< width of arrows and place
    bool hasShortPlace = false;
    bool hasTabs = true;  ///< in the first row; else they are a row of their own before it
    bool hasTitle = true; ///< in the first row; else it is wrapped below
    bool hasLeave = true;
    bool hasColumns = false; ///< pseudocode stands beside the text, and not below it
    float textShare = 1;     ///< of the width, that the text then has
};
/// `typeShare`: of the type's size, in which the text below the first row is set.
BandShape bandShape(const WindowState& ui, const std::vector<StoryPage>& pages, float width, float typeShare, const Theme& theme);
/// Pixels of a page's title in one line.
float titleWidth(const StoryPage& page, const Theme& theme);
/// Between lines of pseudocode: they belong together.
float codeGap(const Theme& theme);

} // namespace shadowlab::window
