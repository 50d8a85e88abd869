// `shadowlab grade`: a score sheet for a plug-in.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/grade_text.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "app/cli/same_file.h"
#include "app/context/context.h"
#include "app/student/grading/child_program.h"
#include "app/student/grading/grader.h"
#include "app/student/grading/likely_blanks.h"
#include "app/student/grading/sheets/sheets.h"
#include "app/student/search/finding_files.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::cli {

namespace {

/// --sheet FORM:FILE
struct AskedSheet {
    int form = 0;               ///< index into kForms
    std::filesystem::path file; ///< "-": standard output
};

struct Form {
    const char* name;
    std::string (*write)(const student::Sheet&, const std::vector<student::Blank>&, const std::optional<student::SearchReport>&);
};
const std::array<Form, 4> kForms = {{{"html", student::htmlSheet},
                                     {"gradescope", student::gradescopeSheet},
                                     {"coderunner", student::coderunnerSheet},
                                     {"text", [](const auto& sheet, const auto& blanks, const auto& search) {
                                          return sheetText({sheet, blanks, search, ""}, std::nullopt);
                                      }}}};

struct GradeOptions {
    std::filesystem::path plugin;
    std::string technique;        ///< empty: the plug-in's only one
    std::string family;           ///< empty: what the plug-in says
    std::filesystem::path output; ///< a folder; empty: no picture is written
    student::ChildLimits limits;
    student::SandboxWanted sandbox = student::SandboxWanted::automatic;
    std::optional<student::SearchPlan> search;
    std::vector<AskedSheet> sheets;
    std::string backend = "auto";
    bool json = false;
};

void describeGrade(DescribedOptions& add) {
    add.option("-t,--technique", "ID", "which of the plug-in's techniques, where it has several");
    add.option("--family", "FAMILY", student::familyNames() + " (default: what the plug-in's CMakeLists.txt says)");
    add.option("-o,--output", "DIR",
               "a folder for pictures of the failing cases, a page with all of them, and what --search finds; it is made where there is none");
    add.option("--sheet", "FORM:FILE",
               "the score sheet in another form: html, a page with its pictures; gradescope, its results.json; coderunner, for a template "
               "grader of Moodle's CodeRunner; text. FILE - is standard output, in place of the table; may be repeated");
    add.option("--search", "N", "tries N random scenes of the family's hard kinds, and makes the first that fails as small as it can be");
    add.option("--seconds", "S", "for the search (default 60)");
    add.option("--seed", "K", "of the random scenes: same seed, same scenes (default 1)");
    add.option("--sandbox", "auto|on|off",
               "runs the plug-in without network, home folder and other processes, by bwrap: where that can be had (default); on: else it "
               "is not run; off: never");
    add.option("--time-limit", "SECONDS", "for each case (default 30)");
    add.option("--memory-limit", "MIB", "for each case (default 2048)");
    describeBackend(add);
    add.flag("--json", "one JSON object instead of a table");
    add.footer("Ends with status 0 where all cases are right and a search finds nothing, else with 1.\n"
               "Examples:\n"
               "  shadowlab grade --plugin build/anna.so\n"
               "  shadowlab grade --plugin build/anna.so --family shadow-volume -o sheets --json\n"
               "  shadowlab grade --plugin build/anna.so --search 60 -o sheets\n"
               "  shadowlab grade --plugin build/anna.so --sheet gradescope:results.json --sandbox on");
}

constexpr int kMostSeconds = 3600, kMostMiB = 1 << 20, kMostScenes = 100000;

AskedSheet sheetFrom(const std::string& text) {
    const std::size_t colon = text.find(':');
    std::vector<std::string> names;
    for (const Form& form : kForms)
        names.emplace_back(form.name);
    if (colon == std::string::npos || colon + 1 == text.size())
        refuseUsage("--sheet: '" + text + "' has no form, or no file; write html:sheet.html, or gradescope:results.json");
    return {choiceFrom("--sheet", text.substr(0, colon), names), text.substr(colon + 1)};
}

std::vector<AskedSheet> sheetsFrom(const GivenOptions& given) {
    std::vector<AskedSheet> sheets;
    for (const std::string& text : given.texts("--sheet"))
        sheets.push_back(sheetFrom(text));
    for (std::size_t i = 0; i < sheets.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (sheets[i].file != "-" && isSameFile(sheets[i].file, sheets[j].file))
                refuseUsage("--sheet: two sheets are to be written to " + sheets[i].file.string() + "; give each a file of its own");
    const auto shown = std::ranges::count(sheets, std::filesystem::path("-"), &AskedSheet::file) + (given.has("--json") ? 1 : 0);
    if (shown > 1) refuseUsage("--sheet: standard output can take one sheet; write the others, or --json, to a file or leave them out");
    return sheets;
}

std::optional<student::SearchPlan> searchFrom(const GivenOptions& given) {
    if (!given.has("--search")) {
        for (const char* option : {"--seconds", "--seed"})
            if (given.has(option)) refuseUsage(std::string(option) + " is about a search; write --search N, too");
        return std::nullopt;
    }
    student::SearchPlan plan;
    plan.scenes = countFrom("--search", given.text("--search"), kMostScenes);
    plan.time = std::chrono::seconds(countFrom("--seconds", given.text("--seconds", "60"), kMostSeconds));
    plan.seed = static_cast<std::uint64_t>(countFrom("--seed", given.text("--seed", "1"), kMostSeed));
    return plan;
}

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
    options.sandbox = student::sandboxFromName(given.text("--sandbox", "auto"));
    options.search = searchFrom(given);
    options.sheets = sheetsFrom(given);
    options.json = given.has("--json");
    return options;
}

constexpr int kNotAllRight = 1; // exit status: graded, and not all cases are right

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

/// Of a plug-in without a sandbox it is said what that means.
void tellSandbox(const student::Sandbox& sandbox) {
    if (!sandbox.whyNot().empty())
        note("no sandbox: " + sandbox.whyNot() + ". The plug-in runs with your rights, within the limits of time and memory");
}

/// All names are known before anything is drawn.
std::filesystem::path inOutput(const GradeOptions& options, const std::string& name) { return options.output / name; }

/// Pictures of the failing cases, the first of them under a name of its own, and the page. Returns the name of the first.
std::string writePictures(const GradeOptions& options, const student::Sheet& sheet) {
    std::string first;
    for (const student::CaseResult& result : sheet.results) {
        if (result.picture.rgba.empty()) continue;
        const std::vector<std::uint8_t> png = image::encodePng(result.picture);
        if (first.empty()) {
            first = inOutput(options, sheet.candidate.technique + "-first-failing.png").string();
            image::writeWhole(first, png);
        }
        image::writeWhole(inOutput(options, sheet.candidate.technique + "-" + std::string(result.which->id) + ".png"), png);
    }
    return first;
}

/// Searches, writes what is found where there is a folder for it, and says what came of it.
student::SearchReport searchedFor(const GradeOptions& options, const student::Sheet& sheet, const std::vector<student::Blank>& blanks,
                                  const student::Conditions& conditions) {
    student::SceneTrials trials(sheet.candidate, *sheet.family, conditions);
    Progress progress("scene", options.search->scenes);
    const student::SearchResult result = student::search(trials, *options.search, [&](int count) { progress.done(count); });
    student::SearchReport report{options.search->scenes, result.tried, result.unfair, options.search->seed, result.isOutOfTime, std::nullopt};
    if (!result.finding) return report;
    const student::Finding& finding = *result.finding;
    const std::string stem = sheet.candidate.technique + "-search";
    std::map<std::string, std::string> files = student::filesOf(finding, trials, sheet.candidate, stem);
    student::FoundScene found;
    found.idea = finding.kind->idea;
    found.sentence = student::sentenceOf(finding);
    found.counted = student::countedText(*sheet.family, finding.kind->judged);
    found.blanks = student::blanksAbout(finding, *sheet.family, blanks, student::likelyBlanks(sheet));
    found.number = finding.number + 1;
    found.triangles = student::triangleCount(finding.scene);
    found.trianglesBefore = finding.trianglesBefore;
    found.attempts = finding.attempts;
    found.wrong = finding.trial.wrong;
    found.falseLit = finding.trial.falseLit;
    found.falseShadow = finding.trial.falseShadow;
    found.picture = files[stem + ".png"];
    found.figure = files.contains(stem + ".svg") ? files[stem + ".svg"] : "";
    if (!options.output.empty()) {
        for (const auto& [name, bytes] : files)
            image::writeWhole(inOutput(options, name), bytes);
        found.scene = inOutput(options, stem + ".json").string();
        if (files.contains(stem + "-lesson.json")) found.lesson = inOutput(options, stem + "-lesson.json").string();
    }
    report.found = std::move(found);
    return report;
}

void requireWritable(const GradeOptions& options, const std::string& technique) {
    if (!options.output.empty()) {
        image::makeFolders(options.output);
        image::probeWritable(inOutput(options, technique + "-first-failing.png"));
    }
    for (const AskedSheet& sheet : options.sheets)
        if (sheet.file != "-") image::probeWritable(sheet.file);
}

int grade(const GradeOptions& options) {
    student::keepMemoryToItself(); // the truth is in it
    const student::Conditions conditions{options.limits, student::Sandbox(options.sandbox)};
    const student::Declared declared = student::askPlugin(options.plugin, conditions);
    const student::Candidate candidate{options.plugin, chosenTechnique(options, declared), options.backend};
    const student::Family& family = chosenFamily(options, declared);
    const std::vector<student::Blank> blanks = student::blanksOf(family, declared.skeleton);
    requireWritable(options, candidate.technique);
    tellSandbox(conditions.sandbox);
    const std::unique_ptr<context::Context> context = context::createContext(context::backendFromName(options.backend));
    const student::Sheet sheet = [&] {
        Progress progress("case", static_cast<int>(family.cases.size()));
        return student::grade(candidate, family, conditions, [&](int count) { progress.done(count); });
    }();
    const std::string picture = options.output.empty() ? "" : writePictures(options, sheet);
    std::optional<student::SearchReport> search;
    if (options.search) search = searchedFor(options, sheet, blanks, conditions);
    if (!options.output.empty())
        image::writeWhole(inOutput(options, candidate.technique + "-sheet.html"), student::htmlSheet(sheet, blanks, search));
    bool isShown = false;
    for (const AskedSheet& asked : options.sheets) {
        const std::string text = kForms.at(static_cast<std::size_t>(asked.form)).write(sheet, blanks, search);
        if (asked.file == "-") isShown = true, print(text);
        else image::writeWhole(asked.file, text);
    }
    const GradedSheet graded{sheet, blanks, search, picture};
    if (options.json) print(sheetJson(graded));
    else if (!isShown) print(sheetText(graded, terminalColumns()));
    return sheet.points() == sheet.mostPoints() && !(search && search->found) ? 0 : kNotAllRight;
}

Work gradeWork(const GivenOptions& given) {
    return [options = gradeOptions(given)] { return grade(options); };
}

} // namespace

const Command kGrade{"grade", "", "Holds a plug-in against the truth in hard cases, and prints a score sheet",
                     describeGrade, gradeWork};

} // namespace shadowlab::cli
