// SPDX-License-Identifier: MIT
#include "app/lab/pane.h"

#include <algorithm>

#include "app/picture/derived_stages.h"
#include "app/picture/panel.h"
#include "app/picture/steps/step_lift.h"
#include "app/picture/steps/stepping.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::lab {

namespace {

/// Of the driver and of bad input, as a sentence; a technique that breaks must not take the window with it.
template <typename Work>
std::string failureOf(const Work& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        return failure.what();
    }
    return {};
}

/// The steps of the algorithm: what was done again to publish a stage is no further step.
std::vector<StageKey> distinct(const std::vector<StageKey>& passes) {
    std::vector<StageKey> once;
    for (const StageKey& pass : passes)
        if (std::ranges::find(once, pass) == once.end()) once.push_back(pass);
    return once;
}

} // namespace

const Values& PaneState::values() const {
    static const Values none;
    const auto found = settings.find(technique);
    return found == settings.end() ? none : found->second;
}

bool operator==(const PaneRequest& a, const PaneRequest& b) {
    const bool outside = a.state.stage.isOutside();
    const bool isAboutPicked =
        !a.state.technique.empty() && picture::windowFollowsPicked(findTechnique(a.state.technique), a.state.stage);
    return a.state.technique == b.state.technique && a.state.stage == b.state.stage &&
           a.state.values() == b.state.values() && a.snapshot == b.snapshot && a.view.camera == b.view.camera &&
           a.view.size == b.view.size && a.view.region.corner == b.view.region.corner &&
           a.view.region.size == b.view.region.size && a.light == b.light &&
           (!outside || (a.outsideCamera == b.outsideCamera && a.outsideSize == b.outsideSize &&
                       a.outsideChoice == b.outsideChoice && a.outsideType == b.outsideType && a.draft == b.draft)) &&
           (!isAboutPicked || (a.view.picked == b.view.picked && a.view.partner == b.view.partner));
}

picture::Slot& Pane::slotFor(const PaneState& state) {
    auto found = slots_.find(state.technique);
    if (found == slots_.end()) found = slots_.emplace(state.technique, picture::Session::makeSlot(state.technique)).first;
    picture::Slot& slot = found->second;
    const Values& values = state.values();
    for (params::Param& param : slot.params) {
        const auto value = values.find(param.id);
        params::setFromText(param, value == values.end() ? params::initialText(param) : value->second, state.technique);
    }
    return slot;
}

judge::TruthOf Pane::judgedBy() const {
    const auto found = slots_.find(drawnFor_.state.technique);
    const int light = drawnFor_.light;
    const bool known = found != slots_.end() && drawnFor_.snapshot && light >= 0 &&
                       light < static_cast<int>(drawnFor_.snapshot->lights.size());
    const bool area = known && found->second.technique->samplesArea(*drawnFor_.snapshot, light);
    return area ? judge::TruthOf::area : judge::TruthOf::centre;
}

std::optional<Probe> Pane::probe(const View& view) {
    // Samples may still be added to the picture; from outside a pane draws only what is ready.
    const bool isReady = converged_ || (progress_ >= 1 && !drawnFor_.state.stage.isOutside());
    if (!view.picked || !isReady || !failure_.empty() || !drawnFor_.snapshot) return std::nullopt;
    const int light = drawnFor_.snapshot->lights.empty() ? kNoLight : drawnFor_.light;
    return slotFor(drawnFor_.state).technique->probe(drawnFor_.snapshot, view, *view.picked, light);
}

gl::Texture2D textureOf(const image::Image& image) {
    const ivec2 size(image.width, image.height);
    gl::Texture2D texture(GL_RGBA8, size, "derived stage");
    std::vector<image::Color8> fromBelow(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            fromBelow[static_cast<std::size_t>(size.y - 1 - y) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(x)] = image.at(x, y);
    texture.bind(0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, fromBelow.data());
    return texture;
}

bool Pane::showsTheEyesView() const {
    const picture::StageRef& stage = drawnFor_.state.stage;
    if (!picture_.texture || picture_.texture.size() != drawnFor_.view.size || stage.isOutside()) return false;
    const auto& stages = findTechnique(drawnFor_.state.technique).stages;
    return stage.isPass || std::ranges::none_of(stages, [&](const StageInfo& one) { return one.isElsewhere && one.id == stage.id; });
}

bool Pane::showsAnother() const {
    const PaneState& asked = drawnFor_.state;
    return picture_.texture && drawnFor_.snapshot &&
           (drawn_.technique != asked.technique || drawn_.stage != asked.stage || drawnScene_ != drawnFor_.snapshot->name);
}

const Stage* Pane::visibility(int light) const {
    // Pixels without an answer yet would count as wrong. Shares of a light's area come last, when the picture is whole already.
    const bool isWhole = converged_ || (drawnShare() >= 1 && judgedBy() == judge::TruthOf::centre);
    if (!isDrawn_ || !isWhole) return nullptr;
    const auto found = std::ranges::find(rendered_.result.stages, picture::visibilityOf(light), &Stage::key);
    return found == rendered_.result.stages.end() ? nullptr : &*found;
}

bool Pane::update(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, const PaneWork& work) {
    const bool answered = !work.visibility || visibility(request.light) || !failure_.empty();
    const bool timed = !work.timePasses || timed_ || !failure_.empty();
    if (request == drawnFor_ && answered && timed && (converged_ || !failure_.empty())) return false;
    // Asked for before the work: what failed is not tried again until something changes.
    const bool sizeChanged = request.view.size != drawnFor_.view.size;
    // Drawn again for its times or its answers, a picture that is whole stays until it is whole again.
    if (request != drawnFor_)
        hasWhole_ = false;
    else if (isDrawn_ && converged_)
        hasWhole_ = true;
    isDrawn_ = isDrawn_ && request == drawnFor_;
    drawnFor_ = request;
    timed_ = work.timePasses;
    failure_ = failureOf([&] { draw(session, encoder, request, work); });
    if (!failure_.empty() && sizeChanged) picture_ = {}; // stretched to another size it would be no picture of anything
    return true;
}

void Pane::draw(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, const PaneWork& work) {
    picture::Slot& slot = slotFor(request.state);
    const scene::Scene& scene = *request.snapshot;
    const picture::ResolvedStage asked = picture::resolve(request.state.stage, *slot.info, scene, request.light);
    const picture::ResolvedStage stage =
        picture::shownInStep(asked, *slot.info, picture::stageLight(scene, request.light));

    FrameRequest frame = picture::frameFor(stage);
    if (stage.isDerived()) frame.stages.clear(); // the verdicts are found in the background, which asks for answers itself
    if (!stage.isStage() && !stage.isPass) frame.finished = &finished_;
    frame.timePasses = frame.waitForGl = work.timePasses;
    frame.deadline = work.deadline;
    frame.refine = work.refine;
    const StageKey answers = picture::visibilityOf(request.light);
    if (work.visibility && publishes(*slot.info, answers.id) && !frame.stopAfter &&
        std::ranges::find(frame.stages, answers) == frame.stages.end())
        frame.stages.push_back(answers);

    session.setScene(request.snapshot);
    if (stage.isOutside()) {
        converged_ = drawOutside(session, encoder, request, slot, work);
        return;
    }
    if (stage.isShadowOutline()) {
        progress_ = session.prepareTruth(work.deadline);
        converged_ = progress_ == 1;
        if (!converged_) return; // the last picture stays
    }
    if (frame.stopAfter && !(request.state.technique == drawn_.technique && request.state.values() == drawn_.values() &&
                             !passesOf(drawn_.technique, scene).empty()))
        keepPasses(request,
                   session.render(slot, request.view, {.refine = false, .deadline = work.deadline}).result.passes);
    picture::RenderedFrame rendered = session.render(slot, request.view, frame);
    converged_ = rendered.converged;
    progress_ = rendered.prepared;
    // Nothing new to be seen yet: the last picture stays.
    if (const bool isDrawn = !rendered.result.passes.empty(); !converged_ && (rendered.prepared < 1 || hasWhole_ || !isDrawn)) return;
    if (!converged_ && stage.isStage() && !stage.isDerived() && !picture::isPublished(rendered, stage.key)) {
        progress_ = rendered.drawn; // what is solved while it is drawn has no stages before it is solved
        return;
    }
    if (asked.isPass) picture::requirePassRan(rendered, asked.key, *slot.info);
    encode(session, encoder, request, slot, stage, rendered);
    if (!frame.stopAfter) keepPasses(request, rendered.result.passes);
    // Times are taken now and then; between, the last ones stand.
    if (!work.timePasses && drawn_.technique == request.state.technique) {
        rendered.result.passMs = std::move(rendered_.result.passMs);
        rendered.frameMs = rendered_.frameMs;
        rendered.prepareMs = rendered_.prepareMs;
    }
    drawn_ = request.state;
    drawnScene_ = request.snapshot->name;
    rendered_ = std::move(rendered);
    isDrawn_ = true;
}

namespace {

std::vector<std::string> lightNames(const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const scene::Light& light : scene.lights)
        names.push_back(light.name);
    return names;
}

} // namespace

void Pane::keepPasses(const PaneRequest& request, const std::vector<StageKey>& passes) {
    if (passes.empty()) return; // the frame had nothing new to draw
    passes_ = distinct(passes);
    passesTechnique_ = request.state.technique;
    passesLights_ = lightNames(*request.snapshot);
}

const std::vector<StageKey>& Pane::passesOf(std::string_view technique, const scene::Scene& scene) const {
    static const std::vector<StageKey> kNone;
    return technique == passesTechnique_ && lightNames(scene) == passesLights_ ? passes_ : kNone;
}

/// False when the technique was not ready in time, or has more to draw.
bool Pane::drawOutside(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                       const PaneWork& work) {
    if (!outside_) outside_ = std::make_unique<picture::OutsideView>();
    View outside = request.view;
    outside.size = request.outsideSize;
    outside.camera = scene::widenedFor(request.outsideCamera, static_cast<double>(outside.size.x) / outside.size.y);
    outside.region = {};
    const int light = request.snapshot->lights.empty() ? kNoLight : request.light;
    const std::optional<Stage> seen = outside_->render(session, slot, request.view, outside, light,
                                                            {.choice = request.outsideChoice,
                                                             .typeHeight = request.outsideType / request.draft,
                                                             .draft = request.draft}, work.deadline);
    if (!seen) return false;
    picture_ = {encoder.encodeInPlace(*seen, StageKind::swatches, request.snapshot->exposure), StageKind::swatches,
                seen->display, picture::captionOf(*slot.info, seen->key.id)};
    drawn_ = request.state;
    drawnScene_ = request.snapshot->name;
    rendered_.drawn = outside_->drawnShare();
    return outside_->isWhole();
}

void Pane::encode(picture::Session& session, const picture::PictureEncoder& encoder, const PaneRequest& request, picture::Slot& slot,
                  const picture::ResolvedStage& stage, const picture::RenderedFrame& rendered) {
    const float exposure = request.snapshot->exposure;
    picture::StageLook look = picture::lookOf(stage, *slot.info, rendered);
    gl::Texture2D texture;
    std::string note;
    if (stage.isPass) {
        const int lift = picture::stepLift(slot.target.color, request.view.region, *request.snapshot);
        texture = encoder.encodeInPlace(slot.target.color, exposure * static_cast<float>(lift), 1, request.view.region);
        note = picture::liftNote(lift);
        look.caption = note;
    } else if (!stage.isStage()) {
        encoder.finish(finished_, slot.target, rendered.result, exposure, request.view.region);
        texture = std::exchange(finished_.color, std::move(picture_.texture));
    } else if (stage.isJudged()) {
        texture = encoder.encodeGround(slot.target.color, exposure, request.view.region);
    } else if (stage.isDerived()) {
        picture::Panel panel = picture::derivedPanel(session, slot, rendered, encoder, {stage.key, request.view, {}, nullptr});
        texture = textureOf(panel.picture);
        look.display = std::move(panel.display);
    } else {
        texture = encoder.encodeInPlace(picture::findStage(rendered, stage.key), look.kind, exposure, 1, &slot.target.color);
    }
    picture_ = {std::move(texture), look.kind, std::move(look.display), std::move(look.caption), std::move(note),
                stage.isStage() ? stage.key : StageKey{}};
}

} // namespace shadowlab::lab
