// SPDX-License-Identifier: MIT
#include "app/cli/capture/capture_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/option_values.h"
#include "app/picture/derived_stages.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

namespace {

const std::vector<std::string> kLayouts = {"single", "side", "split", "grid",
                                           "diff"}; ///< in the order of picture::Layout

} // namespace

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

// pass:ID has a colon, too, but no number before it.
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

image::FrameTime timeFor(const GivenOptions& given, const CaptureOptions& options) {
    constexpr int kMostRate = 120;
    if (given.has("--hold") && !options.steps) refuseUsage("--hold: only steps are held; add --steps");
    if (given.has("--fps") && !options.animate) refuseUsage("--fps: only an animation has a rate; add --animate");
    if (options.animate)
        return {1, static_cast<std::uint16_t>(countFrom("--fps", given.text("--fps", "25"), kMostRate))};
    return {static_cast<std::uint16_t>(std::lround(secondsFrom("--hold", given.text("--hold", "2")) * 1000)), 1000};
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
    const std::string remedy =
        std::string("choose a smaller --size") + (options.supersample > 1 ? " or --supersample" : "");
    const picture::PictureLimits& limits = picture::pictureLimits();
    if (static_cast<std::uint32_t>(longest) > limits.side)
        throw Error(ExitStatus::overLimit, asked + " needs " + std::to_string(longest) +
                                               " samples on a side, the limit is " + std::to_string(limits.side) +
                                               "; " + remedy + ", or set --limit picture-side=VALUE");
    if (static_cast<std::uint64_t>(samples) > limits.samples)
        throw Error(ExitStatus::overLimit, asked + " needs " + std::to_string(samples) + " samples, the limit is " +
                                               std::to_string(limits.samples) + "; " + remedy +
                                               ", or set --limit picture-samples=VALUE");
    picture::reserveForPictures(static_cast<std::uint64_t>(samples), picture::kBytesPerDrawnSample, asked, remedy);
    return longest;
}

} // namespace shadowlab::cli
