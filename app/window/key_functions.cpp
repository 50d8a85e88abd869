// SPDX-License-Identifier: MIT
#include "app/window/key_functions.h"

#include <algorithm>
#include <optional>

#include "app/lab/camera_control.h"
#include "app/window/gizmo.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

// Steps of the camera and of what is selected; shares are of the distance from the camera to its target.
constexpr double kTurnDegrees = 3, kFlyShare = 0.04, kMoveShare = 0.02;

void orbit(WindowState& ui, double right, double over) {
    moveCamera(ui, [&](const scene::Camera& camera) { return lab::orbited(camera, right, over); });
}

/// What the slide or the lesson on show has in the active pane, where the class now looks at it in another way; none: nothing is told,
/// or that is still on show.
std::optional<picture::StageRef> toldStage(const WindowState& ui) {
    const bool ofSlide = ui.slides.isOn() && !ui.slides.stops.empty();
    if (!ofSlide && !ui.lesson.isOn()) return std::nullopt;
    const lab::Document& told = ofSlide ? ui.slides.stops[ui.slides.stop].document : ui.lesson.shown;
    const lab::PaneState& meant = told.panes[static_cast<std::size_t>(ui.bench.document().active)];
    const lab::PaneState& now = ui.bench.activeState();
    if (meant.technique != now.technique || meant.stage == now.stage) return std::nullopt;
    return meant.stage;
}

/// Closes what lies beside the pictures or over them. False: there is no such thing.
bool closeAids(Shown& shown) {
    const bool any = shown.strip || shown.magnifier || shown.blink;
    shown.strip = shown.magnifier = shown.blink = false;
    return any;
}

/// Whether the picked pixel is the one that the slide on show is about.
bool isSlidesOwnPixel(const WindowState& ui) {
    const SlideState& on = ui.slides;
    const lab::Document& document = ui.bench.document();
    return on.isOn() && !on.stops.empty() && on.stops[on.stop].document.picked == document.picked &&
           on.stops[on.stop].document.partner == document.partner;
}

} // namespace

void chooseNumber(WindowState& ui, std::size_t number) {
    if (ui.lesson.asksChoice()) return answer(ui, static_cast<int>(number));
    const auto all = techniquesOf(TechniqueGroup::production);
    if (number < all.size()) chooseTechnique(ui, all[number].info->id);
}

void pan(WindowState& ui, double right, double up) {
    moveCamera(ui, [&](const scene::Camera& camera) { return lab::panned(camera, -right, -up); });
}

void fly(WindowState& ui, double right, double forward) {
    moveCamera(ui, [&](const scene::Camera& camera) {
        const double step = kFlyShare * lab::targetDistance(camera);
        return lab::flown(camera, right * step, 0, forward * step);
    });
}

void zoom(WindowState& ui, double factor) {
    moveCamera(ui, [&](const scene::Camera& camera) { return lab::zoomed(camera, factor); });
}

void arrows(WindowState& ui, double right, double forward) {
    if (ui.selection.kind == lab::Selection::Kind::none) {
        orbit(ui, right * kTurnDegrees, forward * kTurnDegrees);
        return;
    }
    const scene::Camera& camera = ui.bench.document().camera;
    const dvec3 upWorld = glm::normalize(camera.upWorld);
    const dvec3 rightWorld = glm::normalize(glm::cross(camera.targetWorld - camera.positionWorld, upWorld));
    const double step = kMoveShare * lab::targetDistance(camera);
    moveSelected(ui, step * (right * rightWorld + forward * glm::cross(upWorld, rightWorld)), "move by keys");
}

void lift(WindowState& ui, double up) {
    if (ui.selection.kind == lab::Selection::Kind::none) {
        pan(ui, 0, up * kPanShare);
        return;
    }
    const scene::Camera& camera = ui.bench.document().camera;
    moveSelected(ui, up * kMoveShare * lab::targetDistance(camera) * glm::normalize(camera.upWorld), "move by keys");
}

void moveSplit(WindowState& ui, double by) {
    ui.bench.change("split",
                    [&](lab::Document& document) { document.split = std::clamp(document.split + by, 0.0, 1.0); });
}

void nextScene(WindowState& ui, int by) {
    if (ui.scenes.empty()) return;
    const auto now = std::ranges::find(ui.scenes, ui.bench.document().sceneName);
    const auto count = static_cast<int>(ui.scenes.size());
    const int at = now == ui.scenes.end() ? (by > 0 ? -1 : 0) : static_cast<int>(now - ui.scenes.begin());
    ui.requests.scene = ui.scenes[static_cast<std::size_t>((at + by + count) % count)];
}

void changeSpeed(WindowState& ui, double factor) {
    ui.bench.setAnimation([&](lab::Animation& animation) {
        animation.speed = std::clamp(animation.speed * factor, lab::kSlowest, lab::kFastest);
    });
}

void nextMovers(WindowState& ui) {
    ui.bench.setAnimation([](lab::Animation& animation) {
        const bool lightsAlone = animation.lights && !animation.camera, all = animation.lights && animation.camera;
        animation.lights = animation.objects = !lightsAlone;
        animation.camera = lightsAlone || !all;
    });
}

void nextLight(WindowState& ui) {
    const auto count = static_cast<int>(ui.bench.shownScene()->lights.size());
    if (count == 0) return;
    ui.bench.change("", [&](lab::Document& document) { document.light = (document.light + 1) % count; });
    if (ui.live) ui.flashUntil = ImGui::GetTime() + kFlashSeconds;
}

void nextLayout(WindowState& ui, int by) {
    constexpr int kCount = 5;
    const int now = static_cast<int>(ui.bench.document().layout);
    chooseLayout(ui, static_cast<picture::Layout>((now + by + kCount) % kCount));
}

void turnKeyPage(WindowState& ui) {
    const bool goesOn = ui.shown.keys && ui.keyPage + 1 < ui.keyPages;
    ui.keyPage = goesOn ? ui.keyPage + 1 : 0;
    ui.shown.keys = goesOn || !ui.shown.keys;
}

void leave(WindowState& ui) {
    if (ui.shown.keys)
        ui.shown.keys = false;
    else if (std::erase_if(ui.messages, [](const Message& message) { return message.fault; }) > 0)
        return;
    else if (ui.selection.kind != lab::Selection::Kind::none)
        ui.selection = {};
    else if (closeAids(ui.shown))
        return;
    else if (ui.shown.source)
        toggleSource(ui);
    else if (outerMode(ui) != StoryMode::explore) // steps within a lesson or a slide
        leaveStory(ui);
    else if (const auto told = toldStage(ui))
        chooseStage(ui, *told);
    else if (isSlidesOwnPixel(ui)) // which is not let go, or the slide would be another
        leaveStory(ui);
    else if (ui.bench.document().partner)
        ui.bench.unpickPartner();
    else if (ui.bench.document().picked)
        ui.bench.unpick();
    else if (leaveStory(ui))
        return;
    else if (!ui.bench.activeState().stage.isPicture())
        chooseStage(ui, {});
}

} // namespace shadowlab::window
