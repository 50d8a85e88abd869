// SPDX-License-Identifier: MIT
#include "app/lab/stage_strip.h"

#include <algorithm>

#include "app/picture/derived_stages.h"

namespace shadowlab::lab {

namespace {

constexpr int kFiner = 2; ///< samples of a thumbnail's pixel in each direction: small pictures of edges need it

/// How many texels of a stage go into a pixel of its thumbnail.
int reduction(ivec2 stage, ivec2 thumbnail) {
    return std::max(1, std::min(stage.x / thumbnail.x, stage.y / thumbnail.y));
}

} // namespace

bool StageStrip::update(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& pane, ivec2 size,
                        Deadline deadline) {
    PaneRequest request = pane;
    request.state.stage = {};
    request.view.size = size * kFiner;
    request.view.region = {};
    request.view.picked.reset(); // a pixel of a larger picture
    request.view.partner.reset();
    if (request == drawnFor_ && isFinished_) return false;
    if (request != drawnFor_) thumbnails_.clear();
    drawnFor_ = request;
    isFinished_ = true; // also where the next line throws
    session.setScene(request.snapshot);
    isFinished_ = draw(session, encoder, request, pane_.slotFor(request.state), deadline);
    return true;
}

/// False when the technique has more to prepare, or its picture to be refined.
bool StageStrip::draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                      Deadline deadline) {
    const scene::Scene& scene = *request.snapshot;
    const ivec2 size = request.view.size / kFiner;
    FrameRequest frame;
    frame.deadline = deadline;
    for (const StageInfo& stage : slot.info->stages)
        if (!stage.perLight || !scene.lights.empty())
            frame.stages.push_back({std::string(stage.id), stage.perLight ? request.light : kNoLight});
    const picture::RenderedFrame rendered = session.render(slot, request.view, frame);
    if (!rendered.converged && rendered.prepared < 1) return false; // nothing is drawn yet
    thumbnails_.clear();
    thumbnails_.push_back(
        {{}, "the finished picture", {encoder.encodeInPlace(slot.target.color, scene.exposure, kFiner), {}, {}, ""}});
    for (const StageKey& key : frame.stages) {
        const Stage& published = picture::findStage(rendered, key);
        const StageInfo& info = picture::stageInfo(*slot.info, key.id);
        thumbnails_.push_back(
            {{key.id},
             std::string(info.caption),
             {encoder.encodeInPlace(published, info.kind, scene.exposure, reduction(published.texture.size(), size)),
              info.kind, published.display, ""}});
    }
    // What the session derives is exact and slow, or from elsewhere: it is named here and drawn when it is chosen.
    for (const StageInfo& stage : picture::stagesOf(*slot.info))
        if (picture::isDerived(stage.id) && (!stage.perLight || !scene.lights.empty()))
            thumbnails_.push_back({{std::string(stage.id)}, std::string(stage.caption), {}});
    return rendered.converged;
}

} // namespace shadowlab::lab
