// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson_drawing.h"

#include <algorithm>
#include <cmath>

#include "app/picture/labels.h"

namespace shadowlab::course {

namespace {

constexpr image::Color8 kFrame{0xE6, 0x9F, 0x00, 255}, kFrameEdge{16, 16, 18, 255};

void drawBoxOutline(image::Image& figure, ivec2 corner, ivec2 size, int width, image::Color8 color) {
    fillRect(figure, corner.x, corner.y, size.x, width, color);
    fillRect(figure, corner.x, corner.y + size.y - width, size.x, width, color);
    fillRect(figure, corner.x, corner.y, width, size.y, color);
    fillRect(figure, corner.x + size.x - width, corner.y, width, size.y, color);
}

} // namespace

Lines laidOut(const std::string& text, const image::Font& font, double em, int width) {
    Lines lines{font.wrap(text, em, width), em, 0};
    lines.lineHeight = static_cast<int>(std::ceil(font.measure("Xg", em).height * 1.08)); // 8 % of space between lines
    return lines;
}

int drawLines(image::Image& figure, const Lines& lines, const image::Font& font, int x, int y, image::Color8 color) {
    for (const std::string& line : lines.lines) {
        font.draw(figure, x, y, line, lines.em, color);
        y += lines.lineHeight;
    }
    return y;
}

void drawLook(image::Image& picture, const std::vector<LookBox>& look, bool named, const image::Font& font, double em) {
    const ivec2 size(picture.width, picture.height);
    const int line = std::max(2, size.y / 160);
    for (const LookBox& share : look) {
        const LookBox box = inPictureOf(static_cast<double>(size.x) / size.y, share);
        const ivec2 corner(glm::round(box.corner * dvec2(size))), extent(glm::round(box.size * dvec2(size)));
        drawBoxOutline(picture, corner - line / 2 - 1, extent + 2 * (line / 2 + 1), line + 2, kFrameEdge);
        drawBoxOutline(picture, corner - line / 2, extent + 2 * (line / 2), line, kFrame);
        if (!named) continue;
        const picture::Plate plate = picture::titlePlate(share.label, font, em, size.x / 2);
        int y = corner.y - line - plate.height;
        if (y < 0) y = corner.y + extent.y + line;
        if (y + plate.height > size.y) y = corner.y + line;
        picture::drawPlate(picture, plate, std::clamp(corner.x, 0, std::max(0, size.x - plate.width)), y);
    }
}

} // namespace shadowlab::course
