// SPDX-License-Identifier: MIT
#include "app/cli/measure_options.h"

#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/option_values.h"
#include "app/lab/old_spelling.h"
#include "app/picture/limits.h"
#include "techniques/registry.h"

namespace shadowlab::cli {

std::vector<std::string> measuredTechniquesFrom(const std::vector<std::string>& texts) {
    std::vector<std::string> ids = splitAtCommas(texts);
    std::optional<TechniqueGroup> group;
    if (ids == std::vector<std::string>{"all"}) group = TechniqueGroup::production;
    if (ids == std::vector<std::string>{"lecture"}) group = TechniqueGroup::lecture;
    if (!group) return ids;
    ids.clear();
    for (const RegisteredTechnique& technique : techniquesOf(*group))
        if (publishes(*technique.info, kVisibilityStage))
            ids.emplace_back(technique.info->id);
    return ids;
}

void describeMeasure(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    add("SCENE", "", "a built-in name (`list scenes`), a .json scene or an .obj mesh");
    add("-t,--technique", "ID[,ID...]",
        "techniques (`list techniques`; default shadow-volume-zfail), all, or lecture for the lecture's own");
    add("--size", "WxH", "width and height in pixels (default 1280x720)");
    add("--set", "[SLOT:]ID.PARAM=VALUE", "a parameter (`list parameters`), of all slots or of one; may be repeated");
    add("--light", "NAME", "the light whose shadows are judged (default: the first)");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    describeMotion(command);
    command.add_flag("--json")->description("one JSON object instead of a table");
    add("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    command.footer("Times are medians over the frames; errors are those of the first frame; flips are of all frames.\n"
                   "Examples:\n"
                   "  shadowlab measure still-life -t all\n"
                   "  shadowlab measure bunny.obj -t shadow-map --set shadow-map.resolution=512 --json\n"
                   "  shadowlab measure still-life -t shadow-map --frames 60 --orbit-light 6");
}

void reserveForMeasured(ivec2 size) {
    picture::reserveForPictures(
        static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y), picture::kBytesPerMeasuredPixel,
        "--size " + std::to_string(size.x) + "x" + std::to_string(size.y), "choose a smaller --size");
}

MeasureOptions measureOptions(const CLI::App& command) {
    const GivenOptions given(command);
    MeasureOptions options;
    options.scene = given.required("SCENE", "shadowlab measure SCENE");
    if (given.has("--technique")) options.techniques = measuredTechniquesFrom(given.texts("--technique"));
    options.size = sizeFrom("--size", given.text("--size", "1280x720"), "measured-side");
    reserveForMeasured(options.size);
    options.settings = given.texts("--set");
    lab::respell(options.techniques, {}, options.settings);
    options.light = given.text("--light");
    options.backend = context::backendFromName(given.text("--backend", "auto"));
    options.motion = motionOptions(given);
    options.json = command.count("--json") > 0;
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace shadowlab::cli
