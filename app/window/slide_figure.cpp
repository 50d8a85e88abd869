// SPDX-License-Identifier: MIT
#include "app/window/slide_figure.h"

#include <algorithm>
#include <utility>

#include "app/context/assets.h"
#include "app/course/slides/slide_painter.h"
#include "app/drawing/paint.h"
#include "app/figures/figures.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::window {

namespace {

constexpr image::Color8 kPaper{255, 255, 255, 255};
/// The least type of drawings and slides, in their own units, and how large it is in the window, as a share of the window's type.
constexpr double kLeastShare = 0.7;
constexpr dvec2 kWholeSlide{1920, 1080}; ///< the room that every figure can be drawn in

std::filesystem::path fonts() { return context::assetsRoot() / "fonts"; }

/// The figure for that room, as large as fits: a picture of no more than the drawing itself.
image::Image pictureOf(const figures::Diagram& diagram, ivec2 room) {
    const dvec2 sheet = diagram.drawing.size();
    const double scale = std::min(room.x / sheet.x, room.y / sheet.y);
    const ivec2 size = glm::max(ivec2(1), ivec2(glm::floor(sheet * scale)));
    image::Image picture(size.x, size.y, kPaper);
    drawing::Painter(fonts()).paint(diagram.drawing, picture, {0, 0}, scale);
    return picture;
}

/// Whether the probe is that of the pixel that is marked now, in the picture that is shown now.
bool isKnown(const WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneRequest& of = ui.bench.pickedPixel().askedFor;
    return document.picked && of.view.picked && of.snapshot == ui.bench.shownScene() &&
           of.state.technique == ui.bench.activeState().technique &&
           *of.view.picked == lab::pixelAt(*document.picked, of.view.size);
}

image::Image drawnOfPixel(const WindowState& ui, ivec2 room, float em, const image::Font& font) {
    const lab::PickedPixel& picked = ui.bench.pickedPixel();
    const lab::PaneRequest& of = picked.askedFor;
    const double unitsPerPixel = course::kLeastType / (kLeastShare * em);
    const int light = of.snapshot->lights.empty() ? kNoLight : of.light;
    const figures::Figure& figure = figures::findFigure(ui.slides.stops[ui.slides.stop].figure);
    const image::Font bold(fonts() / "DejaVuSans-Bold.ttf");
    const auto drawn = [&](const dvec2& size) {
        return pictureOf(figure.draw({picked.probe, of.state.technique, *of.snapshot, of.view, light, font, bold, size}), room);
    };
    try {
        return drawn(dvec2(room) * unitsPerPixel);
    } catch (const Error&) { // some need the room of a whole slide: then their type is smaller here
        return drawn(kWholeSlide);
    }
}

/// The words of a slide that has no pictures.
image::Image drawnWhole(const WindowState& ui, ivec2 room) {
    // A slide is 1080 units high: in a room of another shape it stands in the middle.
    const ivec2 size = glm::min(room, ivec2(room.y * 16 / 9, room.x * 9 / 16));
    return course::SlidePainter(fonts(), {glm::max(size, ivec2(1)), 1})
        .draw(ui.slides.slide, {ui.slides.deck->title(), ui.slides.at + 1, ui.slides.deck->slides().size()})
        .content;
}

} // namespace

SlideFigureKind slideFigureKind(const WindowState& ui) {
    const SlideState& on = ui.slides;
    if (storyMode(ui) != StoryMode::slides) return SlideFigureKind::none;
    if (on.stops.empty())
        return on.slide.text.empty() && on.slide.formulas.empty() && on.slide.pseudocode.empty()
                   ? SlideFigureKind::none
                   : SlideFigureKind::wholeSlide;
    return on.stops[on.stop].figure.empty() ? SlideFigureKind::none : SlideFigureKind::ofPixel;
}

bool SlideFigure::update(const WindowState& ui, ivec2 room, float em, const image::Font& font) {
    const SlideFigureKind kind = slideFigureKind(ui);
    if (kind == SlideFigureKind::none || room.x < 1 || room.y < 1) {
        const bool was = static_cast<bool>(texture_);
        *this = {};
        return was;
    }
    const SlideState& on = ui.slides;
    Subject subject{on.deck->file().string() + "\n" + on.slide.name + "\n" + std::to_string(on.stop), room, em, {}, {}, {}};
    if (kind == SlideFigureKind::ofPixel) {
        const lab::PickedPixel& picked = ui.bench.pickedPixel();
        subject.pane = picked.askedFor;
        subject.pixel = picked.askedFor.view.picked;
        subject.partner = picked.askedFor.view.partner;
    }
    if (subject == drawn_) return false;
    if (subject.slide != drawn_.slide) texture_ = {}; // the drawing before stays while the pixel is asked about anew
    const bool isOtherSlide = subject.slide != drawn_.slide;
    drawn_ = subject;
    fault_.clear();
    // Nothing is known of the pixel yet, or what is known is of what was shown before.
    if (kind == SlideFigureKind::ofPixel && !isKnown(ui)) return isOtherSlide;
    try {
        texture_ = lab::textureOf(kind == SlideFigureKind::ofPixel ? drawnOfPixel(ui, room, em, font) : drawnWhole(ui, room));
    } catch (const Error& why) {
        texture_ = {};
        fault_ = why.what();
    }
    return true;
}

} // namespace shadowlab::window
