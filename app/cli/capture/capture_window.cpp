// `shadowlab capture --ui`: the window as it looks, without a window.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <thread>

#include "app/cli/capture/capture.h"
#include "app/cli/capture/capture_outputs.h"
#include "app/cli/common_options.h"
#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/film/motion.h"
#include "app/lab/settings.h"
#include "app/picture/steps/stepping.h"
#include "app/window/screen.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::cli {

namespace {

/// What the command line asks for, as the window would have it after some clicks.
lab::Document documentFor(const CaptureOptions& options, const scene::Snapshot& scene) {
    lab::Document document = lab::newDocument(scene, options.scene);
    document.layout = options.techniques.size() == 1 ? picture::Layout::single : options.layout;
    document.split = options.split;
    if (!options.light.empty()) document.light = picture::lightIndex(*scene, options.light);
    document.outsideChoice = picture::outsideChoiceOf(options.volumes, options.nearClip, *scene, "--volumes");
    if (options.outside) {
        const auto& [x, y, z, targetX, targetY, targetZ] = *options.outside;
        document.outsideCamera.positionWorld = {x, y, z};
        document.outsideCamera.targetWorld = {targetX, targetY, targetZ};
    }
    // The settings are checked, and written as the panes keep them, by slots like those of any other capture.
    std::vector<picture::Slot> slots;
    for (const std::string& id : options.techniques)
        slots.push_back(picture::Session::makeSlot(id));
    lab::applySettings(slots, options.settings);
    for (std::size_t i = 0; i < slots.size(); ++i) {
        lab::PaneState& state = document.panes[i];
        state.technique = options.techniques[i];
        state.stage = options.stages[i];
        picture::resolve(state.stage, *slots[i].info, *scene, document.light); // refuses what there is not
        for (const params::Param& param : slots[i].params)
            if (params::valueText(param) != params::initialText(param))
                state.settings[state.technique][param.id] = params::valueText(param);
    }
    return document;
}

constexpr double kFrameSeconds = 1.0 / 30; ///< by which the screen's own clock advances from frame to frame

/// Frames until nothing changes any more: stages are drawn, errors are exact, ImGui has laid out what it measured.
void settle(window::Screen& screen) {
    constexpr int kLayoutFrames = 3; // a window that is as high as its text is measured in one and placed in the next
    constexpr auto kForOthers =
        std::chrono::milliseconds(5); // exact errors are found by threads that yield to this one
    for (int settled = 0; settled < kLayoutFrames;) {
        context::throwIfInterrupted();
        screen.frame(kFrameSeconds);
        settled = screen.isSettled() ? settled + 1 : 0;
        if (settled == 0) std::this_thread::sleep_for(kForOthers);
    }
}

} // namespace

int captureWindow(const CaptureOptions& options) {
    image::probeWritable(numbered(options.output, 0));
    const scene::Snapshot scene = loadSeenFrom(options.scene, options.view, loadOptions(options.allowed, options.normals));
    const film::Motion motion = motionOf(options.motion, *scene);
    requirePlaceForNumbers(options, motion.frames);
    const std::unique_ptr<context::Context> context = context::createContext(options.backend);
    window::WindowState ui(documentFor(options, scene));
    ui.live = false;
    ui.scenes = scene::builtInScenes(context::assetsRoot());
    if (options.presenter) window::togglePresenter(ui);
    ui.lesson.all = course::builtInLessons(context::assetsRoot());
    ui.shown.keys = options.keys;
    if (options.source) window::toggleSource(ui);
    ui.shown.coarse = false;
    window::Screen screen(ui, context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    screen.fit(options.size, 1);
    screen.setPatience(
        std::chrono::hours(1)); // no user waits for it, and the picture must not depend on how fast the machine is
    if (options.pixel) {
        screen.frame(kFrameSeconds); // type is measured in it, and from that follows how large the pictures are
        const std::vector<lab::PlacedPane> panes = ui.bench.placed(screen.pictureSize());
        const ivec2 shown = panes.empty() ? ivec2(0) : panes.front().cell.pictureSize;
        if (shown.x <= 0 || shown.y <= 0)
            throw Error(ExitStatus::usage, "--size: a window of this size has no room for a picture beside its panels; "
                                           "choose a larger one");
        const auto placeOf = [&](const std::string& option, ivec2 pixel) {
            if (pixel.x >= shown.x || pixel.y >= shown.y)
                throw Error(ExitStatus::usage, option + ": in a window of this size a picture has " +
                                                   std::to_string(shown.x) + " x " + std::to_string(shown.y) +
                                                   " pixels; choose one within");
            return lab::placeOf((dvec2(pixel) + 0.5) / dvec2(shown), shown);
        };
        ui.bench.pick(placeOf("--pixel", *options.pixel));
        if (options.partner) ui.bench.pickPartner(placeOf("--partner", *options.partner));
    }
    std::unique_ptr<film::Film> film;
    if (isFilm(options)) film = film::makeFilm(options.output, options.time, {});
    const auto write = [&](int frame) {
        settle(screen);
        const image::Image picture = picture::PictureEncoder::read(screen.picture());
        if (film)
            film->add(picture);
        else
            image::writeWhole(numbered(options.output, frame), image::encodePng(picture, {.opaque = true, .text = {}}));
    };
    if (options.steps) {
        settle(screen); // the list of passes is complete only after they have run
        for (const StageKey& pass :
             std::vector(ui.bench.pane(0).passesOf(ui.bench.document().panes[0].technique, *scene))) {
            window::chooseStage(ui, picture::refOf(pass, true, *scene));
            write(0);
        }
    }
    for (int frame = 0; frame < motion.frames && !options.steps; ++frame) {
        const film::Moment moment = film::momentAt(motion, scene, frame, ui.bench.document().scene);
        ui.bench.changeScene("", [&](const scene::Snapshot&) { return moment.snapshot; });
        ui.bench.setCamera(moment.camera);
        write(frame);
    }
    if (film) film->finish();
    for (const window::Message& message : screen.messages())
        if (message.fault) note(message.text);
    return 0;
}

} // namespace shadowlab::cli
