// SPDX-License-Identifier: MIT
#include "app/hard/judged_scene.h"

#include "app/film/motion.h"
#include "app/report/judge.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::hard {

JudgedScene::JudgedScene(const course::ShownState& state, ivec2 size) : session_(state.scene), light_(state.light) {
    view_.camera = state.camera;
    view_.size = size;
}

JudgedFrame JudgedScene::draw(const lab::PaneState& technique, Timing timing) {
    std::vector<picture::Slot> slots = course::slotsOf({technique});
    picture::Slot& slot = slots.front();
    if (!publishes(*slot.info, kVisibilityStage))
        throw Error(ExitStatus::badInput,
                    "'" + technique.technique +
                        "' does not say what it makes of one light, so no hard case can judge it; "
                        "choose another technique");
    FrameRequest request;
    request.stages = {{"visibility", light_}};
    if (publishes(*slot.info, kTexelSizeStage)) request.stages.push_back({"texel-size", light_});
    const picture::RenderedFrame rendered = session_.render(slot, view_, request);
    JudgedFrame frame;
    frame.ms = rendered.frameMs;
    for (const Counter& counter : rendered.result.counters)
        if (counter.id == "served" && counter.of > 0) frame.served = counter.built / counter.of;
    frame.picture = encoder_.encode(slot.target.color, session_.snapshot()->exposure);
    frame.visibility = picture::readVisibility(picture::findStage(rendered, {"visibility", light_}));
    std::optional<judge::Grid<float>> texelPx;
    if (publishes(*slot.info, kTexelSizeStage))
        texelPx = picture::readTexelSizes(picture::findStage(rendered, {"texel-size", light_}));
    const judge::Truth& truth = session_.truth(view_, session_.truthFor(slot, light_));
    const std::vector<judge::BoundaryEdge> boundary = judge::trueBoundary(truth);
    frame.errors = judge::judgeSlot(truth, boundary, frame.visibility.greyAlpha);
    frame.coreErrors =
        judge::coreErrors(truth, frame.errors.judgement, judge::distanceToBoundary(boundary, view_.size), texelPx);
    frame.errorMap = report::errorMap(truth, frame.errors.judgement);
    if (timing == Timing::again) frame.ms = msWithLightMoved(slot);
    return frame;
}

double JudgedScene::msWithLightMoved(picture::Slot& slot) {
    const scene::Snapshot atRest = session_.snapshot();
    const film::Motion turn{.frames = 360, .orbitLightDegrees = 360.0, .orbitCameraDegrees = {}, .path = {}};
    session_.setScene(film::momentAt(turn, atRest, 1).snapshot);
    const double ms = session_.render(slot, view_).frameMs;
    session_.setScene(atRest);
    return ms;
}

} // namespace shadowlab::hard
