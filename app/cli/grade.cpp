// `shadowlab grade`: a score sheet for a plug-in.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "app/cli/text_table.h"
#include "app/context/context.h"
#include "app/student/grading/child_program.h"
#include "app/student/grading/grader.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::cli {

namespace {

struct GradeOptions {
    std::filesystem::path plugin;
    std::string technique;        ///< empty: the plug-in's only one
    std::string family;           ///< empty: what the plug-in says
    std::filesystem::path output; ///< a folder; empty: no picture is written
    student::ChildLimits limits;
    std::string backend = "auto";
    bool json = false;
};

void describeGrade(DescribedOptions& add) {
    add.option("-t,--technique", "ID", "which of the plug-in's techniques, where it has several");
    add.option("--family", "FAMILY", student::familyNames() + " (default: what the plug-in's CMakeLists.txt says)");
    add.option("-o,--output", "DIR",
               "a folder for the picture of the first failing case; it is made where there is none");
    add.option("--time-limit", "SECONDS", "for each case (default 30)");
    add.option("--memory-limit", "MIB", "for each case (default 2048)");
    describeBackend(add);
    add.flag("--json", "one JSON object instead of a table");
    add.footer("Ends with status 0 where all cases are right, and with 1 where some are not.\n"
               "Examples:\n"
               "  shadowlab grade --plugin build/anna.so\n"
               "  shadowlab grade --plugin build/anna.so --family shadow-volume -o sheets --json");
}

constexpr int kMostSeconds = 3600, kMostMiB = 1 << 20;

GradeOptions gradeOptions(const GivenOptions& given) {
    const std::vector<std::string>& plugins = given.plugins();
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
    options.json = given.has("--json");
    return options;
}

constexpr int kNotAllRight = 1; // exit status: graded, and not all cases are right

using student::CaseResult;
using student::Sheet;

std::string chosenTechnique(const GradeOptions& options, const student::Declared& declared) {
    if (options.technique.empty()) {
        if (declared.techniques.size() == 1) return declared.techniques.front();
        std::string all;
        for (const std::string& technique : declared.techniques)
            all += (all.empty() ? "" : ", ") + technique;
        throw Error(ExitStatus::usage, "grade: " + options.plugin.string() + " has " +
                                           std::to_string(declared.techniques.size()) +
                                           " techniques; choose one of them with -t: " + all);
    }
    if (std::ranges::find(declared.techniques, options.technique) == declared.techniques.end())
        throw Error(ExitStatus::usage, "grade: " + options.plugin.string() + " has no technique '" + options.technique +
                                           "'; " + suggestion(options.technique, declared.techniques));
    return options.technique;
}

const student::Family& chosenFamily(const GradeOptions& options, const student::Declared& declared) {
    const std::string& id = options.family.empty() ? declared.family : options.family;
    if (id.empty())
        throw Error(ExitStatus::usage, "grade: " + options.plugin.string() +
                                           " does not say what family it is of; add --family with one of " +
                                           student::familyNames());
    return student::findFamily(id);
}

std::string wrongText(const CaseResult& result) { return result.wrong ? std::to_string(*result.wrong) : "-"; }

/// `columns`: of the terminal that it has to fit; none: of a pipe.
std::string sheetText(const Sheet& sheet, const std::string& picture, std::optional<std::size_t> columns) {
    std::string text = std::string(sheet.family->title) + ": " + sheet.candidate.technique + " (" +
                       sheet.candidate.plugin.filename().string() + ")\n\n";
    Rows rows{{"case", "wrong px", "limit", "points", "  idea"}};
    for (const CaseResult& result : sheet.results)
        rows.push_back({std::string(result.which->id), wrongText(result), std::to_string(result.which->limit),
                        std::to_string(result.points()) + "/" + std::to_string(result.which->points),
                        "  " + std::string(result.which->idea)});
    rows.push_back({"sum", "", "", std::to_string(sheet.points()) + "/" + std::to_string(sheet.mostPoints()), ""});
    text += aligned(rows, columns);
    for (const CaseResult& result : sheet.results) {
        if (result.isRight()) continue;
        text += "\n" + std::string(result.which->id) + ": ";
        if (result.wrong && result.which->judged != student::Judged::visibility)
            text += std::to_string(*result.wrong) + " pixels are more than " + std::to_string(sheet.family->levels) +
                    " of 255 levels off. ";
        else if (result.wrong)
            text += std::to_string(result.counts.falseLit) + " pixels lit that should be dark, " +
                    std::to_string(result.counts.falseShadow) + " dark that should be lit. ";
        else
            text += "no picture: " + result.failure + ". ";
        text += std::string(result.which->hint) + "\n";
    }
    if (!picture.empty()) text += "\nThe first failing case: " + picture + "\n";
    return fitting(text, columns);
}

std::string sheetJson(const Sheet& sheet, const std::string& picture) {
    Json cases = Json::array();
    for (const CaseResult& result : sheet.results)
        cases.push_back({{"case", result.which->id},
                         {"idea", result.which->idea},
                         {"judged", student::toText(result.which->judged)},
                         {"wrong", result.wrong ? Json(*result.wrong) : Json(nullptr)},
                         {"falseLit", result.wrong ? Json(result.counts.falseLit) : Json(nullptr)},
                         {"falseShadow", result.wrong ? Json(result.counts.falseShadow) : Json(nullptr)},
                         {"lit", result.counts.lit},
                         {"shadowed", result.counts.shadowed},
                         {"limit", result.which->limit},
                         {"reason", result.which->reason},
                         {"points", result.points()},
                         {"of", result.which->points},
                         {"failure", result.failure},
                         {"hint", result.isRight() ? "" : std::string(result.which->hint)}});
    const Json json{{"plugin", sheet.candidate.plugin.string()},
                    {"technique", sheet.candidate.technique},
                    {"family", sheet.family->id},
                    {"points", sheet.points()},
                    {"of", sheet.mostPoints()},
                    {"cases", cases},
                    {"picture", picture.empty() ? Json(nullptr) : Json(picture)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int grade(const GradeOptions& options) {
    const student::Declared declared = student::askPlugin(options.plugin, options.limits);
    const student::Candidate candidate{options.plugin, chosenTechnique(options, declared), options.backend};
    const student::Family& family = chosenFamily(options, declared);
    std::filesystem::path picture;
    if (!options.output.empty()) {
        picture = options.output / (candidate.technique + "-first-failing.png");
        image::makeFolders(options.output);
        image::probeWritable(picture);
    }
    const std::unique_ptr<context::Context> context = context::createContext(context::backendFromName(options.backend));
    Progress progress("case", static_cast<int>(family.cases.size()));
    const Sheet sheet = student::grade(candidate, family, options.limits, [&](int count) { progress.done(count); });
    if (sheet.firstFailing.rgba.empty()) picture.clear();
    if (!picture.empty()) image::writeWhole(picture, image::encodePng(sheet.firstFailing));
    print(options.json ? sheetJson(sheet, picture.string()) : sheetText(sheet, picture.string(), terminalColumns()));
    return sheet.points() == sheet.mostPoints() ? 0 : kNotAllRight;
}

Work gradeWork(const GivenOptions& given) {
    return [options = gradeOptions(given)] { return grade(options); };
}

} // namespace

const Command kGrade{"grade", "", "Holds a plug-in against the truth in hard cases, and prints a score sheet",
                     describeGrade, gradeWork};

} // namespace shadowlab::cli
