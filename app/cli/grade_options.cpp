// SPDX-License-Identifier: MIT
#include "app/cli/grade_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/option_values.h"
#include "app/context/context.h"

namespace shadowlab::cli {

namespace {

constexpr int kMostSeconds = 3600, kMostMiB = 1 << 20;

} // namespace

void describeGrade(CLI::App& command) {
    const auto add = [&](const char* names, const char* value, const char* help) {
        addOption(command, names, value, help);
    };
    add("-t,--technique", "ID", "which of the plug-in's techniques, where it has several");
    add("--family", "FAMILY", "planar, shadow-map or shadow-volume (default: what the plug-in's CMakeLists.txt says)");
    add("-o,--output", "DIR", "a folder for the picture of the first failing case; it is made where there is none");
    add("--time-limit", "SECONDS", "for each case (default 30)");
    add("--memory-limit", "MIB", "for each case (default 2048)");
    add("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
    command.add_flag("--json")->description("one JSON object instead of a table");
    command.footer("The exit status is 0 where all cases are right, and 1 where some are not.\n"
                   "Examples:\n"
                   "  shadowlab grade --plugin build/anna.so\n"
                   "  shadowlab grade --plugin build/anna.so --family shadow-volume -o sheets --json");
}

GradeOptions gradeOptions(const CLI::App& command, const std::vector<std::string>& plugins) {
    const GivenOptions given(command);
    GradeOptions options;
    if (plugins.size() != 1)
        refuseUsage(plugins.empty() ? "grade: --plugin is missing; write shadowlab grade --plugin FILE.so"
                                    : "grade: --plugin is given " + std::to_string(plugins.size()) +
                                          " times; grade one plug-in after the other");
    options.plugin = plugins.front();
    options.technique = given.text("--technique");
    options.family = given.text("--family");
    options.output = given.text("--output");
    options.limits.time =
        std::chrono::seconds(countFrom("--time-limit", given.text("--time-limit", "30"), kMostSeconds));
    options.limits.memoryBytes =
        static_cast<std::uint64_t>(countFrom("--memory-limit", given.text("--memory-limit", "2048"), kMostMiB)) << 20;
    options.backend = given.text("--backend", options.backend);
    context::backendFromName(options.backend); // throws for one that there is not
    options.json = command.count("--json") > 0;
    return options;
}

} // namespace shadowlab::cli
