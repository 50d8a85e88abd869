// SPDX-License-Identifier: MIT
#include "app/session/lesson_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/derived_stages.h"
#include "app/session/difference_panel.h"
#include "app/session/labels.h"
#include "app/session/picture.h"

namespace shadowlab::session {

namespace {

constexpr image::Color8 kFrame{0xE6, 0x9F, 0x00, 255}, kFrameEdge{16, 16, 18, 255};

class StatePicture {
public:
    StatePicture(const LessonState& state, ivec2 size, const image::Font& font)
        : state_(state), size_(size), font_(font), session_(state.scene), slots_(slotsOf(state.slots)) {}

    image::Image draw() {
        std::vector<Cell> cells = layoutCells(state_.layout, static_cast<int>(slots_.size()), size_);
        std::vector<Panel> panels;
        if (state_.layout == Layout::diff)
            panels.push_back(difference());
        else
            for (std::size_t i = 0; i < slots_.size(); ++i)
                panels.push_back(panel(i, cells[i]));
        return composeFigure(cells, panels, size_, &font_).picture;
    }

private:
    Panel panel(std::size_t i, Cell& cell) {
        Slot& slot = slots_[i];
        View view;
        view.camera = state_.camera;
        view.size = cell.pictureSize;
        view.region = {ivec2(cell.cropX, 0), ivec2(cell.width, cell.height)};
        std::optional<StageChoice> stage;
        if (!state_.slots[i].stage.empty())
            stage = parseStage(state_.slots[i].stage, *slot.info, *state_.scene, state_.light);
        FrameRequest request;
        if (stage && stage->isPass) request.stopAfter = stage->key;
        if (stage && !stage->isPass) request.stages = neededFor(stage->key);
        const RenderedFrame rendered = session_.render(slot, view, request);
        Panel panel;
        if (stage && stage->key.id == "outside") { // a picture of its own, no band of a larger one
            cell.pictureSize = {cell.width, cell.height};
            cell.cropX = 0;
        }
        if (stage && !stage->isPass && isDerived(stage->key.id)) {
            panel = derivedPanel(session_, slot, rendered, encoder_,
                                 {stage->key, view, std::nullopt, &font_, std::nullopt, cell.pictureSize});
        } else if (stage && !stage->isPass) {
            const Stage& published = findStage(rendered, stage->key);
            panel.kind = stageInfo(*slot.info, published.key.id).kind;
            panel.picture = encoder_.encode(published, panel.kind, state_.scene->exposure);
            panel.display = published.display;
        } else {
            if (stage) requirePassRan(rendered, stage->key, *slot.info);
            panel.picture = encoder_.encode(slot.target.color, state_.scene->exposure);
        }
        if (slots_.size() > 1) panel.title = slot.info->title;
        return panel;
    }

    Panel difference() {
        View view;
        view.camera = state_.camera;
        view.size = size_;
        std::array<measure::Judgement, 2> judgements;
        for (std::size_t i = 0; i < judgements.size(); ++i) {
            FrameRequest request;
            request.stages = {{"visibility", state_.light}};
            const RenderedFrame rendered = session_.render(slots_[i], view, request);
            judgements[i] = measure::judge(session_.truth(view, session_.truthFor(slots_[i], state_.light)),
                                           readVisibility(findStage(rendered, request.stages[0])).greyAlpha);
        }
        return differencePanel(encoder_.encode(slots_[0].target.color, state_.scene->exposure),
                               {&judgements[0], &judgements[1]},
                               {std::string(slots_[0].info->title), std::string(slots_[1].info->title)});
    }

    const LessonState& state_;
    ivec2 size_;
    const image::Font& font_;
    Session session_;
    PictureEncoder encoder_;
    std::vector<Slot> slots_;
};

void drawBoxOutline(image::Image& figure, ivec2 corner, ivec2 size, int width, image::Color8 color) {
    fillRect(figure, corner.x, corner.y, size.x, width, color);
    fillRect(figure, corner.x, corner.y + size.y - width, size.x, width, color);
    fillRect(figure, corner.x, corner.y, width, size.y, color);
    fillRect(figure, corner.x + size.x - width, corner.y, width, size.y, color);
}

} // namespace

image::Image drawState(const LessonState& state, ivec2 size, const image::Font& font) {
    return StatePicture(state, size, font).draw();
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
        const Plate plate = titlePlate(share.label, font, em, size.x / 2);
        int y = corner.y - line - plate.height;
        if (y < 0) y = corner.y + extent.y + line;
        if (y + plate.height > size.y) y = corner.y + line;
        drawPlate(picture, plate, std::clamp(corner.x, 0, std::max(0, size.x - plate.width)), y);
    }
}

} // namespace shadowlab::session
