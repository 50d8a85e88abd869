// `shadowlab demo`: the window, shadow map and shadow volume on one scene. Where there is no display: a picture of both.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/commands/command_line.h"
#include "app/commands/messages.h"
#include "app/context/window_context.h"
#include "app/session/assets.h"
#include "app/session/deck.h"
#include "app/session/limits.h"
#include "app/ui/window.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/nearest_names.h"
#include "techniques/foundation/scene/load.h"
#include "techniques/foundation/scene/message_text.h"

namespace shadowlab::commands {

namespace {

int writeComparison(const DemoOptions& options) {
    CaptureOptions capture;
    capture.scene = options.scene;
    capture.techniques = {"shadow-map", "shadow-volume-zfail"};
    capture.layout = session::Layout::side;
    capture.size = {1600, 900};
    capture.supersample = 2; // smooths the outlines of objects; shadow edges keep each technique's own steps
    capture.allowed = options.allowed;
    const std::string name = std::filesystem::path(options.scene).stem().string();
    capture.output = std::filesystem::current_path() / (name + "-comparison.png");
    const int status = commands::capture(capture);
    if (status == 0) print(capture.output.string() + "\n");
    return status;
}

void requireSlide(const DemoOptions& options, const scene::LoadOptions& loading) {
    if (options.deck.empty() || options.slide.empty()) return;
    const std::vector<std::string> known = session::Deck(options.deck, loading).slides();
    if (std::ranges::find(known, options.slide) == known.end())
        throw Error(ExitStatus::usage, "--slide: no slide is called '" + scene::shown(options.slide) + "'; " +
                                           suggestion(options.slide, known));
}

} // namespace

int demo(const DemoOptions& options) {
    const scene::LoadOptions loading{
        .assetsRoot = session::assetsRoot(), .allowed = options.allowed, .limits = session::limits()};
    requireSlide(options, loading);
    const bool hasDisplay = context::hasDisplay(); // asked once: it is a connection each time
    if (!hasDisplay)
        (void)scene::loadScene(options.scene, loading); // also where a lesson or a deck is shown in its place
    if (!hasDisplay && !options.lesson.empty()) {
        LessonOptions picture;
        picture.lesson = options.lesson;
        picture.allowed = options.allowed;
        picture.output =
            std::filesystem::current_path() / (std::filesystem::path(options.lesson).stem().string() + "-lesson.png");
        const int status = lesson(picture);
        if (status != 0) return status;
        print(picture.output.string() + "\n");
        note("there is no display for a window; this picture was written instead");
        return status;
    }
    if (!hasDisplay && !options.deck.empty()) {
        SlidesOptions pictures;
        pictures.decks = {options.deck};
        if (!options.slide.empty()) pictures.only = {options.slide};
        pictures.allowed = options.allowed;
        pictures.output =
            std::filesystem::current_path() / (std::filesystem::path(options.deck).stem().string() + "-slides");
        const int status = slides(pictures);
        if (status != 0) return status;
        print(pictures.output.string() + "\n");
        note("there is no display for a window; these pictures were written instead");
        return status;
    }
    if (!hasDisplay) {
        const int status = writeComparison(options);
        if (status == 0) note("there is no display for a window; this picture was written instead");
        return status;
    }
    return ui::runWindow({.scene = options.scene,
                          .lesson = options.lesson,
                          .deck = options.deck,
                          .slide = options.slide,
                          .size = options.size,
                          .presenter = options.presenter,
                          .keepSettings = options.keepSettings,
                          .report = options.report},
                         loading);
}

} // namespace shadowlab::commands
