// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_painter.h"

#include <algorithm>
#include <cmath>

#include "app/course/slides/slide_legend.h"
#include "app/course/slides/slide_words.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

using drawing::Drawing;

constexpr image::Color8 kPaper{255, 255, 255, 255};
constexpr const char *kInk = "#1a1a1a", *kQuiet = "#5a5a5a", *kRule = "#bfbfbf";
constexpr double kEdgeAhead = 7; ///< by which the dark edge of an arrow's tip is before the tip
constexpr const char *kCallout = "#e69f00", *kCalloutEdge = "#101012"; ///< seen on light and dark pictures

// The type of a drawing is as large as the least that is read from the last row. Drawings that are higher than a slide has room for
// are made smaller, but not below this share.
constexpr double kLeastDrawingScale = 0.8;

void writeLines(Drawing& drawing, const std::vector<drawing::ProseLine>& lines, dvec2 place, const drawing::TextStyle& style,
                const Fonts& fonts) {
    for (const drawing::ProseLine& line : lines) {
        place.y += kLineHeight * style.size;
        drawing::drawProse(drawing, place, line, style, fonts.formula());
    }
}

/// Above a picture: in rows of several lines the last of them stands at the picture.
void writeLabel(Drawing& drawing, const std::string& label, const Box& box, const Fonts& fonts) {
    const std::vector<drawing::ProseLine> lines = drawing::wrapProse(label, kLabelType, box.size.x, true, fonts.formula());
    const double row = kLineHeight * kLabelType;
    double foot = box.corner.y + box.size.y - row * (static_cast<double>(lines.size()) - 0.75);
    for (const drawing::ProseLine& line : lines) {
        drawing::drawProse(drawing, {box.corner.x, foot}, line,
                           {.size = kLabelType, .isBold = true, .color = kInk, .hasRim = false}, fonts.formula());
        foot += row;
    }
}

/// In exactly that size: a stage of its own size may miss it by a pixel, or have fewer texels than that. Each stays one colour.
image::Image resized(const image::Image& picture, ivec2 size) {
    if (picture.width == size.x && picture.height == size.y) return picture;
    image::Image result(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            result.set(x, y, picture.at(x * picture.width / size.x, y * picture.height / size.y));
    return result;
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
            drawing.arrow(from, to + kEdgeAhead * glm::normalize(to - from), {kCalloutEdge, 9, false});
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

void SlidePainter::drawPart(image::Image& slide, const DrawnPictures& pictures, std::size_t i) const {
    const Fonts fonts{upright_, bold_};
    const SlideLayout& layout = pictures.layout;
    const DrawnPart& drawn = pictures.drawn[i];
    const SlidePart& part = pictures.parts[i];
    const Box& cell = layout.cells[i];
    Drawing over({layout.width, kSlideHeight});
    if (drawn.diagram) {
        const Drawing& sheet = drawn.diagram->drawing;
        const dvec2 room = cell.size + 2 * drawn.diagramBorder;
        const double scale = std::min(room.x / sheet.size().x, room.y / sheet.size().y);
        if (scale < kLeastDrawingScale)
            throw Error(ExitStatus::badInput, "a drawing needs the whole slide to be read; leave out the words and pictures beside it");
        painter_.paint(sheet, slide, pixels(cell.corner - scale * drawn.diagramBorder), scale * scale_);
        if (!layout.labels.empty()) writeLabel(over, part.label, layout.labels[i], fonts);
    } else {
        const ivec2 corner = pixels(cell.corner), size = ivec2(glm::round(cell.size * scale_));
        const StatePicture::Parts& parts = drawn.parts;
        const bool isAlone = parts.panels.size() == 1 && parts.cells[0].width == size.x;
        blit(slide, corner.x, corner.y,
             isAlone ? resized(parts.panels[0].picture, size) : picture::composeFigure(parts.cells, parts.panels, size, nullptr).picture);
        for (std::size_t band = 0; band < parts.panels.size(); ++band) {
            const double left = cell.corner.x + parts.cells[band].x / scale_, width = parts.cells[band].width / scale_;
            if (!layout.labels.empty())
                writeLabel(over, hasBands(part) ? parts.panels[band].title : part.label,
                           {{left, layout.labels[i].corner.y}, {width, layout.labels[i].size.y}}, fonts);
            drawLegendBelow(over, parts.panels[band], {left, layout.legends[i].corner.y}, width, fonts);
        }
    }
    drawCallouts(over, part.picture, cell, bold_);
    painter_.paint(over, slide, {0, 0}, scale_);
}

DrawnSlide SlidePainter::draw(const Slide& slide, const SlideFoot& foot) const {
    const Fonts fonts{upright_, bold_};
    const double width = look_.size.x / scale_;
    const DrawnPictures pictures = drawPictures(slide, fonts, {width, scale_, look_.supersample});
    const SlideLayout& layout = pictures.layout;
    DrawnSlide drawn{image::Image(look_.size.x, look_.size.y, kPaper), {}, {}, {}};
    for (std::size_t i = 0; i < pictures.parts.size(); ++i)
        drawPart(drawn.slide, pictures, i);
    if (!slide.pictures.empty()) {
        drawn.pictures = cut(drawn.slide, layout.pictures);
        const dvec2 whole(width, kSlideHeight);
        drawn.picturesAt = {layout.pictures.corner / whole, layout.pictures.size / whole};
    }

    Drawing words({width, kSlideHeight});
    writeWords(words, slide, layout, fonts);
    painter_.paint(words, drawn.slide, {0, 0}, scale_);
    drawn.content = cut(drawn.slide, layout.content);

    Drawing rim({width, kSlideHeight});
    writeLines(rim, layout.title, {kMargin, kMargin / 4},
               {.size = kTitleType, .isBold = true, .color = kInk, .hasRim = false}, fonts);
    writeLines(rim, layout.caption, {kMargin, layout.captionTop}, {.size = layout.captionType, .color = kInk, .hasRim = false}, fonts);
    const double footLine = kSlideHeight - 0.75 * kFootType;
    rim.line({kMargin, footLine - 1.1 * kFootType}, {width - kMargin, footLine - 1.1 * kFootType}, {kRule, 2, false});
    rim.text({kMargin, footLine}, foot.deck, {.size = kFootType, .color = kQuiet, .hasRim = false});
    rim.text({width - kMargin, footLine}, std::to_string(foot.number) + " / " + std::to_string(foot.of),
             {.size = kFootType, .anchor = drawing::Anchor::end, .color = kQuiet, .hasRim = false});
    painter_.paint(rim, drawn.slide, {0, 0}, scale_);
    return drawn;
}

} // namespace shadowlab::course
