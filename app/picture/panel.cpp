// SPDX-License-Identifier: MIT
#include "app/picture/panel.h"

#include <utility>

#include "app/picture/derived_stages.h"
#include "app/picture/steps/step_lift.h"

namespace shadowlab::picture {

FrameRequest frameFor(const ResolvedStage& stage) {
    FrameRequest frame;
    if (stage.isPass) frame.stopAfter = stage.key;
    if (stage.isStage()) frame.stages = neededFor(stage.key);
    return frame;
}

StageLook lookOf(const ResolvedStage& stage, const TechniqueInfo& info, const RenderedFrame& rendered) {
    if (!stage.isStage()) return {};
    StageLook look{StageKind::swatches, {}, captionOf(info, stage.key.id)};
    if (stage.isDerived()) return look;
    look.kind = stageInfo(info, stage.key.id).kind;
    look.display = findStage(rendered, stage.key).display;
    return look;
}

View viewOf(const Cell& cell, const TechniqueInfo& info, const PanelRequest& request) {
    View view;
    view.camera = request.camera;
    view.size = cell.pictureSize * request.supersample;
    view.region = {ivec2(cell.cropX, 0) * request.supersample, ivec2(cell.width, cell.height) * request.supersample};
    if (followsPicked(info, request.stage.key.id)) {
        view.picked = request.picked;
        view.partner = request.partner;
    }
    return view;
}

RenderedPanel renderPanel(Session& session, Slot& slot, const PictureEncoder& encoder, Cell& cell,
                          const PanelRequest& request) {
    const ResolvedStage& stage = request.stage;
    const View view = viewOf(cell, *slot.info, request);
    FrameRequest frame = frameFor(stage);
    const bool isWholeFrame = !stage.isStage() && !stage.isPass;
    if (isWholeFrame && request.supersample == 1) frame.finished = &slot.finished;
    frame.timePasses = request.timePasses;
    RenderedFrame rendered = session.render(slot, view, frame);
    if (stage.isOutside()) {
        cell.pictureSize = {cell.width, cell.height};
        cell.cropX = 0;
    }
    if (stage.isDerived()) {
        Panel panel = derivedPanel(session, slot, rendered, encoder,
                                   {stage.key, view, request.row, request.font, request.outside, cell.pictureSize, request.markWidth,
                                    request.outsideChoice, request.typeHeight});
        return {std::move(panel), std::move(rendered)};
    }
    if (stage.isPass) requirePassRan(rendered, stage.key, *slot.info);
    const float exposure = session.snapshot()->exposure;
    if (request.range && stage.isStage())
        for (Stage& published : rendered.result.stages)
            if (published.key == stage.key) {
                published.display.minimum = request.range->x;
                published.display.maximum = request.range->y;
            }
    StageLook look = lookOf(stage, *slot.info, rendered);
    Panel panel{{}, "", look.kind, std::move(look.display)};
    if (stage.isStage()) {
        const Stage& published = findStage(rendered, stage.key);
        // A stage of a size of its own (a light's view of the scene) is averaged only if it would not fit otherwise.
        const bool fits = glm::all(glm::lessThanEqual(published.texture.size(), cell.pictureSize));
        panel.picture = encoder.encode(published, look.kind, exposure, fits ? 1 : request.supersample, &slot.target.color);
    } else if (rendered.result.isFinished) {
        panel.picture = PictureEncoder::read(slot.finished.color);
    } else {
        const bool isLifted = stage.isPass && request.liftsSteps;
        const int lift = isLifted ? stepLift(slot.target.color, view.region, *session.snapshot()) : 1;
        panel.picture = encoder.encode(slot.target.color, exposure * static_cast<float>(lift), request.supersample);
        panel.note = liftNote(lift);
    }
    return {std::move(panel), std::move(rendered)};
}

} // namespace shadowlab::picture
