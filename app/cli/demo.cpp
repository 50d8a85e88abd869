// `shadowlab demo`: the window, shadow map and shadow volume on one scene. Where there is no display: a picture of both.
// SPDX-License-Identifier: MIT
#include "app/cli/demo.h"

#include <algorithm>

#include "app/cli/capture/capture.h"
#include "app/cli/common_options.h"
#include "app/cli/lesson.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/slides.h"
#include "app/context/window_context.h"
#include "app/course/deck.h"
#include "app/window/window.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

struct DemoOptions {
    std::string scene = "still-life";
    std::string lesson; ///< to begin with; empty: none
    std::string deck;   ///< the same
    std::string slide;  ///< one of the deck's by its name; empty: the first
    ivec2 size{0};      ///< of the window; zero: what it was the last time
    bool presenter = false, keepSettings = true, report = false;
    std::optional<scene::NormalMode> normals; ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed;
};

void describeDemo(DescribedOptions& add) {
    add.option("SCENE", "", "a built-in name (`list scenes`), a .json scene or a mesh (.obj, .gltf, .glb; default still-life)");
    add.option("--lesson", "LESSON", "begins with a lesson (`list lessons`, or a .json file); J goes on");
    add.option("--deck", "DECK", "begins with slides (`list decks`, or a .json file); S goes on");
    add.option("--slide", "NAME", "which of the deck's slides (default the first)");
    add.option("--size", "WxH", "of the window (default: as it was the last time, at first 1280x720)");
    add.flag("--presenter", "large type and high contrast from the start (D in the window)");
    add.option("--keep-settings", "true|false",
               "remember size and panels of the window from run to run (default true)");
    add.flag("--report", "a line of JSON on standard output for every state that is on screen");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that scenes may take meshes from; may be repeated");
    add.footer("In the window H lists all keys. Without a display it writes a picture instead, and says why.\n"
               "Examples:\n"
               "  shadowlab demo still-life\n"
               "  shadowlab demo --lesson acne\n"
               "  shadowlab demo --deck shadows --slide methods --presenter");
}

DemoOptions demoOptions(const GivenOptions& given) {
    DemoOptions options;
    options.scene = given.text("SCENE", options.scene);
    options.lesson = given.text("--lesson");
    options.deck = given.text("--deck");
    options.slide = given.text("--slide");
    if (given.has("--slide") && !given.has("--deck")) refuseUsage("--slide is one of a deck; write --deck NAME, too");
    if (given.has("--lesson") && given.has("--deck")) refuseUsage("--lesson, --deck: one of them; leave the other out");
    if (given.has("--size")) options.size = sizeFrom("--size", given.text("--size"), "picture-side");
    options.presenter = given.has("--presenter");
    options.keepSettings = booleanFrom("--keep-settings", given.text("--keep-settings", "true"));
    options.report = given.has("--report");
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    return options;
}

int writeComparison(const DemoOptions& options) {
    CaptureOptions capture;
    capture.scene = options.scene;
    capture.techniques = {"shadow-map", "shadow-volume-zfail"};
    capture.layout = picture::Layout::side;
    capture.size = {1600, 900};
    capture.supersample = 2; // smooths the outlines of objects; shadow edges keep each technique's own steps
    capture.allowed = options.allowed;
    capture.normals = options.normals;
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

int demo(const DemoOptions& options) {
    const scene::LoadOptions loading = loadOptions(options.allowed, options.normals);
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

Work demoWork(const GivenOptions& given) {
    return [options = demoOptions(given)] { return demo(options); };
}

} // namespace

Work demoOf(const std::string& scene) {
    DemoOptions options;
    if (!scene.empty()) options.scene = scene;
    return [options] { return demo(options); };
}

const Command kDemo{"demo", "[SCENE]",
                    "Opens the window: shadow map and shadow volume on one scene (H there lists all keys)",
                    describeDemo, demoWork};

} // namespace shadowlab::cli
