// SPDX-License-Identifier: MIT
#include "app/picture/judged_slot.h"

#include <utility>

#include "app/picture/stage_ref.h"

namespace shadowlab::picture {

namespace {

StageKey texelSizeOf(int light) { return {std::string(kTexelSizeStage), light}; }

} // namespace

FrameRequest requestAnswers(const TechniqueInfo& info, int light) {
    FrameRequest request;
    request.stages = {visibilityOf(light)};
    if (publishes(info, kTexelSizeStage)) request.stages.push_back(texelSizeOf(light));
    return request;
}

Answers readAnswers(const TechniqueInfo& info, const RenderedFrame& rendered, int light) {
    Answers answers{readVisibility(findStage(rendered, visibilityOf(light))), std::nullopt};
    if (publishes(info, kTexelSizeStage)) answers.texelPx = readTexelSizes(findStage(rendered, texelSizeOf(light)));
    return answers;
}

double servedShare(const RenderedFrame& rendered) {
    double served = 1;
    for (const Counter& counter : rendered.result.counters)
        if (counter.id == "served" && counter.of > 0) served = counter.built / counter.of;
    return served;
}

AnswerErrors judgeAnswers(const Answers& answers, const judge::Truth& truth,
                          const std::vector<judge::BoundaryEdge>& boundary) {
    judge::SlotErrors errors = judge::slotErrors(truth, boundary, answers.visibility.greyAlpha);
    const int core = judge::coreErrors(truth, errors.judgement, judge::distanceToBoundary(boundary, truth.size), answers.texelPx);
    return {std::move(errors), core};
}

JudgedSlot judgeSlot(Session& session, Slot& slot, const View& view, int light) {
    RenderedFrame rendered = session.render(slot, view, requestAnswers(*slot.info, light));
    Answers answers = readAnswers(*slot.info, rendered, light);
    const LightTruth asked = session.truthFor(slot, light);
    const judge::Truth& truth = session.truth(view, asked);
    AnswerErrors found = judgeAnswers(answers, truth, judge::trueBoundary(truth));
    return {std::move(rendered), std::move(answers), asked, truth, std::move(found)};
}

} // namespace shadowlab::picture
