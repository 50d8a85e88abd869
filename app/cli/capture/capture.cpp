// `shadowlab capture`: one picture, or a sequence, of one or several techniques.
// SPDX-License-Identifier: MIT
#include "app/cli/capture/capture.h"
#include "app/lab/old_spelling.h"

#include <algorithm>

#include "app/cli/capture/capture_checks.h"
#include "app/cli/capture/capture_outputs.h"
#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/option_values.h"
#include "app/lab/document.h"

namespace shadowlab::cli {

namespace {

void describeCapture(DescribedOptions& add) {
    describeScene(add);
    add.option(
        "-o,--output", "OUT.png",
        "the picture; for several frames with #### in place of the number; with --steps or --animate an animated PNG, "
        "or a "
        "film if it ends in .mp4");
    add.option("-t,--technique", "ID[,ID...]",
               "techniques, one a slot (`list techniques`; default shadow-volume-zfail)");
    add.option(
        "--layout", "LAYOUT",
        "single, side, split, grid, or diff: where two differ and who is right (default: single for one technique, "
        "else side)");
    add.option("--split", "SHARE", "of the width that the left one of two in --layout split has (default 0.5)");
    add.option("--labels", "true|false", "titles on the pictures of several techniques (default true)");
    add.option(
        "--stage", "[SLOT:]STAGE",
        "an intermediate picture: STAGE, STAGE@LIGHT or pass:ID (`list stages`), of all techniques or of one; may be "
        "repeated");
    add.option("--enlarge", "true|false",
               "the stage error and --layout diff draw wrong pixels that stand alone large enough to be seen from afar, as the "
               "window does (default false: each is one pixel, to be counted)");
    add.option("--row", "Y", "the row of the stage scanline, from the top (default: the one with most wrong pixels)");
    add.option("--outside", "X,Y,Z,X,Y,Z",
               "where the second camera of the stage outside stands, and where it looks (default: a good place)");
    add.option("--volumes", "all|OBJECT",
               "whose shadow volume the stage outside shows (default: that of the object whose shadow takes most of the picture)");
    add.flag("--near-clip", "the stage outside shows the near-clip pyramid of shadow volumes as well");
    add.option("--pixel", "X,Y",
               "the pixel whose rays the stage outside shows, in place of a few of all, or whose patch radiosity's "
               "form-factors "
               "are of; with --ui the one that is picked");
    add.option(
        "--partner", "X,Y",
        "a second pixel beside --pixel, whose patch radiosity shows with the first one's; other techniques take no "
        "notice");
    add.option("--size", "WxH", "width and height of the whole picture in pixels (default 1280x720)");
    add.option("--supersample", "N",
               "average N x N samples a pixel in linear light (default 1; never for stages about visibility)");
    add.option("--set", "[SLOT:]ID.PARAM=VALUE",
               "a parameter (`list parameters`), of all slots or of one; may be repeated");
    add.option("--light", "NAME", "the light that the stage is about (default: the first)");
    describeView(add);
    describeBackend(add);
    add.flag("--ui", "the window with all its widgets around the pictures, as `demo` shows it");
    add.flag("--presenter", "with --ui: large type and high contrast");
    add.flag("--keys", "with --ui: the list of all keys over it");
    add.option(
        "--source", "true|false",
        "with --ui: formula, pseudocode and source of the step that --stage pass:ID shows, beside its picture (default "
        "false)");
    add.option("--stats", "FILE.json", "writes times in milliseconds, counters and settings");
    describeMotion(add);
    add.flag("--animate", "all frames in one file, an animated PNG or an MP4 film");
    add.option("--fps", "N", "with --animate: frames a second (default 25)");
    add.flag("--steps",
             "all steps of the technique in one file, an animated PNG or an MP4 film, each with its title below");
    add.option("--hold", "SECONDS", "with --steps: how long each stays (default 2)");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer(
        "Examples:\n"
        "  shadowlab capture still-life -o still-life.png\n"
        "  shadowlab capture bunny.obj -t shadow-map,shadow-volume-zfail --set shadow-map.resolution=256 -o both.png\n"
        "  shadowlab capture still-life --frames 90 --orbit-light 360 -o frames/turn_####.png\n"
        "  shadowlab capture still-life -t shadow-map --steps --hold 3 -o steps.png\n"
        "  shadowlab capture still-life --frames 90 --orbit-light 360 --animate -o turn.mp4");
}

CaptureOptions captureOptions(const GivenOptions& given) {
    const std::string example = "shadowlab capture SCENE -o OUT.png";
    CaptureOptions options;
    options.scene = given.required("SCENE", example);
    options.output = given.required("--output", example);
    options.view = given.text("--view");
    options.steps = given.has("--steps");
    options.animate = given.has("--animate");
    if (!isFilm(options) && film::isMp4(options.output))
        refuseUsage("-o: '" + options.output.string() +
                    "' is a film, and this is one picture; add --steps, or --frames N and --animate, or write a .png");
    if (!film::isMp4(options.output)) requireEnding("-o", options.output, ".png");
    if (given.has("--technique")) options.techniques = splitAtCommas(given.texts("--technique"));
    options.layout = layoutFor(given, options.techniques.size());
    options.labels = booleanFrom("--labels", given.text("--labels", "true"));
    options.stages = stagesFor(given, options.techniques.size());
    options.enlarge = booleanFrom("--enlarge", given.text("--enlarge", "false"));
    options.settings = given.texts("--set");
    std::vector<std::string> stageIds;
    for (const picture::StageRef& stage : options.stages)
        stageIds.push_back(stage.isPass ? "" : stage.id);
    lab::respell(options.techniques, stageIds, options.settings);
    const bool anyStage = !std::ranges::all_of(options.stages, &picture::StageRef::isPicture);
    if (options.layout == picture::Layout::diff && anyStage)
        refuseUsage("--stage: --layout diff compares the finished pictures; leave one of them out");
    if (given.has("--split")) options.split = splitFor(given, options.layout, options.techniques.size());
    options.ui = given.has("--ui");
    options.presenter = given.has("--presenter");
    options.keys = given.has("--keys");
    options.source = booleanFrom("--source", given.text("--source", "false"));
    if (!options.ui && (options.presenter || options.keys || options.source))
        refuseUsage(std::string(options.presenter ? "--presenter"
                                : options.keys    ? "--keys"
                                                  : "--source") +
                    ": only the window has it; add --ui");
    if (options.ui && options.techniques.size() > lab::kPanes)
        refuseUsage("--ui: the window has " + std::to_string(lab::kPanes) + " panes, " +
                    std::to_string(options.techniques.size()) + " techniques are given with -t; leave some out");
    if (options.ui && given.has("--stats")) refuseUsage("--stats: not with --ui; leave one of them out");
    options.size = sizeFrom("--size", given.text("--size", "1280x720"), "picture-side");
    options.supersample = limitedCountFrom("--supersample", given.text("--supersample", "1"), "supersample");
    // A visibility image, and what is derived from one, holds the answers at the pixels' centres, not an average.
    if (options.layout == picture::Layout::diff ||
        std::ranges::any_of(options.stages,
                            [](const picture::StageRef& stage) { return stage.isVisibility() || stage.isDerived(); }))
        options.supersample = 1;
    if (given.has("--outside")) options.outside = outsideFor(given, options.stages);
    for (const char* option : {"--volumes", "--near-clip"})
        if (given.has(option) && std::ranges::none_of(options.stages, &picture::StageRef::isOutside))
            refuseUsage(std::string(option) + ": only the stage outside shows volumes as a whole; add --stage outside");
    options.volumes = given.text("--volumes");
    options.nearClip = given.has("--near-clip");
    if (given.has("--pixel")) options.pixel = pickedFor("--pixel", given, options);
    if (given.has("--partner")) {
        if (!options.pixel)
            refuseUsage("--partner: it is the second of two pixels; add the first one with --pixel X,Y");
        options.partner = pickedFor("--partner", given, options);
    }
    if (given.has("--row")) options.row = rowFor(given, options.stages, options.size);
    options.light = given.text("--light");
    options.backend = backendFrom(given);
    options.stats = given.text("--stats");
    if (!options.stats.empty()) requireEnding("--stats", options.stats, ".json");
    options.motion = motionOptions(given);
    if (isFilm(options)) checkFilm(options);
    options.time = timeFor(given, options);
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.scene);
    requirePlaceForNumbers(options, options.motion.frames.value_or(1));
    requireDrawable(options);
    return options;
}

Work captureWork(const GivenOptions& given) {
    return [options = captureOptions(given)] { return capture(options); };
}

} // namespace

int capture(const CaptureOptions& options) { return options.ui ? captureWindow(options) : capturePictures(options); }

const Command kCapture{"capture", "SCENE", "Renders a scene to a PNG without a window", describeCapture, captureWork};

} // namespace shadowlab::cli
