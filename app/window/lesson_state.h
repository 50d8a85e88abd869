// The lesson that the window shows: which one, at which step, and what was shown before it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "app/course/lessons/prediction.h"
#include "app/lab/errors/live_errors.h"

namespace shadowlab::window {

struct WindowState;

/// The steps of a lesson. `question` only where it asks one, `reveal` only where a shadow was painted.
enum class LessonStep { question, reveal, artefact, remedy };

struct LessonState {
    std::vector<course::LessonText> all; ///< the course
    scene::LoadOptions loading;
    std::optional<course::Lesson> now; ///< none: no lesson is on
    LessonStep step = LessonStep::artefact;
    std::optional<lab::Document> earlier; ///< what was shown before the lessons began
    std::optional<int> chosen;                ///< of a question's choices
    course::Prediction painted;
    std::optional<course::PredictionScore> score;
    std::vector<course::LessonChange> changes; ///< what its remedy changes
    lab::Document shown;                       ///< by the step on show, before anything was changed by hand
    /// What the window's judge found of the artefact and of the remedy, in a picture of that size: in another one it is another number.
    struct Judged {
        int wrong = 0;                     ///< pixels
        std::optional<double> edgeErrorPx; ///< none: no shadow ends in the picture
        ivec2 pictureSize{0};
    };
    std::array<std::optional<Judged>, 2> judged{};
    std::array<std::string, 2> measured{};     ///< of a lesson about something else: that of its states; empty before it is known

    [[nodiscard]] bool isOn() const { return now.has_value(); }
    /// Does the mouse paint where the shadow will be?
    [[nodiscard]] bool paints() const;
    [[nodiscard]] bool asksChoice() const;
};

/// The steps of a lesson, in order.
std::vector<LessonStep> stepsOf(const course::Lesson& lesson);

/// Begins a lesson: a built-in name or a file. One that cannot be loaded only leads to a message.
void openLesson(WindowState& ui, const std::string& nameOrPath, bool atItsEnd = false);
/// One step on (1) or back (-1), into the next or the last lesson where this one ends. Without a lesson: the first, or the last.
void stepLesson(WindowState& ui, int by);
/// Ends the lesson and restores what was shown before it.
void leaveLesson(WindowState& ui);
/// Keeps what the judge has found of the state on show, once it is exact.
void keepJudged(WindowState& ui, const lab::LiveErrors& errors);
/// Is the lesson about the edge error, which the window's judge finds?
bool isAboutEdges(const course::Lesson& lesson);
/// Is the lesson about a number that is measured in pictures of its own, not about one that the window's judge finds?
bool isMeasuredApart(const course::Lesson& lesson);
/// Measures that number for the state on show, in pictures of the lesson's size: 0.4 s at most on two cores. True if there was
/// something to measure. For when all is drawn. Needs a current GL context.
bool measureShownState(WindowState& ui);
/// An answer to the question that is asked; counted from 0.
void answer(WindowState& ui, int choice);

} // namespace shadowlab::window
