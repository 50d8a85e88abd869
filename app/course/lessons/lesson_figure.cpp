// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/course/lessons/lesson_drawing.h"
#include "app/course/state_picture.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

constexpr std::array kSentenceShares = {1.0 / 22, 1.0 / 25, 1.0 / 28,
                                        1.0 / 32}; ///< the first that leaves the pictures whole
constexpr int kLeastPicture = 120;                 ///< pixels: narrower ones show nothing

/// What stands below one picture.
struct Column {
    Lines heading, sentence, settings;
    [[nodiscard]] int height() const { return heading.height() + sentence.height() + settings.height(); }
};

} // namespace

std::string stateTitle(std::size_t state) { return state == 0 ? "1 of 2: the artefact" : "2 of 2: the remedy"; }

std::string settingsLine(const ShownState& state) {
    std::string line;
    for (const std::string& setting : state.settings)
        line += (line.empty() ? "" : ",  ") + setting;
    return line;
}

const std::string& sentenceOf(const Lesson& lesson, std::size_t state) {
    return state == 0 ? lesson.text.happens : lesson.text.remedy;
}

image::Image lessonFigure(const Lesson& lesson, const ShownStates& states, ivec2 size, const image::Font& font,
                          const image::Font& bold) {
    const auto columns = static_cast<int>(states.size());
    const int pad = std::max(4, size.y / 60);
    const int columnWidth = (size.x - (columns + 1) * pad) / columns;
    const Lines title = laidOut(lesson.text.title, bold, size.y * kLessonTitleShare, size.x - 2 * pad);
    const int top = title.height() + 2 * pad;
    const int wholeHeight = static_cast<int>(std::lround(columnWidth / kLessonAspect));
    std::vector<Column> texts;
    int room = 0;
    for (const double share : kSentenceShares) {
        texts.clear();
        int textHeight = 0;
        for (const std::size_t state : states) {
            const ShownState& shown = lesson.states[state];
            texts.push_back({laidOut(stateTitle(state), bold, size.y * share, columnWidth),
                             laidOut(sentenceOf(lesson, state), font, size.y * share, columnWidth - pad),
                             laidOut(settingsLine(shown), font, size.y * kLessonSettingShare, columnWidth)});
            textHeight = std::max(textHeight, texts.back().height());
        }
        room = size.y - top - textHeight - 2 * pad;
        if (room >= wholeHeight) break;
    }
    const int pictureHeight = std::min(room, wholeHeight);
    const ivec2 pictureSize(std::min(columnWidth, static_cast<int>(std::lround(pictureHeight * kLessonAspect))),
                            pictureHeight);
    if (pictureSize.x < kLeastPicture)
        throw Error(ExitStatus::usage, "--size: " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                                           " has no room for pictures beside the words; choose a larger size");

    image::Image figure(size.x, size.y, kLessonGround);
    drawLines(figure, title, bold, pad, pad, kLessonText);
    for (int i = 0; i < columns; ++i) {
        const auto column = static_cast<std::size_t>(i);
        const int x = pad + i * (columnWidth + pad);
        image::Image picture = drawState(lesson.states[states[column]], {.size = pictureSize}, font);
        drawLook(picture, lesson.look, states[column] == 0, font, std::max(10.0, size.y * kLessonLabelShare));
        blit(figure, x + (columnWidth - pictureSize.x) / 2, top, picture);
        int y = top + pictureHeight + pad;
        y = drawLines(figure, texts[column].heading, bold, x, y, kLessonAccent);
        y = drawLines(figure, texts[column].sentence, font, x, y, kLessonText);
        drawLines(figure, texts[column].settings, font, x, y, kLessonQuiet);
    }
    return figure;
}

} // namespace shadowlab::course
