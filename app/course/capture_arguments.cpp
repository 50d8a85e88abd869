// SPDX-License-Identifier: MIT
#include "app/course/capture_arguments.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "app/context/software.h"
#include "app/picture/derived_stages.h"
#include "app/picture/limits.h"
#include "app/picture/steps/stepping.h"
#include "app/student/plugins.h"

namespace shadowlab::course {

namespace {

/// The shortest digits that mean just this number.
std::string exactText(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} ? std::string(text.data(), end) : std::string("0.5");
}

bool isPlain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./=:,@+").find(c) != std::string_view::npos;
}

std::string pixelText(ivec2 pixel) { return std::to_string(pixel.x) + "," + std::to_string(pixel.y); }

/// What the pane shows, as `--stage` has it: for a step the stage that shows what the pass wrote, if there is one.
std::string stageWord(const lab::Document& document, const lab::PaneState& state) {
    if (!state.stage.isPass) return state.stage.text();
    const TechniqueInfo& info = findTechnique(state.technique);
    const int light = picture::stageLight(*document.scene, document.light);
    const picture::ResolvedStage shown =
        picture::shownInStep(picture::resolve(state.stage, info, *document.scene, light), info, light);
    return shown.isPass ? state.stage.text() : picture::refOf(shown.key, false, *document.scene).text();
}

} // namespace

std::string_view layoutName(picture::Layout layout) {
    constexpr std::array<std::string_view, 5> kNames = {"single", "side", "split", "grid", "diff"};
    return kNames[static_cast<std::size_t>(layout)];
}

std::vector<std::string> captureArguments(const lab::Document& document, const std::filesystem::path& sceneFile,
                                      const std::filesystem::path& picture, ivec2 size) {
    const bool single = document.layout == picture::Layout::single;
    const bool diff = document.layout == picture::Layout::diff;
    const int count = lab::shownPanes(document.layout);
    std::string techniques;
    std::vector<std::string> more;
    for (int i = 0; i < count; ++i) {
        const lab::PaneState& state = document.panes[static_cast<std::size_t>(single ? document.active : i)];
        const std::string slot = single ? "" : std::to_string(i + 1) + ":";
        techniques += (i ? "," : "") + state.technique;
        // A difference is of the finished pictures, whatever the panes show in other layouts.
        if (!state.stage.isPicture() && !diff) more.insert(more.end(), {"--stage", slot + stageWord(document, state)});
        for (const auto& [param, value] : state.values())
            more.insert(more.end(), {"--set", slot + state.technique + "." + param + "=" + value});
    }
    std::vector<std::string> words = {
        "capture", sceneFile.string(), "-o",     picture.string(),
        "-t",      techniques,         "--size", std::to_string(size.x) + "x" + std::to_string(size.y)};
    if (!single) words.insert(words.end(), {"--layout", std::string(layoutName(document.layout))});
    if (document.layout == picture::Layout::split) words.insert(words.end(), {"--split", exactText(document.split)});
    bool outside = false, isAboutPicked = false, errors = diff;
    for (int i = 0; i < count && !diff; ++i) {
        const lab::PaneState& state = document.panes[static_cast<std::size_t>(single ? document.active : i)];
        errors = errors || state.stage.isError();
        outside = outside || state.stage.isOutside();
        isAboutPicked = isAboutPicked || picture::windowFollowsPicked(findTechnique(state.technique), state.stage);
    }
    if (errors) words.insert(words.end(), {"--enlarge", "true"});
    if (outside) {
        std::string place;
        for (const dvec3& point : {document.outsideCamera.positionWorld, document.outsideCamera.targetWorld})
            for (int axis = 0; axis < 3; ++axis)
                place += (place.empty() ? "" : ",") + exactText(point[axis]);
        words.insert(words.end(), {"--outside=" + place});
        if (const std::string volumes = picture::volumesText(document.outsideChoice, *document.scene); !volumes.empty())
            words.insert(words.end(), {"--volumes", volumes});
        if (document.outsideChoice.nearClipPyramid) words.emplace_back("--near-clip");
    }
    if (isAboutPicked) {
        const ivec2 shown = picture::layoutCells(document.layout, count, size, document.split).front().pictureSize;
        for (const auto& [option, place] :
             {std::pair("--pixel", document.picked), std::pair("--partner", document.partner)})
            if (place) words.insert(words.end(), {option, pixelText(lab::pixelAt(*place, shown))});
    }
    const auto& lights = document.scene->lights;
    if (document.light > 0 && document.light < static_cast<int>(lights.size()))
        words.insert(words.end(), {"--light", lights[static_cast<std::size_t>(document.light)].name});
    words.insert(words.end(), more.begin(), more.end());
    const std::vector<std::string> global = globalArguments();
    words.insert(words.end(), global.begin(), global.end());
    return words;
}

std::vector<std::string> globalArguments() {
    std::vector<std::string> words;
    for (const student::LoadedPlugin& plugin : student::loadedPlugins())
        words.insert(words.end(), {"--plugin", plugin.file});
    if (context::isSoftwareDemanded()) words.emplace_back("--software");
    const std::vector<std::string> limits = picture::limitWords();
    words.insert(words.end(), limits.begin(), limits.end());
    return words;
}

std::string asCommandLine(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        bool plain = !word.empty();
        for (const char c : word)
            plain = plain && isPlain(c);
        if (!line.empty()) line += ' ';
        if (plain) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word)
            line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

} // namespace shadowlab::course
