// SPDX-License-Identifier: MIT
#include "app/hard/judged_scene.h"

#include <utility>

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
    picture::JudgedSlot judged = picture::judgeSlot(session_, slot, view_, light_);
    JudgedFrame frame;
    frame.ms = judged.rendered.frameMs;
    frame.served = picture::servedShare(judged.rendered);
    frame.picture = encoder_.encode(slot.target.color, session_.snapshot()->exposure);
    frame.errorMap = report::errorMap(judged.truth, judged.found.errors.judgement);
    frame.visibility = std::move(judged.answers.visibility);
    frame.errors = std::move(judged.found.errors);
    frame.coreErrors = judged.found.core;
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
