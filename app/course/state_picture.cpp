// SPDX-License-Identifier: MIT
#include "app/course/state_picture.h"

#include <array>

#include "app/picture/derived_stages.h"
#include "app/picture/difference_panel.h"
#include "app/picture/picture.h"
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
        const bool derived = stage.isDerived();
        const int supersample = derived ? 1 : request_.supersample; // what is derived is about single pixels
        View view;
        view.camera = state_.camera;
        view.size = cell.pictureSize * supersample;
        view.region = {ivec2(cell.cropX, 0) * supersample, ivec2(cell.width, cell.height) * supersample};
        if (picture::followsPicked(*slot.info, stage.key.id)) {
            if (request_.picked) view.picked = lab::pixelAt(*request_.picked, view.size);
            if (request_.partner) view.partner = lab::pixelAt(*request_.partner, view.size);
        }
        FrameRequest request;
        if (stage.isPass) request.stopAfter = stage.key;
        if (stage.isStage()) request.stages = picture::neededFor(stage.key);
        const picture::RenderedFrame rendered = session_.render(slot, view, request);
        picture::Panel panel;
        if (stage.isOutside()) { // a picture of its own, no band of a larger one
            cell.pictureSize = {cell.width, cell.height};
            cell.cropX = 0;
        }
        if (derived) {
            panel = picture::derivedPanel(session_, slot, rendered, encoder_,
                                 {stage.key, view, std::nullopt, &font_, request_.outside, cell.pictureSize});
        } else if (stage.isStage()) {
            const Stage& published = picture::findStage(rendered, stage.key);
            panel.kind = picture::stageInfo(*slot.info, published.key.id).kind;
            // A stage of a size of its own (a light's view of the scene) is averaged only if it would not fit otherwise.
            const bool fits = glm::all(glm::lessThanEqual(published.texture.size(), cell.pictureSize));
            panel.picture = encoder_.encode(published, panel.kind, state_.scene->exposure, fits ? 1 : supersample);
            panel.display = published.display;
        } else {
            if (stage.isPass) picture::requirePassRan(rendered, stage.key, *slot.info);
            panel.picture = encoder_.encode(slot.target.color, state_.scene->exposure, supersample);
        }
        if (slots_.size() > 1) panel.title = slot.info->title;
        return panel;
    }

    picture::Panel difference() {
        View view;
        view.camera = state_.camera;
        view.size = request_.size;
        std::array<judge::Judgement, 2> judgements;
        for (std::size_t i = 0; i < judgements.size(); ++i) {
            FrameRequest request;
            request.stages = {picture::visibilityOf(state_.light)};
            const picture::RenderedFrame rendered = session_.render(slots_[i], view, request);
            judgements[i] = judge::judge(session_.truth(view, session_.truthFor(slots_[i], state_.light)),
                                           picture::readVisibility(picture::findStage(rendered, request.stages[0])).greyAlpha);
        }
        return picture::differencePanel(encoder_.encode(slots_[0].target.color, state_.scene->exposure),
                               {&judgements[0], &judgements[1]},
                               {std::string(slots_[0].info->title), std::string(slots_[1].info->title)});
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
