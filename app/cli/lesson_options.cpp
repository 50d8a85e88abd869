// SPDX-License-Identifier: MIT
#include "app/cli/lesson_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/capture_options.h"
#include "app/cli/option_values.h"
#include "app/film/film.h"

namespace shadowlab::cli {

void describeLesson(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    add("LESSON", "", "a built-in name (`list lessons`) or a .json lesson");
    add("-o,--output", "OUT.png", "draws it: pictures, title, sentences, and what to look at");
    add("--state", "STATE", "what to draw: before, after or both, side by side (default both)");
    add("--size", "WxH", "width and height of the picture in pixels (default 1600x900, with --animate 1280x720)");
    command.add_flag("--animate")
        ->description("question, answer, artefact and mend one after the other in one file, an animated PNG or, if -o "
                      "ends in .mp4, a film; each with its words below");
    add("--hold", "SECONDS",
        "with --animate: how long each picture stays (default: as long as its words take to read)");
    command.add_flag("--measure")
        ->description("prints what is measured before and after beside what it has to be (without -o the default)");
    command.add_flag("--json")->description("the numbers as one JSON object instead of a table");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    add("--allow", "DIR", "a further folder that the lesson's scene may take meshes from; may be repeated");
    command.footer("Exit status 3 when a number is not as the lesson says.\n"
                   "Examples:\n"
                   "  shadowlab lesson acne -o acne.png\n"
                   "  shadowlab lesson acne --measure\n"
                   "  shadowlab lesson acne --animate -o acne.mp4\n"
                   "  shadowlab demo --lesson acne");
}

LessonOptions lessonOptions(const CLI::App& command) {
    const GivenOptions given(command);
    LessonOptions options;
    options.lesson = given.required("LESSON", "shadowlab lesson NAME -o OUT.png");
    options.json = command.count("--json") > 0;
    options.animate = command.count("--animate") > 0;
    if (given.has("--output")) {
        options.output = given.text("--output");
        if (film::isMp4(options.output) && !options.animate)
            refuseUsage("-o: '" + options.output.string() +
                        "' is a film, and this is one picture; add --animate, or write a .png");
        if (!film::isMp4(options.output)) requireEnding("-o", options.output, ".png");
    }
    for (const char* option : {"--state", "--size", "--animate"})
        if (command.count(option) > 0 && options.output.empty())
            refuseUsage(std::string(option) + ": only a picture has it; add -o OUT.png");
    if (given.has("--state") && options.animate)
        refuseUsage("--state: an animation shows both states one after the other; leave --state or --animate out");
    if (given.has("--hold") && !options.animate)
        refuseUsage("--hold: only the pictures of an animation are held; add --animate");
    if (given.has("--hold")) options.holdSeconds = secondsFrom("--hold", given.text("--hold", ""));
    options.measure = command.count("--measure") > 0 || options.output.empty();
    if (options.json && !options.measure) refuseUsage("--json: nothing is printed; add --measure");
    const std::vector<std::vector<std::size_t>> states = {{0}, {1}, {0, 1}};
    options.states = states[static_cast<std::size_t>(
        choiceFrom("--state", given.text("--state", "both"), {"before", "after", "both"}))];
    options.size = sizeFrom("--size", given.text("--size", options.animate ? "1280x720" : "1600x900"), "picture-side");
    options.backend = context::backendFromName(given.text("--backend", "auto"));
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace shadowlab::cli
