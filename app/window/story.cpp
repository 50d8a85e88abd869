// SPDX-License-Identifier: MIT
#include "app/window/story.h"

#include <utility>

#include "app/window/window_state.h"

namespace shadowlab::window {

namespace {

/// What the lesson or the slide showed before the steps; where they were begun in no such thing, the finished picture.
void leaveSteps(WindowState& ui) {
    const InnerSteps inner = std::exchange(ui.innerSteps, {});
    chooseStage(ui, inner.on && inner.technique == ui.bench.activeState().technique ? inner.stage : picture::StageRef());
}

} // namespace

bool isStepping(const WindowState& ui) { return ui.bench.activeState().stage.isPass; }

StoryMode outerMode(const WindowState& ui) {
    if (!ui.innerSteps.on || !isStepping(ui)) return StoryMode::explore;
    return ui.lesson.isOn() ? StoryMode::lesson : ui.slides.isOn() ? StoryMode::slides : StoryMode::explore;
}

StoryMode storyMode(const WindowState& ui) {
    const bool withinSteps = ui.innerSteps.on && isStepping(ui);
    if (!withinSteps && ui.lesson.isOn()) return StoryMode::lesson;
    if (!withinSteps && ui.slides.isOn()) return StoryMode::slides; // a slide may show a step itself
    return isStepping(ui) ? StoryMode::steps : StoryMode::explore;
}

void goThroughStory(WindowState& ui, int by) {
    switch (storyMode(ui)) {
    case StoryMode::lesson: return stepLesson(ui, by);
    case StoryMode::slides: return stepSlides(ui, by);
    case StoryMode::steps:
    case StoryMode::explore: return goThroughSteps(ui, by);
    }
}

void goThroughSteps(WindowState& ui, int by) {
    if (storyMode(ui) == StoryMode::lesson || storyMode(ui) == StoryMode::slides) {
        const lab::PaneState& state = ui.bench.activeState();
        ui.innerSteps = {true, state.technique, state.stage};
    }
    step(ui, by);
    if (ui.innerSteps.on && !isStepping(ui)) leaveSteps(ui); // beyond the last step, or before the first
}

bool leaveStory(WindowState& ui) {
    switch (storyMode(ui)) {
    case StoryMode::lesson: leaveLesson(ui); return true;
    case StoryMode::slides: leaveSlides(ui); return true;
    case StoryMode::steps: leaveSteps(ui); return true;
    case StoryMode::explore: return false;
    }
    return false;
}

void explore(WindowState& ui) {
    while (leaveStory(ui)) {}
}

} // namespace shadowlab::window
