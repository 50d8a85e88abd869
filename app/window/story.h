// What the band below the pictures tells: nothing (the class explores), the algorithm's steps, a lesson, or slides. One mode is on
// at a time, and one pair of keys goes through whichever it is. Steps may be taken within a lesson or a slide; leaving them leads
// back to it.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/picture/stage_ref.h"

namespace shadowlab::window {

struct WindowState;

enum class StoryMode { explore, steps, lesson, slides };

/// Steps that were begun within a lesson or a slide.
struct InnerSteps {
    bool on = false;
    std::string technique;      ///< of the active pane when they were begun
    picture::StageRef stage;    ///< what that pane showed then
};

/// Whether the active pane shows a step.
bool isStepping(const WindowState& ui);

/// The mode that the band shows and that the keys go through.
StoryMode storyMode(const WindowState& ui);
/// Where leaving that mode leads: a lesson or slides that the steps were begun in, else `explore`.
StoryMode outerMode(const WindowState& ui);

/// The next (1) or the one before (-1): of the slides' pictures, of the lesson's steps, else of the algorithm's steps.
void goThroughStory(WindowState& ui, int by);
/// The algorithm's next step, or the one before, in any mode. Within a lesson or a slide the band then tells of the step.
void goThroughSteps(WindowState& ui, int by);
/// Leaves the mode, one level: steps within a slide lead back to what the slide shows. False where nothing is on.
bool leaveStory(WindowState& ui);
/// Leaves all of them: nothing is told.
void explore(WindowState& ui);

} // namespace shadowlab::window
