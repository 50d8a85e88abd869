// SPDX-License-Identifier: MIT
#include "app/cli/probe_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/capture_options.h"
#include "app/cli/option_values.h"
#include "app/figures/figures.h"
#include "app/lab/old_spelling.h"

namespace shadowlab::cli {

void describeProbe(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    add("SCENE", "", "a built-in name (`list scenes`), a .json scene or an .obj mesh");
    add("--pixel", "X,Y", "column and row of the pixel, counted from 0 at the upper left corner");
    add("--partner", "X,Y",
        "a second pixel: radiosity tells what its patch and the first one's send each other; other techniques take no "
        "notice");
    add("-t,--technique", "ID", "the technique that is asked (`list techniques`; default shadow-volume-zfail)");
    add("--size", "WxH", "width and height in pixels of the picture that the pixel belongs to (default 1280x720)");
    add("--set", "ID.PARAM=VALUE", "a parameter (`list parameters`); may be repeated");
    add("--light", "NAME", "the light that is asked about (default: the first)");
    command.add_flag("--json")->description("one JSON object instead of lines");
    add("--diagram", "OUT",
        "draws the lecture's figure from that pixel: faces of shadow volumes and their counts, texels of a shadow map, "
        "or a projected shadow, in the plane through eye, light and point; of ray tracing the pixel's rays and their "
        "tree; of radiosity two patches with the angles of their form factor. OUT ends in .svg, or in .png for a "
        "picture");
    add("--figure", "NAME", "which figure --diagram draws (`list figures`; default pixel, all that the technique has)");
    add("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    command.footer("Needs no graphics card.\n"
                   "Examples:\n"
                   "  shadowlab probe still-life --pixel 640,360\n"
                   "  shadowlab probe still-life --pixel 700,420 -t shadow-volume --diagram count.svg\n"
                   "  shadowlab probe mirror-and-glass --pixel 500,420 -t ray-traced --diagram tree.svg\n"
                   "  shadowlab probe cornell-room --pixel 500,690 --partner 300,400 -t radiosity --diagram pair.svg\n"
                   "  shadowlab probe still-life --pixel 640,360 -t shadow-map --set shadow-map.resolution=512 --json");
}

bool isPicture(const std::filesystem::path& diagram) { return diagram.extension() == ".png"; }

ProbeOptions probeOptions(const CLI::App& command) {
    const GivenOptions given(command);
    const std::string example = "shadowlab probe SCENE --pixel X,Y";
    ProbeOptions options;
    options.scene = given.required("SCENE", example);
    options.size = sizeFrom("--size", given.text("--size", "1280x720"), "picture-side");
    options.pixel = pixelFrom("--pixel", given.required("--pixel", example), options.size);
    if (given.has("--partner")) options.partner = pixelFrom("--partner", given.text("--partner"), options.size);
    std::vector<std::string> techniques =
        given.has("--technique") ? splitAtCommas(given.texts("--technique")) : std::vector{options.technique};
    if (techniques.size() != 1) refuseUsage("-t: one technique is asked at a time; write it alone");
    options.settings = given.texts("--set");
    lab::respell(techniques, {}, options.settings);
    options.technique = techniques.front();
    options.light = given.text("--light");
    options.json = command.count("--json") > 0;
    options.diagram = given.text("--diagram");
    if (!options.diagram.empty())
        requireEnding("--diagram", options.diagram, isPicture(options.diagram) ? ".png" : ".svg");
    if (given.has("--figure") && options.diagram.empty())
        refuseUsage("--figure is drawn into a file; write --diagram OUT.svg or OUT.png, too");
    options.figure = figures::findFigure(given.text("--figure", options.figure)).name;
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace shadowlab::cli
