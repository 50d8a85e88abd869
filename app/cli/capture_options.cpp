// SPDX-License-Identifier: MIT
#include "app/cli/capture_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <CLI/CLI.hpp>

#include "app/lab/document.h"
#include "app/lab/old_spelling.h"
#include "app/picture/derived_stages.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

const std::vector<std::string> kLayouts = {"single", "side", "split", "grid",
                                           "diff"}; ///< in the order of picture::Layout

picture::Layout layoutFor(const GivenOptions& given, std::size_t slots) {
    if (!given.has("--layout")) return slots > 1 ? picture::Layout::side : picture::Layout::single;
    const auto layout = static_cast<picture::Layout>(choiceFrom("--layout", given.text("--layout"), kLayouts));
    if (layout == picture::Layout::single && slots > 1)
        refuseUsage("--layout: single shows one technique, " + std::to_string(slots) +
                    " are given with -t; use side, split or grid");
    if (layout == picture::Layout::diff && slots != 2)
        refuseUsage("--layout: diff compares two techniques, " + std::to_string(slots) +
                    " given with -t; write for example -t shadow-map,shadow-volume-zfail");
    return layout;
}

double splitFor(const GivenOptions& given, picture::Layout layout, std::size_t slots) {
    if (layout != picture::Layout::split || slots != 2)
        refuseUsage("--split: only two techniques in --layout split have a line between them; leave it out");
    const std::string text = given.text("--split");
    double share = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
    if (error != std::errc{} || end != text.data() + text.size() || !(share >= 0 && share <= 1))
        refuseUsage("--split: '" + text + "' is no share of the width; write a number from 0 to 1, as 0.35");
    return share;
}

/// The stage of each technique: `STAGE` is that of all of them, `2:STAGE` that of the second. (pass:ID has a colon, too,
/// but no number before it.)
std::vector<picture::StageRef> stagesFor(const GivenOptions& given, std::size_t slots) {
    std::vector<picture::StageRef> stages(slots);
    for (const std::string& text : given.texts("--stage")) {
        std::size_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool ofOne = error == std::errc{} && end != text.data() + text.size() && *end == ':';
        if (ofOne && (number < 1 || number > slots))
            refuseUsage("--stage: '" + text + "': the techniques are numbered from 1 to " + std::to_string(slots) +
                        "; use one of these numbers");
        const std::string stage = ofOne ? std::string(end + 1, text.data() + text.size()) : text;
        if (stage.empty()) refuseUsage("--stage: '" + text + "' names no stage; `list stages` shows what there is");
        for (std::size_t i = 0; i < slots; ++i) {
            if (ofOne && i + 1 != number) continue;
            if (!stages[i].isPicture())
                refuseUsage("--stage: technique " + std::to_string(i + 1) + " has a stage already; give it one");
            stages[i] = picture::StageRef::parse(stage);
        }
    }
    return stages;
}

/// "3,2,5,0,0,0": where the second camera stands, and where it looks.
std::array<double, 6> outsideFor(const GivenOptions& given, const std::vector<picture::StageRef>& stages) {
    const std::string text = given.text("--outside");
    if (std::ranges::none_of(stages, &picture::StageRef::isOutside))
        refuseUsage("--outside: only the stage outside has a second camera; add --stage outside");
    std::array<double, 6> numbers{};
    const char *at = text.data(), *const last = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [end, error] = std::from_chars(at, last, numbers[i]);
        const bool follows = i + 1 < numbers.size() ? end != last && *end == ',' : end == last;
        if (error != std::errc{} || !follows || !std::isfinite(numbers[i]))
            refuseUsage("--outside: '" + text +
                        "' is not six numbers; write X,Y,Z of the camera and of what it looks at, "
                        "as 3,2,5,0,0,0");
        at = end + 1;
    }
    return numbers;
}

/// A pixel that the window has picked, or that a stage is about.
ivec2 pickedFor(const std::string& option, const GivenOptions& given, const CaptureOptions& options) {
    bool isUsed = options.ui;
    for (std::size_t i = 0; i < options.stages.size(); ++i)
        isUsed = isUsed || (!options.stages[i].isPass &&
                            picture::followsPicked(findTechnique(options.techniques[i]), options.stages[i].id));
    if (!isUsed)
        refuseUsage(option +
                    ": only the window and stages about one pixel, as outside and radiosity's form-factors, show "
                    "it; add --stage outside or --ui, or ask `shadowlab probe`");
    return pixelFrom(option, given.text(option), options.size);
}

int rowFor(const GivenOptions& given, const std::vector<picture::StageRef>& stages, ivec2 size) {
    if (std::ranges::none_of(stages, &picture::StageRef::isScanline))
        refuseUsage("--row: only the stage scanline is about one row; add --stage scanline");
    const std::string text = given.text("--row");
    int row = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), row);
    if (error != std::errc{} || end != text.data() + text.size() || row < 0 || row >= size.y)
        refuseUsage("--row: '" + text + "' is not a row of the picture; write a whole number from 0 to " +
                    std::to_string(size.y - 1));
    return row;
}

/// Refuses what cannot be in one file with others.
void checkFilm(const CaptureOptions& options) {
    const std::string film = options.steps ? "--steps" : "--animate";
    if (options.steps && options.animate)
        refuseUsage("--steps goes through the steps of one moment, --animate through moments; give one of them");
    if (!options.stats.empty()) refuseUsage("--stats: not with " + film + "; leave one of them out");
    if (options.animate) {
        if (options.motion.frames.value_or(1) == 1 && options.motion.path.empty())
            refuseUsage("--animate: one frame is no animation; add --frames N");
        if (!options.ui && options.techniques.size() == 1 && options.stages[0].isVisibility())
            refuseUsage("--animate: the visibility image holds measured shares, not colours; write its frames to "
                        "name_####.png, or choose another stage");
        return;
    }
    if (options.techniques.size() > 1)
        refuseUsage("--steps: " + std::to_string(options.techniques.size()) +
                    " techniques are given with -t, and each has steps of its own; give one");
    if (!options.stages[0].isPicture()) refuseUsage("--steps: every step has a picture of its own; leave --stage out");
    if (options.motion.frames || options.motion.orbitLightDegrees || options.motion.orbitCameraDegrees ||
        !options.motion.path.empty())
        refuseUsage(
            "--steps: all steps are of one moment; leave --frames, --orbit-light, --orbit-camera and --path out");
}

/// How long a step, or a frame, stays.
image::FrameTime timeFor(const GivenOptions& given, const CaptureOptions& options) {
    constexpr int kMostRate = 120;
    if (given.has("--hold") && !options.steps) refuseUsage("--hold: only steps are held; add --steps");
    if (given.has("--fps") && !options.animate) refuseUsage("--fps: only an animation has a rate; add --animate");
    if (options.animate)
        return {1, static_cast<std::uint16_t>(countFrom("--fps", given.text("--fps", "25"), kMostRate))};
    return {static_cast<std::uint16_t>(std::lround(secondsFrom("--hold", given.text("--hold", "2")) * 1000)), 1000};
}

} // namespace

std::filesystem::path numbered(const std::filesystem::path& pattern, int frame) {
    std::string name = pattern.filename().string();
    const std::size_t first = name.find('#');
    if (first == std::string::npos) return pattern;
    const std::size_t width = name.find_first_not_of('#', first) == std::string::npos
                                  ? name.size() - first
                                  : name.find_first_not_of('#', first) - first;
    std::string number = std::to_string(frame + 1);
    if (number.size() < width) number.insert(0, width - number.size(), '0');
    return pattern.parent_path() / name.replace(first, width, number);
}

void requirePlaceForNumbers(const CaptureOptions& options, int frames) {
    if (frames > 1 && !isFilm(options) && options.output.filename().string().find('#') == std::string::npos)
        refuseUsage("-o: '" + options.output.string() + "' has no place for the numbers of " + std::to_string(frames) +
                    " frames; write for example name_####.png, or add --animate");
}

void describeCapture(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    add("SCENE", "", "a built-in name (`list scenes`), a .json scene or an .obj mesh");
    add("-o,--output", "OUT.png",
        "the picture; for several frames with #### in place of the number; with --steps or --animate an animated PNG, "
        "or a "
        "film if it ends in .mp4");
    add("-t,--technique", "ID[,ID...]", "techniques, one a slot (`list techniques`; default shadow-volume-zfail)");
    add("--layout", "LAYOUT",
        "single, side, split, grid, or diff: where two differ and who is right (default: single for one technique, "
        "else side)");
    add("--split", "SHARE", "of the width that the left one of two in --layout split has (default 0.5)");
    add("--labels", "true|false", "titles on the pictures of several techniques (default true)");
    add("--stage", "[SLOT:]STAGE",
        "an intermediate picture: STAGE, STAGE@LIGHT or pass:ID (`list stages`), of all techniques or of one; may be "
        "repeated");
    add("--row", "Y", "the row of the stage scanline, from the top (default: the one with most wrong pixels)");
    add("--outside", "X,Y,Z,X,Y,Z",
        "where the second camera of the stage outside stands, and where it looks (default: a good place)");
    add("--pixel", "X,Y",
        "the pixel whose rays the stage outside shows, in place of a few of all, or whose patch radiosity's "
        "form-factors "
        "are of; with --ui the one that is picked");
    add("--partner", "X,Y",
        "a second pixel beside --pixel, whose patch radiosity shows with the first one's; other techniques take no "
        "notice");
    add("--size", "WxH", "width and height of the whole picture in pixels (default 1280x720)");
    add("--supersample", "N",
        "average N x N samples a pixel in linear light (default 1; never for stages about visibility)");
    add("--set", "[SLOT:]ID.PARAM=VALUE", "a parameter (`list parameters`), of all slots or of one; may be repeated");
    add("--light", "NAME", "the light that the stage is about (default: the first)");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    command.add_flag("--ui")->description("the window with all its widgets around the pictures, as `demo` shows it");
    command.add_flag("--presenter")->description("with --ui: large type and high contrast");
    command.add_flag("--keys")->description("with --ui: the list of all keys over it");
    add("--source", "true|false",
        "with --ui: formula, pseudocode and source of the step that --stage pass:ID shows, beside its picture (default "
        "false)");
    add("--stats", "FILE.json", "writes times in milliseconds, counters and settings");
    describeMotion(command);
    command.add_flag("--animate")->description("all frames in one file, an animated PNG or an MP4 film");
    add("--fps", "N", "with --animate: frames a second (default 25)");
    command.add_flag("--steps")->description(
        "all steps of the technique in one file, an animated PNG or an MP4 film, each with its title below");
    add("--hold", "SECONDS", "with --steps: how long each stays (default 2)");
    add("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    command.footer(
        "Examples:\n"
        "  shadowlab capture still-life -o still-life.png\n"
        "  shadowlab capture bunny.obj -t shadow-map,shadow-volume-zfail --set shadow-map.resolution=256 -o both.png\n"
        "  shadowlab capture still-life --frames 90 --orbit-light 360 -o frames/turn_####.png\n"
        "  shadowlab capture still-life -t shadow-map --steps --hold 3 -o steps.png\n"
        "  shadowlab capture still-life --frames 90 --orbit-light 360 --animate -o turn.mp4");
}

CaptureOptions captureOptions(const CLI::App& command) {
    const GivenOptions given(command);
    const std::string example = "shadowlab capture SCENE -o OUT.png";
    CaptureOptions options;
    options.scene = given.required("SCENE", example);
    options.output = given.required("--output", example);
    options.steps = command.count("--steps") > 0;
    options.animate = command.count("--animate") > 0;
    if (!isFilm(options) && film::isMp4(options.output))
        refuseUsage("-o: '" + options.output.string() +
                    "' is a film, and this is one picture; add --steps, or --frames N and --animate, or write a .png");
    if (!film::isMp4(options.output)) requireEnding("-o", options.output, ".png");
    if (given.has("--technique")) options.techniques = splitAtCommas(given.texts("--technique"));
    options.layout = layoutFor(given, options.techniques.size());
    options.labels = booleanFrom("--labels", given.text("--labels", "true"));
    options.stages = stagesFor(given, options.techniques.size());
    options.settings = given.texts("--set");
    std::vector<std::string> stageIds;
    for (const picture::StageRef& stage : options.stages)
        stageIds.push_back(stage.isPass ? "" : stage.id);
    lab::respell(options.techniques, stageIds, options.settings);
    const bool anyStage = !std::ranges::all_of(options.stages, &picture::StageRef::isPicture);
    if (options.layout == picture::Layout::diff && anyStage)
        refuseUsage("--stage: --layout diff compares the finished pictures; leave one of them out");
    if (given.has("--split")) options.split = splitFor(given, options.layout, options.techniques.size());
    options.ui = command.count("--ui") > 0;
    options.presenter = command.count("--presenter") > 0;
    options.keys = command.count("--keys") > 0;
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
    if (options.layout == picture::Layout::diff || std::ranges::any_of(options.stages, [](const picture::StageRef& stage) {
            return stage.isVisibility() || stage.isDerived();
        }))
        options.supersample = 1;
    if (given.has("--outside")) options.outside = outsideFor(given, options.stages);
    if (given.has("--pixel")) options.pixel = pickedFor("--pixel", given, options);
    if (given.has("--partner")) {
        if (!options.pixel)
            refuseUsage("--partner: it is the second of two pixels; add the first one with --pixel X,Y");
        options.partner = pickedFor("--partner", given, options);
    }
    if (given.has("--row")) options.row = rowFor(given, options.stages, options.size);
    options.light = given.text("--light");
    options.backend = context::backendFromName(given.text("--backend", "auto"));
    options.stats = given.text("--stats");
    if (!options.stats.empty()) requireEnding("--stats", options.stats, ".json");
    options.motion = motionOptions(given);
    if (isFilm(options)) checkFilm(options);
    options.time = timeFor(given, options);
    options.allowed = given.allowedFolders();
    requirePlaceForNumbers(options, options.motion.frames.value_or(1));
    requireDrawable(options);
    return options;
}

int requireDrawable(const CaptureOptions& options) {
    const int panels = static_cast<int>(options.techniques.size());
    const std::string asked =
        "--size " + std::to_string(options.size.x) + "x" + std::to_string(options.size.y) +
        (options.supersample > 1 ? " with --supersample " + std::to_string(options.supersample) : "");
    int longest = 0;
    std::int64_t samples = 0;
    for (const picture::Cell& cell : picture::layoutCells(options.layout, panels, options.size, options.split)) {
        // A split line at the very edge leaves one picture alone; that is no fault of the size.
        const bool hidden = options.layout == picture::Layout::split && cell.width == 0 && panels == 2;
        if (!hidden && std::min({cell.width, cell.height, cell.pictureSize.x, cell.pictureSize.y}) < 1)
            refuseUsage(asked + " is too small for " + std::to_string(panels) + " pictures; choose a larger size");
        const ivec2 drawn = cell.pictureSize * options.supersample;
        longest = std::max({longest, drawn.x, drawn.y});
        samples += std::int64_t{drawn.x} * drawn.y;
    }
    const std::string mend =
        std::string("choose a smaller --size") + (options.supersample > 1 ? " or --supersample" : "");
    const picture::PictureLimits& limits = picture::pictureLimits();
    if (static_cast<std::uint32_t>(longest) > limits.side)
        throw Error(ExitStatus::overLimit, asked + " needs " + std::to_string(longest) +
                                               " samples on a side, the limit is " + std::to_string(limits.side) +
                                               "; " + mend + ", or set --limit picture-side=VALUE");
    if (static_cast<std::uint64_t>(samples) > limits.samples)
        throw Error(ExitStatus::overLimit, asked + " needs " + std::to_string(samples) + " samples, the limit is " +
                                               std::to_string(limits.samples) + "; " + mend +
                                               ", or set --limit picture-samples=VALUE");
    picture::reserveForPictures(static_cast<std::uint64_t>(samples), picture::kBytesPerDrawnSample, asked, mend);
    return longest;
}

} // namespace shadowlab::cli
