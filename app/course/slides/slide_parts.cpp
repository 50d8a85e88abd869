// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_parts.h"

#include <algorithm>

#include "app/picture/figure.h"
#include "techniques/technique.h"

namespace shadowlab::course {

namespace {

using picture::Layout;

/// A frame or an arrow that begins in that cell of a figure, in shares of the cell.
std::vector<Callout> calloutsIn(const std::vector<Callout>& callouts, dvec2 corner, dvec2 size) {
    std::vector<Callout> found;
    for (Callout callout : callouts) {
        callout.from = (callout.from - corner) / size;
        if (glm::any(glm::lessThan(callout.from, dvec2(0))) || glm::any(glm::greaterThanEqual(callout.from, dvec2(1))))
            continue;
        callout.to = glm::clamp((callout.to - corner) / size, 0.0, 1.0);
        found.push_back(std::move(callout));
    }
    return found;
}

void addEachSlot(std::vector<SlidePart>& parts, const SlidePicture& picture) {
    constexpr int kFine = 1 << 20; // pixels of an imagined figure: shares of it are exact enough then
    const std::vector<picture::Cell> cells =
        picture::layoutCells(picture.state.layout, static_cast<int>(picture.state.slots.size()), ivec2(kFine));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const picture::Cell& cell = cells[i];
        SlidePart part{picture, picture.writtenLabel};
        part.label += (part.label.empty() ? "" : ": ") + std::string(findTechnique(picture.state.slots[i].technique).title);
        part.picture.state.layout = Layout::single;
        part.picture.state.slots = {picture.state.slots[i]};
        part.picture.callouts =
            calloutsIn(picture.callouts, dvec2(cell.x, cell.y) / double(kFine), dvec2(cell.width, cell.height) / double(kFine));
        parts.push_back(std::move(part));
    }
}

} // namespace

std::vector<SlidePart> partsOf(const Slide& slide) {
    std::vector<SlidePart> parts;
    for (const SlidePicture& picture : slide.pictures) {
        const Layout layout = picture.state.layout;
        if (picture.state.slots.size() > 1 && (layout == Layout::side || layout == Layout::grid))
            addEachSlot(parts, picture);
        else
            parts.push_back({picture, picture.writtenLabel});
    }
    return parts;
}

bool hasBands(const SlidePart& part) {
    return part.picture.state.layout == Layout::split && part.picture.state.slots.size() > 1;
}

bool mayHaveLegend(const SlidePart& part) {
    if (!part.picture.figure.empty()) return false;
    return part.picture.state.layout == Layout::diff ||
           std::ranges::any_of(part.picture.state.slots, [](const lab::PaneState& slot) { return !slot.stage.isPicture(); });
}

} // namespace shadowlab::course
