// SPDX-License-Identifier: MIT
#include "app/window/lesson_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/course/lessons/lesson_quantities.h"
#include "app/picture/labels.h"
#include "app/report/lesson_measure.h"
#include "app/window/window_state.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::window {

namespace {

using course::Lesson, course::Question;

constexpr double kShownFramesPerSecond = 15; ///< of the motion's frames, while the window plays it

/// What a step shows. Before a shadow is revealed, none of it is seen.
lab::Document documentOf(const Lesson& lesson, LessonStep step) {
    const std::size_t asked = lesson.question && step == LessonStep::question ? lesson.question->picture : 0;
    course::ShownState state = lesson.states[step == LessonStep::remedy ? 1 : asked];
    const bool isMark = lesson.question && lesson.question->kind == Question::Kind::mark;
    if (isMark && (step == LessonStep::question || step == LessonStep::reveal)) {
        state.slots = {{.technique = "unshadowed", .stage = {}, .settings = {}}};
        state.layout = picture::Layout::single;
    }
    return course::documentOf(state);
}

/// Does the step show one of the lesson's two states?
bool showsState(const LessonState& on) {
    return on.now && (on.step == LessonStep::artefact || on.step == LessonStep::remedy);
}

void reveal(WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    View view;
    view.camera = document.camera;
    view.size = course::kPredictionSize;
    ui.lesson.score = course::scorePrediction(ui.lesson.painted, ui.bench.session().truth(view, document.light));
}

void show(WindowState& ui, LessonStep step) {
    LessonState& on = ui.lesson;
    on.step = step;
    ui.innerSteps = {};
    ui.selection = {};
    ui.shown.blink = false;
    on.shown = documentOf(*on.now, step);
    ui.bench.showDocument(on.shown);
    const film::Motion& motion = on.now->motion;
    if (motion.frames > 1)
        ui.bench.setAnimation([&](lab::Animation& animation) {
            const double degrees = motion.orbitCameraDegrees.value_or(0) + motion.orbitLightDegrees.value_or(0);
            animation.lights = motion.orbitLightDegrees.has_value();
            animation.camera = motion.orbitCameraDegrees.has_value();
            animation.objects = false;
            animation.speed =
                std::clamp(std::abs(degrees) / motion.frames * kShownFramesPerSecond / lab::kTurnDegreesPerSecond,
                           lab::kSlowest, lab::kFastest);
        });
    if (step == LessonStep::question) {
        on.chosen.reset();
        on.painted.clear();
        on.score.reset();
    }
    if (step == LessonStep::reveal) reveal(ui);
}

} // namespace

bool LessonState::paints() const {
    return now && step == LessonStep::question && now->question->kind == Question::Kind::mark;
}
bool LessonState::asksChoice() const {
    return now && step == LessonStep::question && now->question->kind == Question::Kind::choice;
}

std::vector<LessonStep> stepsOf(const Lesson& lesson) {
    std::vector<LessonStep> steps;
    if (lesson.question) steps.push_back(LessonStep::question);
    if (lesson.question && lesson.question->kind == Question::Kind::mark) steps.push_back(LessonStep::reveal);
    steps.insert(steps.end(), {LessonStep::artefact, LessonStep::remedy});
    return steps;
}

void openLesson(WindowState& ui, const std::string& nameOrPath, bool atItsEnd) {
    try {
        Lesson lesson = course::loadLesson(nameOrPath, ui.lesson.loading);
        leaveSlides(ui);
        if (!ui.lesson.earlier) ui.lesson.earlier = ui.bench.document();
        ui.lesson.changes = course::changesOf(lesson);
        ui.lesson.now = std::move(lesson);
    } catch (const Error& fault) {
        complain(ui, fault.what());
        return;
    }
    const std::vector<LessonStep> steps = stepsOf(*ui.lesson.now);
    ui.lesson.chosen.reset();
    ui.lesson.painted.clear();
    ui.lesson.score.reset();
    ui.lesson.judged = {};
    ui.lesson.measured = {};
    show(ui, atItsEnd ? steps.back() : steps.front());
}

void stepLesson(WindowState& ui, int by) {
    LessonState& on = ui.lesson;
    if (on.now) {
        const std::vector<LessonStep> steps = stepsOf(*on.now);
        const auto at = std::ranges::find(steps, on.step) - steps.begin() + by;
        if (at >= 0 && at < std::ssize(steps)) return show(ui, steps[static_cast<std::size_t>(at)]);
    }
    if (on.all.empty()) return;
    const auto count = static_cast<int>(on.all.size());
    int next = by > 0 ? 0 : count - 1;
    if (on.now) {
        const auto found = std::ranges::find(on.all, on.now->text.file, &course::LessonText::file);
        if (found != on.all.end()) next = static_cast<int>(found - on.all.begin()) + by;
        if (next < 0 || next >= count) {
            ui.requests.news = by > 0 ? "This was the last lesson." : "This is the beginning of the first lesson.";
            return;
        }
    }
    openLesson(ui, on.all[static_cast<std::size_t>(next)].name, by < 0);
}

void leaveLesson(WindowState& ui) {
    if (!ui.lesson.isOn()) return;
    ui.lesson.now.reset();
    ui.innerSteps = {};
    if (ui.lesson.earlier) ui.bench.showDocument(*ui.lesson.earlier);
    ui.lesson.earlier.reset();
}

void keepJudged(WindowState& ui, const lab::LiveErrors& errors) {
    LessonState& on = ui.lesson;
    if (!showsState(on)) return;
    const std::size_t state = on.step == LessonStep::remedy ? 1 : 0;
    const auto slot = static_cast<std::size_t>(course::judgedSlot(*on.now));
    const lab::PaneState& meant = on.shown.panes[slot];
    const lab::PaneErrors* found = errors.errors(static_cast<int>(slot));
    // Of the very state that the lesson has: not after a setting, the camera or a light was changed.
    if (!found || !found->exact || found->judged.state.technique != meant.technique ||
        found->judged.state.values() != meant.values() || found->judged.view.camera != on.shown.camera ||
        found->judged.light != on.shown.light || found->judged.snapshot != on.shown.scene)
        return;
    on.judged[state] = {found->counts.wrong(), found->edgeErrorPx, found->judged.view.size};
}

bool isAboutEdges(const Lesson& lesson) { return course::quantityOf(lesson.expectations.front()).id == "edgeErrorPx"; }

bool isMeasuredApart(const Lesson& lesson) {
    const course::LessonQuantity& quantity = course::quantityOf(lesson.expectations.front());
    return quantity.of != course::LessonQuantity::Of::visibility || !(quantity.countsPixels() || isAboutEdges(lesson));
}

bool measureShownState(WindowState& ui) {
    LessonState& on = ui.lesson;
    if (!showsState(on) || !isMeasuredApart(*on.now)) return false;
    const std::size_t state = on.step == LessonStep::remedy ? 1 : 0;
    if (!on.measured[state].empty()) return false;
    try {
        on.measured[state] = picture::shortNumber(report::measureState(*on.now, state).front().value);
    } catch (const Error& fault) {
        on.measured[state] = "unknown";
        complain(ui, fault.what());
    }
    return true;
}

void answer(WindowState& ui, int choice) {
    if (ui.lesson.asksChoice() && choice < static_cast<int>(ui.lesson.now->question->choices.size()))
        ui.lesson.chosen = choice;
}

} // namespace shadowlab::window
