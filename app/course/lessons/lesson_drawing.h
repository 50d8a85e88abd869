// The words of a lesson on a picture, broken into lines and drawn in its colours, and the frames around what there is to see.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

constexpr image::Color8 kLessonGround{16, 16, 18, 255}, kLessonText{245, 245, 245, 255},
    kLessonQuiet{178, 178, 182, 255}, kLessonAccent{0xE6, 0x9F, 0x00, 255};

// Type sizes as shares of the figure's height; 1/45 is read from the last row of a lecture hall.
constexpr double kLessonTitleShare = 1.0 / 20, kLessonSettingShare = 1.0 / 42, kLessonLabelShare = 1.0 / 36;

/// Lines of one text, and how high they are, in pixels.
struct Lines {
    std::vector<std::string> lines;
    double em = 0;
    int lineHeight = 0;
    [[nodiscard]] int height() const { return static_cast<int>(lines.size()) * lineHeight; }
};

/// Breaks the text so that it is no wider than `width` pixels in type of the size `em`.
Lines laidOut(const std::string& text, const image::Font& font, double em, int width);

/// Draws them from (x, y) downward. Returns where the next line would begin.
int drawLines(image::Image& figure, const Lines& lines, const image::Font& font, int x, int y, image::Color8 color);

/// Frames what to look at. Where the artefact is, it is named: above the box, else below it, else in it, as there is room. `em`
/// is the type size in pixels.
void drawLook(image::Image& picture, const std::vector<LookBox>& look, bool named, const image::Font& font, double em);

} // namespace shadowlab::course
