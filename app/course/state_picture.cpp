// SPDX-License-Identifier: MIT
#include "app/course/state_picture.h"

#include "app/picture/difference_panel.h"
#include "app/picture/panel.h"
#include "app/picture/steps/stepping.h"

namespace shadowlab::course {

namespace {

/// Of what is looked at as one.
int wholeHeight(const StateRequest& request) { return request.wholeHeight > 0 ? request.wholeHeight : request.size.y; }

} // namespace

StatePicture::StatePicture(const ShownState& state, const image::Font& font)
    : state_(state), font_(font), session_(state.scene), slots_(slotsOf(state.slots)) {}

StatePicture::Parts StatePicture::draw(const StateRequest& request) {
    Parts parts{picture::layoutCells(state_.layout, static_cast<int>(slots_.size()), request.size, state_.split), {}};
    if (state_.layout == picture::Layout::diff)
        parts.panels.push_back(difference(request));
    else
        for (std::size_t i = 0; i < slots_.size(); ++i)
            parts.panels.push_back(panel(request, i, parts.cells[i]));
    return parts;
}

picture::Panel StatePicture::panel(const StateRequest& wanted, std::size_t i, picture::Cell& cell) {
    picture::Slot& slot = slots_[i];
    const picture::ResolvedStage stage = picture::shownInStep( // as the window shows a step
        picture::resolve(state_.slots[i].stage, *slot.info, *state_.scene, state_.light), *slot.info,
        picture::stageLight(*state_.scene, state_.light));
    picture::PanelRequest request;
    request.stage = stage;
    request.camera = state_.camera;
    request.supersample = stage.isDerived() ? 1 : wanted.supersample;
    const ivec2 samples = cell.pictureSize * request.supersample;
    if (wanted.picked) request.picked = lab::pixelAt(*wanted.picked, samples);
    if (wanted.partner) request.partner = lab::pixelAt(*wanted.partner, samples);
    request.outside = wanted.outside;
    request.outsideChoice = wanted.outsideChoice;
    request.range = wanted.range;
    request.font = &font_;
    request.liftsSteps = true;
    request.markWidth = picture::wideMark(wholeHeight(wanted));
    request.typeHeight = wholeHeight(wanted);
    picture::Panel panel = picture::renderPanel(session_, slot, encoder_, cell, request).panel;
    if (slots_.size() > 1) panel.title = slot.info->title;
    if (!panel.note.empty()) panel.title += (panel.title.empty() ? "" : ", ") + panel.note;
    return panel;
}

picture::Panel StatePicture::difference(const StateRequest& request) {
    View view;
    view.camera = state_.camera;
    view.size = request.size;
    return picture::renderDifference(session_, slots_, encoder_, view, state_.light, picture::wideMark(wholeHeight(request))).panel;
}

image::Image drawState(const ShownState& state, const StateRequest& request, const image::Font& font) {
    const StatePicture::Parts parts = StatePicture(state, font).draw(request);
    return picture::composeFigure(parts.cells, parts.panels, request.size, &font).picture;
}

} // namespace shadowlab::course
