// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/course/lessons/lesson_figure.h"
#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

using course::Question;

constexpr const char* kHint = "J: on   Shift+J: back   Esc: out";

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// "1 of 2: the artefact"; before that, what is to be done.
std::string stepTitle(const LessonState& on) {
    switch (on.step) {
    case LessonStep::question: return on.paints() ? "Predict: paint the shadow" : "A question";
    case LessonStep::reveal: return "The truth";
    case LessonStep::artefact: return course::stateTitle(0);
    case LessonStep::remedy: return course::stateTitle(1);
    }
    return {};
}

std::string choiceLine(const Question& question, std::size_t i) {
    return std::to_string(i + 1) + "  " + question.choices[i];
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
    return percent(on.score->shadowFound()) + " of the shadow found, " + percent(on.score->paintedRight()) +
           " of the paint in it";
}

bool answersChoice(const LessonState& on) {
    return on.now->question && on.now->question->kind == Question::Kind::choice;
}

/// The lines of a step below its title, in the order in which they stand; the first of them large where it is a score.
std::vector<std::string> lessonLines(const LessonState& on, LessonStep step) {
    const course::Lesson& lesson = *on.now;
    std::vector<std::string> lines;
    if (step == LessonStep::question) {
        lines.push_back(lesson.question->text);
        for (std::size_t i = 0; i < lesson.question->choices.size(); ++i)
            lines.push_back(choiceLine(*lesson.question, i));
        if (lesson.question->kind == Question::Kind::mark)
            lines.emplace_back("Left button: paint.  Right button: wipe.  J: the truth.");
    } else if (step == LessonStep::reveal) {
        lines = {"100 % of the shadow found, 100 % of the paint in it",
                 "green: right   orange: shadow that was missed   blue: painted, but lit"};
    } else {
        if (step == LessonStep::artefact && answersChoice(on)) lines.push_back(verdictOnChoice(on));
        lines.push_back(course::sentenceOf(lesson, step == LessonStep::remedy ? 1 : 0));
    }
    return lines;
}

void swatch(const Theme& theme, ImU32 color, const char* text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + theme.em, at.y + theme.em}, color);
    ImGui::Dummy({theme.em, theme.em});
    ImGui::SameLine();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(0, 1.5f * theme.em);
}

void questionPart(WindowState& ui) {
    LessonState& on = ui.lesson;
    const Question& question = *on.now->question;
    ImGui::TextWrapped("%s", question.text.c_str());
    if (on.paints()) {
        ImGui::TextDisabled("Left button: paint.  Right button: wipe.  J: the truth.");
        return;
    }
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        if (ImGui::Selectable(choiceLine(question, i).c_str(), on.chosen == static_cast<int>(i)))
            answer(ui, static_cast<int>(i));
}

void revealPart(const LessonState& on, const Theme& theme) {
    ImGui::PushFont(theme.heading);
    ImGui::TextWrapped("%s", scoreLine(on).c_str());
    ImGui::PopFont();
    swatch(theme, kPredictedRight, "right");
    swatch(theme, kPredictedMissed, "shadow that was missed");
    swatch(theme, kPredictedWrong, "painted, but lit");
    ImGui::NewLine();
}

} // namespace

float lessonPanelHeight(const WindowState& ui, const Theme& theme, float width) {
    if (!ui.lesson.isOn()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = std::max(theme.em, width - 2 * style.WindowPadding.x);
    float highest = 0;
    for (const LessonStep step : stepsOf(*ui.lesson.now)) {
        float height = 0;
        for (const std::string& line : lessonLines(ui.lesson, step))
            height += (step == LessonStep::reveal ? wrappedHeight(theme.heading, theme.headingSize, line, room)
                                                  : wrappedHeight(theme.text, theme.em, line, room)) +
                      style.ItemSpacing.y;
        highest = std::max(highest, height);
    }
    const float title = std::max(ImGui::GetFrameHeight(), theme.headingSize);
    return std::ceil(title + highest + 2 * style.WindowPadding.y + 2 * style.ItemSpacing.y);
}

void lessonPanel(WindowState& ui, const Area& area, const Theme& theme) {
    const int by = beginBand({"lesson", ui.lesson.now->text.title, stepTitle(ui.lesson), kHint}, area, theme);
    switch (ui.lesson.step) {
    case LessonStep::question: questionPart(ui); break;
    case LessonStep::reveal: revealPart(ui.lesson, theme); break;
    case LessonStep::artefact:
    case LessonStep::remedy:
        for (const std::string& line : lessonLines(ui.lesson, ui.lesson.step))
            ImGui::TextWrapped("%s", line.c_str());
        break;
    }
    ImGui::End();
    if (by != 0) stepLesson(ui, by);
}

void lessonList(WindowState& ui) {
    if (ui.lesson.all.empty() || !ImGui::CollapsingHeader("Lessons")) return;
    for (const course::LessonText& lesson : ui.lesson.all) {
        const bool on = ui.lesson.now && ui.lesson.now->text.file == lesson.file;
        if (ImGui::Selectable(lesson.title.c_str(), on)) openLesson(ui, lesson.name);
    }
}

} // namespace shadowlab::window
