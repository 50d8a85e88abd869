// `shadowlab report`: what is asked for, and the merging of parts that were measured apart.
// SPDX-License-Identifier: MIT
#include "app/cli/report.h"

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/measure.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/report/assemble.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::cli {

namespace {

void describeReport(DescribedOptions& add) {
    add.arguments("SCENE",
                  "a built-in name, a .json scene or a mesh (.obj, .gltf, .glb); may be repeated (default: all built-in scenes)");
    add.option("-o,--output", "DIR", "the folder of the report; where one was begun there, it goes on");
    add.option("-t,--technique", "ID[,ID...]",
               "techniques (`list techniques`; default all that say what they make of a light)");
    add.option("--light", "NAME", "the light whose shadows are judged (default: the first of each scene)");
    add.option("--size", "WxH", "width and height in pixels (default 1280x720; with --quick 640x360)");
    add.flag("--quick", "three scenes, few points and few frames: under two minutes on two cores");
    add.flag("--hard",
             "the hard cases instead: what each technique makes of them, and whether careless versions are caught");
    add.option("--shard", "I/N",
               "only the I-th of N parts, for a scheduler that runs the others; `report merge` joins them");
    describeBackend(add);
    add.option("--allow", "DIR", "a further folder that the scenes may take meshes from; may be repeated");
    add.footer("Writes DIR/index.html (open it in a browser), report.json, points.csv and charts/*.svg.\n"
               "`shadowlab report merge DIR... -o DIR` puts the parts of a report together.\n"
               "Examples:\n"
               "  shadowlab report --quick -o report\n"
               "  shadowlab report still-life -t shadow-map,shadow-volume-zfail -o report\n"
               "  shadowlab report -o part-2 --shard 2/4\n"
               "  shadowlab report --hard -o hard\n"
               "  shadowlab report merge part-1 part-2 part-3 part-4 -o report");
}

/// `report merge DIR...`: nothing is drawn, so options of the drawing have no meaning.
void refuseDrawingOptions(const GivenOptions& given) {
    for (const char* option : {"--technique", "--light", "--size", "--shard", "--backend", "--allow"})
        if (given.has(option)) refuseUsage(std::string(option) + ": `report merge` draws nothing; leave it out");
    if (given.has("--quick")) refuseUsage("--quick: `report merge` draws nothing; leave it out");
}

/// `report --hard`: the cases say which scenes, techniques, lights and sizes.
void refuseSceneOptions(const GivenOptions& given, const std::vector<std::string>& scenes) {
    if (!scenes.empty()) refuseUsage("--hard has scenes of its own; leave '" + scenes.front() + "' out");
    for (const char* option : {"--technique", "--light", "--size", "--shard"})
        if (given.has(option)) refuseUsage(std::string(option) + ": the hard cases say that themselves; leave it out");
}

ReportOptions reportOptions(const GivenOptions& given) {
    ReportOptions options;
    options.output = given.required("--output", "shadowlab report -o DIR");
    std::vector<std::string> words = given.texts("SCENE");
    if (!words.empty() && words.front() == "merge") {
        refuseDrawingOptions(given);
        if (words.size() == 1)
            refuseUsage("report merge: no folder is named; write shadowlab report merge part-1 part-2 -o DIR");
        options.merged.assign(words.begin() + 1, words.end());
        return options;
    }
    options.scenes = std::move(words);
    options.isQuick = given.has("--quick");
    options.isHard = given.has("--hard");
    if (options.isHard) refuseSceneOptions(given, options.scenes);
    if (given.has("--technique")) options.techniques = measuredTechniquesFrom(given.texts("--technique"));
    options.light = given.text("--light");
    options.size = sizeFrom("--size", given.text("--size", options.isQuick ? "640x360" : "1280x720"), "measured-side");
    reserveForMeasured(options.size);
    if (given.has("--shard")) options.shard = report::shardFrom(given.text("--shard"));
    options.backend = backendFrom(given);
    options.allowed = given.allowedFolders();
    return options;
}

/// `report merge DIR... -o DIR`.
int mergeReports(const ReportOptions& options) {
    std::vector<report::Store> stores;
    for (const std::filesystem::path& folder : options.merged) {
        std::error_code absent;
        if (std::filesystem::equivalent(folder, options.output, absent))
            throw Error(ExitStatus::usage,
                        "-o: '" + options.output.string() +
                            "' is one of the parts, and would no longer be one; choose another folder");
        stores.emplace_back(folder);
    }
    const report::Plan plan = stores.front().plan();
    for (std::size_t i = 1; i < stores.size(); ++i)
        if (stores[i].plan() != plan)
            throw Error(ExitStatus::badInput, options.merged[i].string() + ": is a part of another report than " +
                                                  options.merged.front().string() + ": it is " +
                                                  report::difference(stores[i].plan(), plan) +
                                                  "; merge parts that one program was asked for with the same words");
    for (const report::Store& part : stores)
        part.readAll(); // before anything of it is taken over
    if (const std::vector<std::string> missing = report::missingPoints(stores, plan); !missing.empty())
        throw Error(ExitStatus::badInput, "points that are in none of the parts: " + std::to_string(missing.size()) +
                                              ", the first is '" + missing.front() +
                                              "'; run the shards that are missing, and merge them, too");
    const report::Store store(options.output);
    store.begin(plan);
    for (const report::Store& part : stores)
        store.takeOver(part);
    writeReport(store);
    return 0;
}

int report(const ReportOptions& options) {
    if (options.isHard) return reportHard(options);
    return options.merged.empty() ? reportScenes(options) : mergeReports(options);
}

Work reportWork(const GivenOptions& given) {
    return [options = reportOptions(given)] { return report(options); };
}

} // namespace

void writeReport(const report::Store& store) {
    report::writeOutputs(store, report::assemble(store));
    print((store.folder() / "index.html").string() + "\n");
}

const Command kReport{"report", "[SCENE...]",
                      "Speed against error: every technique's sweeps on scenes, as a page, charts, CSV and JSON",
                      describeReport, reportWork};

} // namespace shadowlab::cli
