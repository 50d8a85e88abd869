// SPDX-License-Identifier: MIT
#include "app/lab/stage_strip.h"

#include <algorithm>
#include <chrono>

#include "app/picture/derived_stages.h"

namespace shadowlab::lab {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWrongPixelWidth = 3; ///< of a wrong pixel that stands alone: one pixel of a thumbnail is hardly seen
constexpr int kFiner = 2; ///< samples of a thumbnail's pixel in each direction: small pictures of edges need it

// Some stages share work, as the pictures from the light share a map, so a frame of several is cheaper than several frames. But while
// a frame is drawn the window does not answer. So the number of stages doubles as long as frames are shorter than this, and begins
// again with one after a longer one.
constexpr std::chrono::milliseconds kQuickFrame{100};

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
    picture::Slot& slot = pane_.slotFor(request.state);
    if (request != drawnFor_) begin(slot, request);
    isFinished_ = true; // also where the next lines throw
    session.setScene(request.snapshot);
    do
        isFinished_ = draw(session, encoder, request, slot, deadline);
    while (!isFinished_ && Clock::now() < deadline);
    return true;
}

/// All thumbnails by name. Those of the same technique keep their pictures until they have new ones.
void StageStrip::begin(const picture::Slot& slot, const PaneRequest& request) {
    const bool sameTechnique = request.state.technique == drawnFor_.state.technique;
    std::vector<Thumbnail> before = std::move(thumbnails_);
    thumbnails_.clear();
    drawnFor_ = request;
    thumbnails_.push_back({{}, "the finished picture", {}, true});
    const bool hasLights = !request.snapshot->lights.empty();
    for (const StageInfo& stage : slot.info->stages)
        if (!stage.perLight || hasLights)
            thumbnails_.push_back({{std::string(stage.id)}, std::string(stage.caption), {}, true});
    own_ = thumbnails_.size();
    for (const StageInfo& stage : picture::stagesOf(*slot.info))
        if (picture::isDerived(stage.id) && (!stage.perLight || hasLights))
            thumbnails_.push_back({{std::string(stage.id)}, std::string(stage.caption), {}, true});
    for (Thumbnail& thumbnail : thumbnails_) {
        const auto old = std::ranges::find(before, thumbnail.stage, &Thumbnail::stage);
        if (sameTechnique && old != before.end()) thumbnail.picture = std::move(old->picture);
    }
    next_ = 0;
    atOnce_ = 1;
    takesLong_ = false;
    progress_ = 0;
}

/// One frame. False when the technique has more to prepare or to refine, or there are more stages.
bool StageStrip::draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                      Deadline deadline) {
    if (next_ >= own_) return drawDerived(session, encoder, request, slot, deadline);
    const float exposure = request.snapshot->exposure;
    const ivec2 size = request.view.size / kFiner;
    // Where one frame is not enough, the next ones go on with its work: all stages are made of it, and no ray is traced twice.
    const std::size_t last = takesLong_ ? own_ : std::min(own_, next_ + atOnce_);
    FrameRequest frame;
    frame.deadline = deadline;
    for (std::size_t i = std::max<std::size_t>(next_, 1); i < last; ++i) {
        const std::string& id = thumbnails_[i].stage.id;
        frame.stages.push_back({id, picture::stageInfo(*slot.info, id).perLight ? request.light : kNoLight});
    }
    const Clock::time_point start = Clock::now();
    const picture::RenderedFrame rendered = session.render(slot, request.view, frame);
    progress_ = rendered.prepared < 1 ? rendered.prepared : rendered.drawn;
    takesLong_ = takesLong_ || !rendered.converged;
    const auto isThere = [&](const StageKey& stage) { return picture::isPublished(rendered, stage); };
    if (!rendered.converged && (rendered.prepared < 1 || !std::ranges::all_of(frame.stages, isThere))) return false; // not yet
    for (std::size_t i = next_; i < last; ++i) {
        Thumbnail& thumbnail = thumbnails_[i];
        if (i == 0) {
            thumbnail.picture = {encoder.encodeInPlace(slot.target.color, exposure, kFiner), {}, {}, ""};
        } else {
            const Stage& published = picture::findStage(rendered, frame.stages[i - std::max<std::size_t>(next_, 1)]);
            const StageInfo& info = picture::stageInfo(*slot.info, published.key.id);
            thumbnail.picture = {
                encoder.encodeInPlace(published, info.kind, exposure, reduction(published.texture.size(), size), &slot.target.color),
                info.kind, published.display, ""};
        }
        thumbnail.isToCome = !rendered.converged;
    }
    if (!rendered.converged) return false;
    next_ = last;
    atOnce_ = Clock::now() - start < kQuickFrame ? 2 * atOnce_ : 1;
    return next_ == thumbnails_.size();
}

/// One of the stages that the session derives, for the pixels of the small picture: they are about single pixels. The tree for their
/// rays is built slice by slice.
bool StageStrip::drawDerived(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request,
                             picture::Slot& slot, Deadline deadline) {
    progress_ = session.prepareTruth(deadline);
    if (progress_ < 1) return false;
    Thumbnail& thumbnail = thumbnails_[next_];
    View view = request.view;
    view.size = request.view.size / kFiner;
    const StageKey key{thumbnail.stage.id, request.snapshot->lights.empty() ? kNoLight : request.light};
    FrameRequest frame;
    frame.stages = picture::neededFor(key);
    frame.deadline = deadline;
    const picture::RenderedFrame rendered = session.render(slot, view, frame);
    progress_ = rendered.prepared < 1 ? rendered.prepared : rendered.drawn;
    if (!rendered.converged) return false;
    const picture::Panel panel = picture::derivedPanel(session, slot, rendered, encoder,
                                                       {.stage = key,
                                                        .view = view,
                                                        .row = {},
                                                        .outside = request.outsideCamera,
                                                        .outsideSize = view.size,
                                                        .markWidth = kWrongPixelWidth,
                                                        .outsideChoice = request.outsideChoice});
    thumbnail.picture = {textureOf(panel.picture), panel.kind, panel.display, ""};
    thumbnail.isToCome = false;
    return ++next_ == thumbnails_.size();
}

} // namespace shadowlab::lab
