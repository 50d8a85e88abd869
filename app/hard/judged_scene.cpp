// SPDX-License-Identifier: MIT
#include "app/hard/judged_scene.h"

#include <algorithm>

#include "techniques/foundation/error.h"

namespace shadowlab::hard {

JudgedScene::JudgedScene(const session::ShownState& state, ivec2 size) : session_(state.scene), light_(state.light) {
    view_.camera = state.camera;
    view_.size = size;
}

JudgedFrame JudgedScene::draw(const session::PaneState& technique) {
    std::vector<session::Slot> slots = session::slotsOf({technique});
    session::Slot& slot = slots.front();
    const auto publishes = [&](std::string_view stage) {
        return std::ranges::find(slot.info->stages, stage, &StageInfo::id) != slot.info->stages.end();
    };
    if (!publishes("visibility"))
        throw Error(ExitStatus::badInput,
                    "'" + technique.technique +
                        "' does not say what it makes of one light, so no hard case can judge it; "
                        "choose another technique");
    FrameRequest request;
    request.stages = {{"visibility", light_}};
    if (publishes("texel-size")) request.stages.push_back({"texel-size", light_});
    const session::RenderedFrame rendered = session_.render(slot, view_, request);
    JudgedFrame frame;
    frame.ms = rendered.frameMs;
    frame.picture = encoder_.encode(slot.target.color, session_.snapshot()->exposure);
    frame.visibility = session::readVisibility(session::findStage(rendered, {"visibility", light_}));
    std::optional<measure::Grid<float>> texelPx;
    if (publishes("texel-size"))
        texelPx = session::readTexelSizes(session::findStage(rendered, {"texel-size", light_}));
    const measure::Truth& truth = session_.truth(view_, session_.truthFor(slot, light_));
    const std::vector<measure::BoundaryEdge> boundary = measure::trueBoundary(truth);
    frame.errors = measure::judgeSlot(truth, boundary, frame.visibility.greyAlpha);
    frame.coreErrors =
        measure::coreErrors(truth, frame.errors.judgement, measure::distanceToBoundary(boundary, view_.size), texelPx);
    return frame;
}

} // namespace shadowlab::hard
