// `shadowlab demo`: the window, shadow map and shadow volume on one scene. Where there is no display: a picture of both.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/cli/command_line.h"
#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/context/window_context.h"
#include "app/course/deck.h"
#include "app/picture/limits.h"
#include "app/window/window.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

int writeComparison(const DemoOptions& options) {
    CaptureOptions capture;
    capture.scene = options.scene;
    capture.techniques = {"shadow-map", "shadow-volume-zfail"};
    capture.layout = picture::Layout::side;
    capture.size = {1600, 900};
    capture.supersample = 2; // smooths the outlines of objects; shadow edges keep each technique's own steps
    capture.allowed = options.allowed;
    const std::string name = std::filesystem::path(options.scene).stem().string();
    capture.output = std::filesystem::current_path() / (name + "-comparison.png");
    const int status = cli::capture(capture);
    if (status == 0) print(capture.output.string() + "\n");
    return status;
}

void requireSlide(const DemoOptions& options, const scene::LoadOptions& loading) {
    if (options.deck.empty() || options.slide.empty()) return;
    const std::vector<std::string> known = course::Deck(options.deck, loading).slides();
    if (std::ranges::find(known, options.slide) == known.end())
        throw Error(ExitStatus::usage, "--slide: no slide is called '" + scene::shown(options.slide) + "'; " +
                                           suggestion(options.slide, known));
}

/// Lesson, deck or comparison in place of a window, and `why`. Into the current folder, and its place to standard output.
int writeInstead(const DemoOptions& options, const std::string& why) {
    const std::filesystem::path folder = std::filesystem::current_path();
    const auto stem = [](const std::string& name) { return std::filesystem::path(name).stem().string(); };
    int status = 0;
    if (!options.lesson.empty()) {
        LessonOptions picture;
        picture.lesson = options.lesson;
        picture.allowed = options.allowed;
        picture.output = folder / (stem(options.lesson) + "-lesson.png");
        status = lesson(picture);
        if (status == 0) print(picture.output.string() + "\n");
    } else if (!options.deck.empty()) {
        SlidesOptions pictures;
        pictures.decks = {options.deck};
        if (!options.slide.empty()) pictures.only = {options.slide};
        pictures.allowed = options.allowed;
        pictures.output = folder / (stem(options.deck) + "-slides");
        status = slides(pictures);
        if (status == 0) print(pictures.output.string() + "\n");
    } else {
        status = writeComparison(options);
    }
    if (status == 0)
        note(why + (options.lesson.empty() && !options.deck.empty() ? "; these pictures were written instead"
                                                                    : "; this picture was written instead"));
    return status;
}

} // namespace

int demo(const DemoOptions& options) {
    const scene::LoadOptions loading{
        .assetsRoot = context::assetsRoot(), .allowed = options.allowed, .limits = picture::limits()};
    requireSlide(options, loading);
    if (const std::optional<std::string> missing = context::missingDisplay()) {
        (void)scene::loadScene(options.scene, loading); // also where a lesson or a deck is shown in its place
        return writeInstead(options,
                            "there is no display for a window" + (missing->empty() ? "" : " (" + *missing + ")"));
    }
    try {
        return window::runWindow({.scene = options.scene,
                              .lesson = options.lesson,
                              .deck = options.deck,
                              .slide = options.slide,
                              .size = options.size,
                              .presenter = options.presenter,
                              .keepSettings = options.keepSettings,
                              .report = options.report},
                             loading);
    } catch (const context::NoWindow& none) { // before anything was shown
        return writeInstead(options, "no window can be opened (" + none.reason + ")");
    }
}

} // namespace shadowlab::cli
