// SPDX-License-Identifier: MIT
#include "app/student/grading/score_picture.h"

#include <vector>

#include "app/context/assets.h"
#include "app/picture/figure.h"
#include "app/picture/verdict_panels.h"
#include "app/student/grading/picture_difference.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::student {

namespace {

constexpr int kEnlarged = 2;
constexpr double kType = 1.0 / 20; // of a panel's height: three stand beside each other on one slide

image::Image enlarged(const image::Image& picture) {
    image::Image large(kEnlarged * picture.width, kEnlarged * picture.height);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            large.set(x, y, picture.at(x / kEnlarged, y / kEnlarged));
    return large;
}

/// A dark picture that says why there is none.
image::Image withoutPicture(const std::string& why, ivec2 size, const image::Font& font) {
    image::Image picture(size.x, size.y, {0x20, 0x20, 0x24, 255});
    const double em = kType * size.y;
    std::string text;
    for (const std::string& line : font.wrap("no picture: " + why, em, size.x - static_cast<int>(4 * em)))
        text += (text.empty() ? "" : "\n") + line;
    font.draw(picture, static_cast<int>(2 * em), size.y / 3, text, em, {0xF2, 0xF2, 0xF2, 255});
    return picture;
}

/// The three beside each other, under their titles.
image::Image sideBySide(std::vector<picture::Panel> panels, ivec2 size, const image::Font& font) {
    const ivec2 whole(3 * size.x, size.y);
    std::vector<picture::Cell> cells = picture::layoutCells(picture::Layout::side, 3, whole);
    return picture::composeFigure(cells, panels, whole, &font).picture;
}

/// Grey, and no darker than a third of white, so that what is marked stands out.
image::Color8 faint(const image::Color8& c) {
    const int grey = 85 + (c.r + c.g + c.b) * 170 / 765;
    const auto level = static_cast<std::uint8_t>(grey);
    return {level, level, level, 255};
}

picture::Panel differencePanel(image::Image picture, const image::Image& right, int levels) {
    const PictureDifference found = difference(picture, right, levels);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.set(x, y,
                        found.wrong[static_cast<std::size_t>(y * picture.width + x)] ? image::encoded(look::kFalseLit)
                                                                                     : faint(picture.at(x, y)));
    const std::string label =
        "more than " + std::to_string(levels) + " of 255 levels off: " + std::to_string(found.count) + " px";
    return {std::move(picture), "", StageKind::swatches, {.unit = "", .key = {{look::kFalseLit, label}}}};
}

} // namespace

image::Image scorePicture(std::optional<image::Image> student, const std::string& failure, const judge::Truth& truth,
                          const judge::Judgement& judgement) {
    const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    const ivec2 size = kEnlarged * truth.size;
    picture::Panel truthPanel = picture::truthPanel(truth, {});
    picture::Panel errors = picture::errorPanel(
        student ? *student : image::Image(truth.size.x, truth.size.y, {0x20, 0x20, 0x24, 255}), truth, judgement, {});
    std::vector<picture::Panel> panels(3);
    panels[0].picture = student ? enlarged(*student) : withoutPicture(failure, size, font);
    panels[1] = std::move(truthPanel);
    panels[1].picture = enlarged(panels[1].picture);
    panels[2] = std::move(errors);
    panels[2].picture = enlarged(panels[2].picture);
    panels[0].title = "Student";
    panels[1].title = "Truth";
    panels[2].title = "Difference";
    return sideBySide(std::move(panels), size, font);
}

image::Image scorePicture(std::optional<image::Image> student, const std::string& failure, const image::Image& right,
                          int levels) {
    const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    const ivec2 size = kEnlarged * ivec2(right.width, right.height);
    picture::Panel errors = differencePanel(
        student ? *student : image::Image(right.width, right.height, {0x20, 0x20, 0x24, 255}), right, levels);
    std::vector<picture::Panel> panels(3);
    panels[0] = {
        student ? enlarged(*student) : withoutPicture(failure, size, font), "Student", StageKind::radiance, {}};
    panels[1] = {enlarged(right), "Right", StageKind::radiance, {}};
    panels[2] = std::move(errors);
    panels[2].picture = enlarged(panels[2].picture);
    panels[2].title = "Difference";
    return sideBySide(std::move(panels), size, font);
}

} // namespace shadowlab::student
