// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson_lines.h"

#include <cmath>

namespace shadowlab::course {

Lines laidOut(const std::string& text, const image::Font& font, double em, int width) {
    Lines lines{font.wrap(text, em, width), em, 0};
    lines.lineHeight = static_cast<int>(std::ceil(font.measure("Xg", em).height * 1.08)); // a little air for the eye
    return lines;
}

int drawLines(image::Image& figure, const Lines& lines, const image::Font& font, int x, int y, image::Color8 color) {
    for (const std::string& line : lines.lines) {
        font.draw(figure, x, y, line, lines.em, color);
        y += lines.lineHeight;
    }
    return y;
}

} // namespace shadowlab::course
