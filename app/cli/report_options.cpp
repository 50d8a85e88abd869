// SPDX-License-Identifier: MIT
#include "app/cli/report_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/measure_options.h"
#include "app/cli/option_values.h"

namespace shadowlab::cli {

namespace {

/// `report merge DIR...`: nothing is drawn, so nothing may be asked of the drawing.
void refuseDrawingOptions(const GivenOptions& given, const CLI::App& command) {
    for (const char* option : {"--technique", "--light", "--size", "--shard", "--backend", "--allow"})
        if (given.has(option)) refuseUsage(std::string(option) + ": `report merge` draws nothing; leave it out");
    if (command.count("--quick") > 0) refuseUsage("--quick: `report merge` draws nothing; leave it out");
}

/// `report --hard`: the cases say which scenes, techniques, lights and sizes.
void refuseSceneOptions(const GivenOptions& given, const std::vector<std::string>& scenes) {
    if (!scenes.empty()) refuseUsage("--hard has scenes of its own; leave '" + scenes.front() + "' out");
    for (const char* option : {"--technique", "--light", "--size", "--shard"})
        if (given.has(option)) refuseUsage(std::string(option) + ": the hard cases say that themselves; leave it out");
}

} // namespace

void describeReport(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    addArguments(command, "SCENE",
                 "a built-in name, a .json scene or an .obj mesh; may be repeated (default: all built-in scenes)");
    add("-o,--output", "DIR", "the folder of the report; where one was begun there, it goes on");
    add("-t,--technique", "ID[,ID...]",
        "techniques (`list techniques`; default all that say what they make of a light)");
    add("--light", "NAME", "the light whose shadows are judged (default: the first of each scene)");
    add("--size", "WxH", "width and height in pixels (default 1280x720; with --quick 640x360)");
    command.add_flag("--quick")->description("three scenes, few points and few frames: under two minutes on two cores");
    command.add_flag("--hard")->description(
        "the hard cases instead: what each technique makes of them, and whether careless versions are caught");
    add("--shard", "I/N", "only the I-th of N parts, for a scheduler that runs the others; `report merge` joins them");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    add("--allow", "DIR", "a further folder that the scenes may take meshes from; may be repeated");
    command.footer("Writes DIR/index.html (open it in a browser), report.json, points.csv and charts/*.svg.\n"
                   "`shadowlab report merge DIR... -o DIR` puts the parts of a report together.\n"
                   "Examples:\n"
                   "  shadowlab report --quick -o report\n"
                   "  shadowlab report still-life -t shadow-map,shadow-volume-zfail -o report\n"
                   "  shadowlab report -o part-2 --shard 2/4\n"
                   "  shadowlab report --hard -o hard\n"
                   "  shadowlab report merge part-1 part-2 part-3 part-4 -o report");
}

ReportOptions reportOptions(const CLI::App& command) {
    const GivenOptions given(command);
    ReportOptions options;
    options.output = given.required("--output", "shadowlab report -o DIR");
    std::vector<std::string> words = given.texts("SCENE");
    if (!words.empty() && words.front() == "merge") {
        refuseDrawingOptions(given, command);
        if (words.size() == 1)
            refuseUsage("report merge: no folder is named; write shadowlab report merge part-1 part-2 -o DIR");
        options.merged.assign(words.begin() + 1, words.end());
        return options;
    }
    options.scenes = std::move(words);
    options.isQuick = command.count("--quick") > 0;
    options.isHard = command.count("--hard") > 0;
    if (options.isHard) refuseSceneOptions(given, options.scenes);
    if (given.has("--technique")) options.techniques = measuredTechniquesFrom(given.texts("--technique"));
    options.light = given.text("--light");
    options.size = sizeFrom("--size", given.text("--size", options.isQuick ? "640x360" : "1280x720"), "measured-side");
    reserveForMeasured(options.size);
    if (given.has("--shard")) options.shard = report::shardFrom(given.text("--shard"));
    options.backend = context::backendFromName(given.text("--backend", "auto"));
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace shadowlab::cli
