// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_pictures.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/course/slides/slide_legend.h"
#include "app/figures/figures.h"

namespace shadowlab::course {

namespace {

// The drawing of a pixel is about a picture of that size; a share of it is the same place in a picture of any other.
constexpr ivec2 kProbedSize{1280, 720};
constexpr dvec2 kTrialSize{320, 180}; ///< units: enough for a legend to have its entries
constexpr int kMostTries = 3;         ///< of a larger picture the legend may need a line more, or none at all

/// What the technique knows of the pixel that a drawing is about.
struct Probed {
    View view;
    int light = kNoLight;
    Probe probe;
};
Probed probed(const SlidePicture& picture) {
    std::vector<picture::Slot> slots = slotsOf(picture.state.slots);
    View view;
    view.camera = picture.state.camera;
    view.size = kProbedSize;
    const ivec2 pixel = lab::pixelAt(*picture.pixel, kProbedSize);
    view.picked = pixel;
    if (picture.partner) view.partner = lab::pixelAt(*picture.partner, kProbedSize);
    const int light = picture.state.scene->lights.empty() ? kNoLight : picture.state.light;
    return {view, light, slots[0].technique->probe(picture.state.scene, view, pixel, light)};
}

/// A drawing, in a box of that size without the sheet's border.
figures::Diagram drawingOf(const SlidePicture& picture, const Probed& of, const Fonts& fonts, dvec2 size, double mostPixelsPerMetre) {
    const figures::Figure& figure = figures::findFigure(picture.figure);
    return figure.draw({of.probe, picture.state.slots[0].technique, *picture.state.scene, of.view, of.light, fonts.upright, fonts.bold,
                        size + 2 * figure.border, mostPixelsPerMetre});
}

class Pictures {
public:
    Pictures(const Slide& slide, const Fonts& fonts, const PicturesRequest& request)
        : slide_(slide), fonts_(fonts), request_(request), parts_(partsOf(slide)) {
        for (const SlidePart& part : parts_)
            states_.push_back(part.picture.figure.empty() ? std::make_unique<StatePicture>(part.picture.state, fonts.upright) : nullptr);
        drawn_.resize(parts_.size());
    }

    DrawnPictures draw() {
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (mayHaveLegend(parts_[i])) drawState(i, kTrialSize, 1);
        findNeeds();
        shareRanges();
        SlideLayout layout = layOut(slide_, request_.slideWidth, fonts_, needs_);
        for (int i = 0; i < kMostTries; ++i) {
            for (std::size_t part = 0; part < parts_.size(); ++part)
                if (states_[part])
                    drawState(part, layout.cells[part].size, slide_.supersample.value_or(request_.supersample));
            SlideLayout next = layOut(slide_, request_.slideWidth, fonts_, needs_);
            if (isAlike(next, layout)) break;
            layout = std::move(next);
        }
        drawDiagrams(layout);
        return {std::move(layout), std::move(parts_), std::move(drawn_)};
    }

private:
    void drawState(std::size_t i, dvec2 size, int supersample) {
        const SlidePicture& picture = parts_[i].picture;
        StateRequest request{.size = ivec2(glm::round(size * request_.scale)),
                             .wholeHeight = static_cast<int>(kSlideHeight * request_.scale),
                             .supersample = supersample,
                             .picked = picture.pixel,
                             .partner = picture.partner,
                             .outside = picture.outside,
                             .outsideChoice = picture.outsideChoice};
        if (i < ranges_.size()) request.range = ranges_[i];
        drawn_[i].parts = states_[i]->draw(request);
    }

    void findNeeds() {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            PictureNeeds needs;
            needs.label = hasBands(parts_[i]) ? "bands" : parts_[i].label; // names of techniques fit above their bands
            needs.isDrawing = !parts_[i].picture.figure.empty();
            const StatePicture::Parts& trial = drawn_[i].parts;
            if (trial.panels.size() == 1) {
                const image::Image& picture = trial.panels[0].picture;
                // A stage of a size of its own is smaller than the room that it was given.
                const ivec2 room(trial.cells[0].width, trial.cells[0].height);
                if (picture.width < room.x || picture.height < room.y) needs.aspect = double(picture.width) / picture.height;
            }
            if (std::ranges::any_of(trial.panels, picture::hasLegend))
                needs.legendHeight = [this, i](double width) { return heightOfLegend(i, width); };
            needs_.push_back(std::move(needs));
        }
    }

    [[nodiscard]] double heightOfLegend(std::size_t i, double width) const {
        double height = 0;
        const StatePicture::Parts& parts = drawn_[i].parts;
        double all = 0;
        for (const picture::Cell& cell : parts.cells)
            all += cell.width;
        for (std::size_t band = 0; band < parts.panels.size(); ++band)
            height = std::max(height, legendHeight(parts.panels[band], width * parts.cells[band].width / all, fonts_));
        return height;
    }

    /// Is there room for each picture and its legend where there was?
    static bool isAlike(const SlideLayout& a, const SlideLayout& b) {
        return std::ranges::equal(a.cells, b.cells, [](const Box& x, const Box& y) { return x.corner == y.corner && x.size == y.size; });
    }

    /// Colours that stand for the same unit get one range in all pictures: a colour means one value on the slide.
    void shareRanges() {
        const auto isOneOf = [](const picture::Panel& a, const picture::Panel& b) {
            return a.kind == b.kind && picture::hasScale(a.kind) && a.display.unit == b.display.unit;
        };
        ranges_.resize(parts_.size());
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (drawn_[i].parts.panels.size() != 1) continue;
            const picture::Panel& own = drawn_[i].parts.panels[0];
            dvec2 range(own.display.minimum, own.display.maximum);
            bool isShared = false;
            for (std::size_t j = 0; j < parts_.size(); ++j) {
                if (i == j || drawn_[j].parts.panels.size() != 1) continue;
                const picture::Panel& other = drawn_[j].parts.panels[0];
                if (!isOneOf(own, other)) continue;
                isShared = true;
                range = {std::min(range.x, other.display.minimum), std::max(range.y, other.display.maximum)};
            }
            if (isShared) ranges_[i] = range;
        }
    }

    /// Sections that stand side by side have the least of their scales, and begin at one corner: they are drawn once more with that scale.
    void drawDiagrams(const SlideLayout& layout) {
        double least = std::numeric_limits<double>::infinity();
        std::vector<std::optional<Probed>> probes(parts_.size()); // of the drawings
        for (std::size_t part = 0; part < parts_.size(); ++part)
            if (!parts_[part].picture.figure.empty()) probes[part] = probed(parts_[part].picture);
        for (int i = 0; i < 2; ++i) {
            int scaled = 0;
            for (std::size_t part = 0; part < parts_.size(); ++part) {
                if (!probes[part]) continue;
                const SlidePicture& picture = parts_[part].picture;
                DrawnPart& drawn = drawn_[part];
                drawn.diagram = drawingOf(picture, *probes[part], fonts_, layout.cells[part].size, least);
                drawn.diagramBorder = figures::findFigure(picture.figure).border;
                if (const double scale = drawn.diagram->pixelsPerMetre; scale > 0) {
                    ++scaled;
                    least = std::min(least, scale);
                }
            }
            if (scaled < 2) break;
        }
    }

    const Slide& slide_;
    const Fonts& fonts_;
    PicturesRequest request_;
    std::vector<SlidePart> parts_;
    std::vector<std::unique_ptr<StatePicture>> states_; ///< of each part; null: it is a drawing
    std::vector<PictureNeeds> needs_;
    std::vector<std::optional<dvec2>> ranges_;
    std::vector<DrawnPart> drawn_;
};

} // namespace

DrawnPictures drawPictures(const Slide& slide, const Fonts& fonts, const PicturesRequest& request) {
    return Pictures(slide, fonts, request).draw();
}

} // namespace shadowlab::course
