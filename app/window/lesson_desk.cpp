// SPDX-License-Identifier: MIT
#include "app/window/lesson_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/desk.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::window {

namespace {

using course::Lesson, course::Question;

constexpr double kShownFramesPerSecond = 15; ///< of the motion's frames, while the window plays it

/// What a step shows. Before a shadow is revealed, none of it is seen.
lab::Document documentOf(const Lesson& lesson, LessonStep step) {
    const std::size_t asked = lesson.question && step == LessonStep::question ? lesson.question->picture : 0;
    course::ShownState state = lesson.states[step == LessonStep::mend ? 1 : asked];
    const bool isMark = lesson.question && lesson.question->kind == Question::Kind::mark;
    if (isMark && (step == LessonStep::question || step == LessonStep::reveal)) {
        state.slots = {{.technique = "unshadowed", .stage = {}, .settings = {}}};
        state.layout = picture::Layout::single;
    }
    return course::documentOf(state);
}

void reveal(Desk& desk) {
    const lab::Document& document = desk.bench.document();
    View view;
    view.camera = document.camera;
    view.size = course::kPredictionSize;
    desk.lesson.score = course::scorePrediction(desk.lesson.painted, desk.bench.session().truth(view, document.light));
}

void show(Desk& desk, LessonStep step) {
    LessonDesk& on = desk.lesson;
    on.step = step;
    desk.selection = {};
    desk.shown.blink = false;
    desk.bench.showDocument(documentOf(*on.now, step));
    const film::Motion& motion = on.now->motion;
    if (motion.frames > 1)
        desk.bench.setAnimation([&](lab::Animation& animation) {
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
    if (step == LessonStep::reveal) reveal(desk);
}

} // namespace

bool LessonDesk::paints() const {
    return now && step == LessonStep::question && now->question->kind == Question::Kind::mark;
}
bool LessonDesk::asksChoice() const {
    return now && step == LessonStep::question && now->question->kind == Question::Kind::choice;
}

std::vector<LessonStep> stepsOf(const Lesson& lesson) {
    std::vector<LessonStep> steps;
    if (lesson.question) steps.push_back(LessonStep::question);
    if (lesson.question && lesson.question->kind == Question::Kind::mark) steps.push_back(LessonStep::reveal);
    steps.insert(steps.end(), {LessonStep::artefact, LessonStep::mend});
    return steps;
}

void openLesson(Desk& desk, const std::string& nameOrPath, bool atItsEnd) {
    try {
        Lesson lesson = course::loadLesson(nameOrPath, desk.lesson.loading);
        leaveSlides(desk);
        if (!desk.lesson.earlier) desk.lesson.earlier = desk.bench.document();
        desk.lesson.now = std::move(lesson);
    } catch (const Error& fault) {
        complain(desk, fault.what());
        return;
    }
    const std::vector<LessonStep> steps = stepsOf(*desk.lesson.now);
    desk.lesson.chosen.reset();
    desk.lesson.painted.clear();
    desk.lesson.score.reset();
    show(desk, atItsEnd ? steps.back() : steps.front());
}

void stepLesson(Desk& desk, int by) {
    LessonDesk& on = desk.lesson;
    if (on.now) {
        const std::vector<LessonStep> steps = stepsOf(*on.now);
        const auto at = std::ranges::find(steps, on.step) - steps.begin() + by;
        if (at >= 0 && at < std::ssize(steps)) return show(desk, steps[static_cast<std::size_t>(at)]);
    }
    if (on.all.empty()) return;
    const auto count = static_cast<int>(on.all.size());
    int next = by > 0 ? 0 : count - 1;
    if (on.now) {
        const auto found = std::ranges::find(on.all, on.now->text.file, &course::LessonText::file);
        if (found != on.all.end()) next = (static_cast<int>(found - on.all.begin()) + by + count) % count;
    }
    openLesson(desk, on.all[static_cast<std::size_t>(next)].name, by < 0);
}

void leaveLesson(Desk& desk) {
    if (!desk.lesson.isOn()) return;
    desk.lesson.now.reset();
    if (desk.lesson.earlier) desk.bench.showDocument(*desk.lesson.earlier);
    desk.lesson.earlier.reset();
}

void answer(Desk& desk, int choice) {
    if (desk.lesson.asksChoice() && choice < static_cast<int>(desk.lesson.now->question->choices.size()))
        desk.lesson.chosen = choice;
}

} // namespace shadowlab::window
