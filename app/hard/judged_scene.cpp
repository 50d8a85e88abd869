// SPDX-License-Identifier: MIT
#include "app/hard/judged_scene.h"

#include <algorithm>

#include "app/report/judge.h"
#include "app/session/motion.h"
#include "techniques/foundation/error.h"

namespace shadowlab::hard {

JudgedScene::JudgedScene(const session::ShownState& state, ivec2 size) : session_(state.scene), light_(state.light) {
    view_.camera = state.camera;
    view_.size = size;
}

JudgedFrame JudgedScene::draw(const session::PaneState& technique, Timing timing) {
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
    for (const Counter& counter : rendered.result.counters)
        if (counter.id == "served" && counter.of > 0) frame.served = counter.built / counter.of;
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
    frame.errorMap = report::errorMap(truth, frame.errors.judgement);
    if (timing == Timing::again) frame.ms = msWithLightMoved(slot);
    return frame;
}

double JudgedScene::msWithLightMoved(session::Slot& slot) {
    const scene::Snapshot atRest = session_.snapshot();
    const session::Motion turn{.frames = 360, .orbitLightDegrees = 360.0, .orbitCameraDegrees = {}, .path = {}};
    session_.setScene(session::momentAt(turn, atRest, 1).snapshot);
    const double ms = session_.render(slot, view_).frameMs;
    session_.setScene(atRest);
    return ms;
}

} // namespace shadowlab::hard
