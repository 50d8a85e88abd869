// SPDX-License-Identifier: MIT
#include "app/lab/workbench.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/film/orbit.h"

namespace shadowlab::lab {

namespace {

// Below about fifteen frames a second motion is no longer smooth, and dragging feels delayed. Frames that take longer than that on
// average are drawn coarser; single slow ones (a judged frame, another program) have no effect.
constexpr double kTooSlowMs = 1000.0 / 15;
constexpr double kWorthIt = 0.7;   ///< of the time of full pictures, that coarse ones may take at most
constexpr double kNewShare = 0.25; ///< of a new frame's time in the average
constexpr int kCoarsest = 4;
constexpr double kMostAskingMs = 20; ///< about one pixel while something moves: a third of a frame's time
constexpr double kLeastShare = 0.01; ///< of a picture: of less no time can be foretold

} // namespace

Workbench::Workbench(Document document)
    : document_(std::move(document)), shown_(document_.scene), session_(document_.scene) {}

const std::vector<scene::Bounds>& Workbench::bounds() {
    const auto same = [](const scene::Revisions& a, const scene::Revisions& b) {
        return a.geometry == b.geometry && a.transforms == b.transforms;
    };
    if (!bounded_ || !same(bounded_->revisions, shown_->revisions)) bounds_ = scene::objectBounds(*shown_);
    bounded_ = shown_;
    return bounds_;
}

ivec2 Workbench::shownSize(ivec2 areaSize) const {
    const picture::Layout layout = document_.layout;
    if (layout == picture::Layout::side || layout == picture::Layout::grid) areaSize.x -= areaSize.x % 2;
    if (layout == picture::Layout::grid) areaSize.y -= areaSize.y % 2;
    return areaSize;
}

std::vector<PlacedPane> Workbench::placed(ivec2 areaSize) const {
    const int count = shownPanes(document_.layout);
    std::vector<PlacedPane> placed;
    areaSize = shownSize(areaSize);
    if (areaSize.x < 1 || areaSize.y < 1) return placed;
    const std::vector<picture::Cell> cells = picture::layoutCells(document_.layout, count, areaSize, document_.split);
    for (int i = 0; i < count; ++i) {
        const picture::Cell& cell = cells[std::min(cells.size() - 1, static_cast<std::size_t>(i))];
        if (cell.width < 1 || cell.height < 1) continue;
        placed.push_back({document_.layout == picture::Layout::single ? document_.active : i, cell});
    }
    return placed;
}

PaneRequest Workbench::requestFor(const PlacedPane& placed, int draft) const {
    PaneRequest request;
    request.state = document_.panes[static_cast<std::size_t>(placed.pane)];
    request.snapshot = shown_;
    request.view.camera = document_.camera;
    const picture::Cell& cell = placed.cell;
    request.view.size = glm::max(ivec2(1), (cell.pictureSize + draft - 1) / draft);
    if (document_.layout == picture::Layout::diff) request.state.stage = {};
    request.outsideCamera = document_.outsideCamera;
    request.outsideSize = glm::max(ivec2(1), (ivec2(cell.width, cell.height) + draft - 1) / draft);
    request.outsideChoice = document_.outsideChoice;
    request.outsideType = outsideType_;
    request.draft = draft;
    request.light = document_.light;
    const auto pixelOf = [&](const std::optional<dvec2>& place) {
        return place && isInPicture(*place, request.view.size) ? std::optional(pixelAt(*place, request.view.size)) : std::nullopt;
    };
    request.view.picked = pixelOf(document_.picked);
    if (request.view.picked) request.view.partner = pixelOf(document_.partner);
    const bool judged = std::ranges::find(answering_, placed.pane) != answering_.end();
    const bool isThere = pane(placed.pane).drawnFor() == request;
    if (document_.layout == picture::Layout::split && !whole_ && !judged && !isThere) {
        const ivec2 corner = ivec2(cell.cropX, 0) / draft;
        const ivec2 end =
            glm::min((ivec2(cell.cropX + cell.width, cell.height) + draft - 1) / draft, request.view.size);
        request.view.region = {corner, end - corner};
    }
    return request;
}

bool Workbench::update(ivec2 areaSize, Deadline deadline) {
    using Clock = std::chrono::steady_clock;
    if (isAtRest()) draft_ = 1;
    const Clock::time_point begin = Clock::now();
    bool drawn = false, asked = false;
    double share = 1;
    for (const PlacedPane& placed : this->placed(areaSize)) {
        const PaneWork work{deadline, timePasses_, isAtRest(),
                            std::ranges::find(answering_, placed.pane) != answering_.end()};
        Pane& pane = panes_[static_cast<std::size_t>(placed.pane)];
        drawn = pane.update(session_, encoder_, requestFor(placed, draft_), work) || drawn;
        if (placed.pane == document_.active) asked = askAboutPixel(requestFor(placed, draft_), pane);
        share = std::min(share, pane.drawnShare());
    }
    // From one frame to the next, for the driver may still be drawing now. What the deadline cut off would have taken longer.
    if (drawn && begun_)
        chooseDraft(std::chrono::duration<double, std::milli>(begin - *begun_).count() /
                    std::max(drawnShare_, kLeastShare));
    drawnShare_ = share;
    begun_ = drawn ? std::optional(begin) : std::nullopt;
    return drawn || asked;
}

/// True when there is something new to show. While something moves, only what is fast is computed again.
bool Workbench::askAboutPixel(const PaneRequest& request, Pane& pane) {
    const PaneRequest& before = pickedPixel_.askedFor;
    if (!request.view.picked) {
        pickedPixel_ = {};
        return false;
    }
    if (request == before && request.view.picked == before.view.picked && request.view.partner == before.view.partner)
        return false;
    if (!isAtRest() && !isNewlyPicked_ && pickedPixel_.tookMs > kMostAskingMs) return false;
    const auto begin = std::chrono::steady_clock::now();
    std::optional<Probe> probe = pane.probe(request.view);
    if (!probe) return false; // the technique is not ready
    pickedPixel_ = {request, std::move(*probe),
                    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()};
    if (std::exchange(isNewlyPicked_, false) && pickedPixel_.probe.geometry.empty()) unpick();
    return true;
}

void Workbench::pick(const dvec2& place) {
    document_.picked = place;
    isNewlyPicked_ = true;
    pickedPixel_ = {};
}

void Workbench::pickPartner(const dvec2& place) {
    if (!document_.picked) return pick(place);
    document_.partner = place;
}

void Workbench::unpick() {
    document_.picked.reset();
    document_.partner.reset();
}

void Workbench::chooseDraft(double tookMs) {
    if (isAtRest() || !draftAllowed_) {
        fullMs_ = draftMs_ = 0;
        draft_ = 1;
        draftHelps_ = true;
        return;
    }
    // The first frame after a change waits for the driver, which is still drawing the last one before it.
    if (std::exchange(draftIsNew_, false)) return;
    double& averageMs = draft_ == 1 ? fullMs_ : draftMs_;
    averageMs = averageMs == 0 ? tookMs : glm::mix(averageMs, tookMs, kNewShare);
    // Fewer pixels are no quicker where triangles are what takes the time: then they are only uglier.
    if (draft_ == kCoarsest && draftMs_ > kWorthIt * fullMs_) draftHelps_ = false;
    const int before = draft_;
    if (!draftHelps_ || fullMs_ < kTooSlowMs)
        draft_ = 1;
    else if (draft_ == 1 || draftMs_ > kTooSlowMs)
        draft_ = std::min(2 * draft_, kCoarsest);
    if (draft_ == before) return;
    draftIsNew_ = true;
    if (draft_ > 1) draftMs_ = 0;
}

void Workbench::drawAnew() {
    for (Pane& pane : panes_)
        pane.forget();
}

void Workbench::change(const std::string& gesture, const std::function<void(Document&)>& edit) {
    Document changed = document_;
    edit(changed);
    if (changed == document_) return;
    history_.remember(document_, gesture);
    document_ = std::move(changed);
}

void Workbench::changeScene(const std::string& gesture,
                            const std::function<scene::Snapshot(const scene::Snapshot&)>& edit) {
    settle();
    change(gesture, [&](Document& document) { document.scene = edit(document.scene); });
    shown_ = document_.scene;
}

void Workbench::undo() {
    settle();
    show(history_.undo(document_));
}

void Workbench::redo() {
    settle();
    show(history_.redo(document_));
}

/// Cameras come back as well. What is picked stays: it is no change, and the camera that it was picked in may be another.
void Workbench::show(Document document) {
    if (document.sceneName == document_.sceneName) {
        document.outsideChoice.caster = document_.outsideChoice.caster;
        document.picked = document_.picked;
        document.partner = document_.partner;
    }
    document_ = std::move(document);
    shown_ = document_.scene;
}

void Workbench::setCamera(const scene::Camera& camera) {
    if (scene::hasView(camera)) changeCamera([&](Document& document) { document.camera = camera; });
}

void Workbench::setOutsideCamera(const scene::Camera& camera) {
    changeCamera([&](Document& document) { document.outsideCamera = camera; });
}

/// Moving the eye does not stop an animation, which would be undone with it.
void Workbench::changeCamera(const std::function<void(Document&)>& edit) {
    if (animation_.playing)
        edit(document_);
    else
        change("move the camera", edit);
}

void Workbench::resetOutsideCamera() { setOutsideCamera(outsideCameraOf(*document_.scene, document_.camera)); }

void Workbench::activate(int pane) { document_.active = std::clamp(pane, 0, kPanes - 1); }

void Workbench::showScene(scene::Snapshot scene, std::string sceneName) {
    history_.remember(document_, "");
    animation_.playing = false;
    animation_.seconds = 0;
    document_.camera = scene->camera;
    document_.outsideCamera = outsideCameraOf(*scene, scene->camera);
    document_.outsideChoice.caster.reset(); // objects are counted anew
    document_.light = 0;
    unpick();
    ++replacements_;
    document_.scene = std::move(scene);
    document_.sceneName = std::move(sceneName);
    // A stage of a light that this scene does not have is no stage of it.
    for (PaneState& pane : document_.panes)
        pane.stage = pane.stage.ofAnyLight();
    shown_ = document_.scene;
}

void Workbench::showDocument(Document document) {
    history_.remember(document_, "");
    animation_.playing = false;
    animation_.seconds = 0;
    unpick();
    ++replacements_;
    document_ = std::move(document);
    shown_ = document_.scene;
}

void Workbench::play(bool playing) {
    if (playing == animation_.playing) return;
    if (playing) {
        history_.remember(document_, "");
        animation_.seconds = 0;
        animation_.playing = true;
    } else {
        settle();
    }
}

void Workbench::advance(double seconds) {
    if (!animation_.playing) return;
    const double step = seconds * animation_.speed;
    animation_.seconds += step;
    shown_ = animated(document_.scene, animation_);
    if (animation_.camera) document_.camera = film::turned(document_.camera, kTurnDegreesPerSecond * step);
}

/// Ends the animation where it is: what is seen becomes the document, and can be changed.
void Workbench::settle() {
    if (!animation_.playing) return;
    animation_.playing = false;
    animation_.seconds = 0;
    document_.scene = shown_;
}

} // namespace shadowlab::lab
