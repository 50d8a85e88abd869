// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_painter.h"

#include <algorithm>
#include <cmath>

#include "app/course/slides/slide_words.h"
#include "app/course/state_picture.h"
#include "app/figures/figures.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

using drawing::Drawing;

constexpr image::Color8 kPaper{255, 255, 255, 255};
constexpr const char *kInk = "#1a1a1a", *kQuiet = "#5a5a5a", *kRule = "#bfbfbf";
constexpr const char *kCallout = "#e69f00", *kCalloutEdge = "#101012"; ///< seen on light and dark pictures

// The drawing of a pixel is about a picture of that size; a share of it is the same place in a picture of any other.
constexpr ivec2 kProbedSize{1280, 720};
// Its type is as large as the least that is read from the last row. Drawings that are higher than a slide has room for are made
// smaller, but not below this share.
constexpr double kLeastDrawingScale = 0.8;

/// The drawing that the picture's technique makes of its pixel.
figures::Diagram drawingOf(const SlidePicture& picture, const image::Font& font, dvec2 size) {
    std::vector<picture::Slot> slots = slotsOf(picture.state.slots);
    View view;
    view.camera = picture.state.camera;
    view.size = kProbedSize;
    const ivec2 pixel = lab::pixelAt(*picture.pixel, kProbedSize);
    view.picked = pixel;
    if (picture.partner) view.partner = lab::pixelAt(*picture.partner, kProbedSize);
    const int light = picture.state.scene->lights.empty() ? kNoLight : picture.state.light;
    const Probe probe = slots[0].technique->probe(picture.state.scene, view, pixel, light);
    return figures::findFigure(picture.figure)
        .draw({probe, picture.state.slots[0].technique, *picture.state.scene, view, light, font, size});
}

void writeLines(Drawing& drawing, const std::vector<std::string>& lines, dvec2 place, const drawing::TextStyle& style) {
    for (const std::string& line : lines) {
        place.y += kLineHeight * style.size;
        drawing.text(place, line, style);
    }
}

/// Frames and arrows over a picture that fills the cell, each with its words where there is room.
void drawCallouts(Drawing& drawing, const SlidePicture& picture, const Box& cell, const image::Font& bold) {
    const drawing::TextStyle style{.size = kLabelType, .isBold = true, .color = kInk};
    for (const Callout& callout : picture.callouts) {
        const dvec2 from = cell.corner + callout.from * cell.size, to = cell.corner + callout.to * cell.size;
        const double width = drawing::textSize(bold, callout.label, kLabelType).x;
        // The label's left end, moved so that all of it lies in the picture.
        const auto within = [&](double left) {
            constexpr double kPad = 6;
            const double least = cell.corner.x + kPad;
            return std::clamp(left, least, std::max(least, cell.corner.x + cell.size.x - width - kPad));
        };
        if (callout.isArrow) {
            drawing.arrow(from, to, {kCalloutEdge, 9, false});
            drawing.arrow(from, to, {kCallout, 5, false});
            const double foot = to.y < from.y ? from.y + kLabelType : from.y - 0.4 * kLabelType; // at its tail
            if (!callout.label.empty()) drawing.text({within(from.x - width / 2), foot}, callout.label, style);
            continue;
        }
        drawing.rectangle(from, to - from, "", {kCalloutEdge, 8, false});
        drawing.rectangle(from, to - from, "", {kCallout, 4, false});
        const bool isRoomAbove = from.y - cell.corner.y > 1.4 * kLabelType;
        const double foot = isRoomAbove ? from.y - 0.45 * kLabelType : to.y + 1.1 * kLabelType;
        if (!callout.label.empty()) drawing.text({within(from.x), foot}, callout.label, style);
    }
}

} // namespace

SlidePainter::SlidePainter(const std::filesystem::path& fonts, const SlideLook& look)
    : look_(look), upright_(fonts / "DejaVuSans.ttf"), bold_(fonts / "DejaVuSans-Bold.ttf"), painter_(fonts),
      scale_(look.size.y / kSlideHeight) {}

ivec2 SlidePainter::pixels(dvec2 place) const { return ivec2(glm::round(place * scale_)); }

image::Image SlidePainter::cut(const image::Image& slide, const Box& box) const {
    const ivec2 corner = pixels(box.corner), size = pixels(box.corner + box.size) - corner;
    image::Image part(size.x, size.y);
    blit(part, -corner.x, -corner.y, slide);
    return part;
}

image::Image SlidePainter::drawFigure(const SlidePicture& picture, dvec2 cell) const {
    const figures::Diagram drawn = drawingOf(picture, upright_, cell);
    const dvec2 sheet = drawn.drawing.size();
    const double scale = std::min(cell.x / sheet.x, cell.y / sheet.y);
    if (scale < kLeastDrawingScale)
        throw Error(ExitStatus::badInput, "a drawing needs the whole slide to be read; leave out the words and "
                                          "pictures beside it");
    const ivec2 size = pixels(cell);
    image::Image image(size.x, size.y, kPaper);
    painter_.paint(drawn.drawing, image, pixels((cell - sheet * scale) / 2.0), scale * scale_);
    return image;
}

std::vector<SlidePainter::Placed> SlidePainter::drawPictures(const Slide& slide,
                                                             const SlideLayout& layout) const {
    std::vector<Placed> placed;
    for (std::size_t i = 0; i < slide.pictures.size(); ++i) {
        const SlidePicture& picture = slide.pictures[i];
        const Box& cell = layout.cells[i];
        const ivec2 size = pixels(cell.corner + cell.size) - pixels(cell.corner);
        const StateRequest request{.size = size,
                                            .supersample = slide.supersample.value_or(look_.supersample),
                                            .typeHeight = look_.size.y,
                                            .roomBelow = static_cast<int>(layout.roomBelow[i] * scale_),
                                            .picked = picture.pixel,
                                            .partner = picture.partner,
                                            .outside = picture.outside};
        placed.push_back({picture.figure.empty() ? drawState(picture.state, request, upright_)
                                                 : drawFigure(picture, cell.size),
                          cell});
    }
    // What a row leaves free is above it and below it.
    std::vector<double> shifts;
    for (const Placed& of : placed) {
        double least = kSlideHeight;
        for (std::size_t i = 0; i < placed.size(); ++i)
            if (placed[i].cell.corner.y == of.cell.corner.y)
                least =
                    std::min(least, layout.roomBelow[i] + placed[i].cell.size.y - placed[i].picture.height / scale_);
        shifts.push_back(std::max(0.0, least / 2));
    }
    for (std::size_t i = 0; i < placed.size(); ++i)
        placed[i].cell.corner.y += shifts[i];
    return placed;
}

DrawnSlide SlidePainter::draw(const Slide& slide, const SlideFoot& foot) const {
    const Fonts fonts{upright_, bold_};
    const double width = look_.size.x / scale_;
    const SlideLayout layout = layOut(slide, width, fonts);
    DrawnSlide drawn{image::Image(look_.size.x, look_.size.y, kPaper), {}, {}};
    Drawing drawing({width, kSlideHeight});
    const std::vector<Placed> placed = drawPictures(slide, layout);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Box& cell = placed[i].cell;
        const ivec2 corner = pixels(cell.corner);
        blit(drawn.slide, corner.x, corner.y, placed[i].picture);
        drawCallouts(drawing, slide.pictures[i], cell, bold_);
        if (!slide.pictures[i].label.empty())
            drawing.text(cell.corner + dvec2(cell.size.x / 2, -0.35 * kLabelType), slide.pictures[i].label,
                         {.size = kLabelType,
                          .anchor = drawing::Anchor::middle,
                          .isBold = true,
                          .color = kInk,
                          .hasRim = false});
    }
    painter_.paint(drawing, drawn.slide, {0, 0}, scale_);
    if (!slide.pictures.empty()) drawn.pictures = cut(drawn.slide, layout.pictures);

    Drawing words({width, kSlideHeight});
    writeWords(words, slide, layout, fonts);
    painter_.paint(words, drawn.slide, {0, 0}, scale_);
    drawn.content = cut(drawn.slide, layout.content);

    Drawing rim({width, kSlideHeight});
    writeLines(rim, layout.title, {kMargin, kMargin / 4},
               {.size = kTitleType, .isBold = true, .color = kInk, .hasRim = false});
    const double footLine = kSlideHeight - 0.75 * kFootType;
    writeLines(rim, layout.caption,
               {kMargin, footLine - 1.2 * kLineHeight * kFootType -
                             kLineHeight * kCaptionType * static_cast<double>(layout.caption.size())},
               {.size = kCaptionType, .color = kInk, .hasRim = false});
    rim.line({kMargin, footLine - 1.1 * kFootType}, {width - kMargin, footLine - 1.1 * kFootType}, {kRule, 2, false});
    rim.text({kMargin, footLine}, foot.deck, {.size = kFootType, .color = kQuiet, .hasRim = false});
    rim.text({width - kMargin, footLine}, std::to_string(foot.number) + " / " + std::to_string(foot.of),
             {.size = kFootType, .anchor = drawing::Anchor::end, .color = kQuiet, .hasRim = false});
    painter_.paint(rim, drawn.slide, {0, 0}, scale_);
    return drawn;
}

} // namespace shadowlab::course
