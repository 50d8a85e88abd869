// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/course/lessons/lesson_figure.h"
#include "app/course/lessons/lesson_quantities.h"
#include "app/picture/verdict_reasons.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/story_page.h"

namespace shadowlab::window {

namespace {

using course::Question;
using Kind = StoryLine::Kind;

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// "1 of 2: the artefact"; before that, what is to be done.
std::string stepTitle(const LessonState& on, LessonStep step) {
    switch (step) {
    case LessonStep::question:
        return on.now->question->kind == Question::Kind::mark ? "Predict: paint the shadow" : "A question";
    case LessonStep::reveal: return "The truth";
    case LessonStep::artefact: return course::stateTitle(0);
    case LessonStep::remedy: return course::stateTitle(1);
    }
    return {};
}

/// What was answered, and what is right: said with the artefact.
std::string verdictOnChoice(const LessonState& on) {
    const Question& question = *on.now->question;
    const std::string& right = question.choices[static_cast<std::size_t>(question.right)];
    if (!on.chosen) return "The answer: " + right + ".";
    return (*on.chosen == question.right ? "Right: " : "Not so. It is: ") + right + ".";
}

std::string scoreLine(const LessonState& on) {
    if (on.painted.isEmpty()) return "Nothing was painted.";
    if (!on.score) return {};
    return percent(on.score->shadowFound()) + " of the shadow found, " + percent(on.score->paintedRight()) +
           " of the paint in it";
}

/// The settings that make the artefact; with the remedy, what became of each.
std::string changesLine(const LessonState& on, bool isRemedy) {
    std::string line;
    for (const course::LessonChange& change : on.changes) {
        line += (line.empty() ? "" : ",   ") + change.name;
        line += isRemedy ? ": " + change.before + " → " + change.after : " = " + change.before;
    }
    return line.empty() ? line : (isRemedy ? "Changed:  " : "Setting:  ") + line;
}

/// What a lesson is about that does not count wrong pixels: "Spread of levels (of 255):  12.1 → 0".
std::string measuredLine(const LessonState& on, bool isRemedy) {
    const course::Expectation& expected = on.now->expectations.front();
    const course::LessonQuantity& quantity = course::quantityOf(expected);
    std::string name = expected.fact.empty() ? std::string(quantity.name) : expected.fact;
    if (!expected.fact.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    if (expected.reference) name += ", " + std::string(findTechnique(expected.reference->technique).title);
    if (expected.look) name += ", in the frame";
    if (!quantity.unit.empty() && !quantity.countsPixels()) name += " (" + std::string(quantity.unit) + ")";
    const std::array<std::string, 2>& found = on.measured;
    const std::string now = found[isRemedy ? 1 : 0].empty() ? "being measured" : found[isRemedy ? 1 : 0];
    return name + ":  " + (isRemedy && !found[0].empty() ? found[0] + " → " : std::string()) + now;
}

/// How many pixels are wrong, or how far edges are from where they belong: the numbers of the pane's header. That of the artefact stands
/// beside the remedy's only where both pictures have one size.
std::string countsLine(const LessonState& on, bool isRemedy) {
    if (isMeasuredApart(*on.now)) return measuredLine(on, isRemedy);
    const bool isEdge = isAboutEdges(*on.now);
    const auto value = [&](const LessonState::Judged& judged) {
        return !isEdge ? std::to_string(judged.wrong) : judged.edgeErrorPx ? picture::fixed(*judged.edgeErrorPx, 2) : "none";
    };
    const std::string name = isEdge ? "Edge error (px):  " : "Wrong pixels:  ";
    const auto& now = on.judged[isRemedy ? 1 : 0];
    if (!now) return name + (isEdge ? "being found" : "being counted");
    const bool hasBoth = isRemedy && on.judged[0] && on.judged[0]->pictureSize == now->pictureSize;
    return name + (hasBoth ? value(*on.judged[0]) + " → " : std::string()) + value(*now);
}

StoryPage pageOf(const LessonState& on, LessonStep step) {
    const course::Lesson& lesson = *on.now;
    StoryPage page{.title = lesson.text.title, .place = stepTitle(on, step), .lines = {}, .code = {}};
    std::vector<StoryLine>& lines = page.lines;
    if (step == LessonStep::question) {
        lines.push_back({.text = lesson.question->text});
        for (std::size_t i = 0; i < lesson.question->choices.size(); ++i)
            lines.push_back({.kind = Kind::choice,
                             .text = std::to_string(i + 1) + "  " + lesson.question->choices[i],
                             .isChosen = on.chosen == static_cast<int>(i)});
        if (lesson.question->kind == Question::Kind::mark)
            lines.push_back({.kind = Kind::quiet, .text = "Left button: paint.  Right button: wipe.  PageDown: the truth."});
    } else if (step == LessonStep::reveal) {
        lines.push_back({.kind = Kind::large, .text = scoreLine(on)});
        lines.push_back({.kind = Kind::key, .text = "right", .color = kPredictedRight});
        lines.push_back({.kind = Kind::key, .text = "shadow that was missed", .color = kPredictedMissed});
        lines.push_back({.kind = Kind::key, .text = "painted, but lit", .color = kPredictedWrong});
    } else {
        const bool isRemedy = step == LessonStep::remedy;
        if (!isRemedy && lesson.question && lesson.question->kind == Question::Kind::choice)
            lines.push_back({.text = verdictOnChoice(on)});
        lines.push_back({.text = course::sentenceOf(lesson, isRemedy ? 1 : 0)});
        if (const std::string changes = changesLine(on, isRemedy); !changes.empty())
            lines.push_back({.kind = Kind::accent, .text = changes});
        lines.push_back({.kind = Kind::accent, .text = countsLine(on, isRemedy)});
    }
    return page;
}

} // namespace

StoryPage lessonPage(const WindowState& ui) { return pageOf(ui.lesson, ui.lesson.step); }

std::vector<StoryPage> lessonPages(const WindowState& ui) {
    std::vector<StoryPage> pages;
    for (const LessonStep step : stepsOf(*ui.lesson.now))
        pages.push_back(pageOf(ui.lesson, step));
    return pages;
}

void lessonChoices(WindowState& ui) {
    for (const std::string& chapter : course::chaptersOf(ui.lesson.all)) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", chapter.c_str());
        ImGui::Indent();
        for (const course::LessonText& lesson : ui.lesson.all) {
            if (lesson.chapter != chapter) continue;
            const bool isOn = ui.lesson.now && ui.lesson.now->text.file == lesson.file;
            if (ImGui::Selectable(lesson.title.c_str(), isOn)) openLesson(ui, lesson.name);
        }
        ImGui::Unindent();
    }
}

} // namespace shadowlab::window
