// SPDX-License-Identifier: MIT
#include "app/course/state_picture.h"

#include "app/picture/difference_panel.h"
#include "app/picture/panel.h"
#include "app/picture/steps/stepping.h"

namespace shadowlab::course {

namespace {

class StatePicture {
public:
    StatePicture(const ShownState& state, const StateRequest& request, const image::Font& font)
        : state_(state), request_(request), font_(font), session_(state.scene), slots_(slotsOf(state.slots)) {}

    image::Image draw() {
        std::vector<picture::Cell> cells =
            picture::layoutCells(state_.layout, static_cast<int>(slots_.size()), request_.size, state_.split);
        std::vector<picture::Panel> panels;
        if (state_.layout == picture::Layout::diff)
            panels.push_back(difference());
        else
            for (std::size_t i = 0; i < slots_.size(); ++i)
                panels.push_back(panel(i, cells[i]));
        return picture::composeFigure(cells, panels, request_.size, &font_, request_.typeHeight, request_.roomBelow).picture;
    }

private:
    picture::Panel panel(std::size_t i, picture::Cell& cell) {
        picture::Slot& slot = slots_[i];
        const picture::ResolvedStage stage = picture::shownInStep( // as the window shows a step
            picture::resolve(state_.slots[i].stage, *slot.info, *state_.scene, state_.light), *slot.info,
            picture::stageLight(*state_.scene, state_.light));
        picture::PanelRequest request;
        request.stage = stage;
        request.camera = state_.camera;
        request.supersample = stage.isDerived() ? 1 : request_.supersample;
        const ivec2 samples = cell.pictureSize * request.supersample;
        if (request_.picked) request.picked = lab::pixelAt(*request_.picked, samples);
        if (request_.partner) request.partner = lab::pixelAt(*request_.partner, samples);
        request.outside = request_.outside;
        request.font = &font_;
        request.markWidth = markWidth();
        picture::Panel panel = picture::renderPanel(session_, slot, encoder_, cell, request).panel;
        if (slots_.size() > 1) panel.title = slot.info->title;
        return panel;
    }

    picture::Panel difference() {
        View view;
        view.camera = state_.camera;
        view.size = request_.size;
        return picture::renderDifference(session_, slots_, encoder_, view, state_.light, markWidth()).panel;
    }

    /// By the whole that the picture is a part of: a slide is seen as a whole.
    [[nodiscard]] int markWidth() const {
        return picture::wideMark(request_.typeHeight > 0 ? request_.typeHeight : request_.size.y);
    }

    const ShownState& state_;
    const StateRequest& request_;
    const image::Font& font_;
    picture::Session session_;
    picture::PictureEncoder encoder_;
    std::vector<picture::Slot> slots_;
};

} // namespace

image::Image drawState(const ShownState& state, const StateRequest& request, const image::Font& font) {
    return StatePicture(state, request, font).draw();
}

} // namespace shadowlab::course
