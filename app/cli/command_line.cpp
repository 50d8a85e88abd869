// CLI11 splits the words into options and arguments and writes the help; what is wrong is said in our own words,
// because every refusal is one line with a mend.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/words_anywhere.h"
#include "app/context/assets.h"
#include "app/context/software.h"
#include "app/lab/old_spelling.h"
#include "app/picture/limits.h"
#include "app/student/plugins.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::cli {

namespace {

std::string helpHint(const CLI::App& command) {
    const bool top = command.get_parent() == nullptr;
    return "see shadowlab " + (top ? "" : command.get_name() + " ") + "--help";
}

/// `did you mean ...?` when a name is near, else where to look them up.
std::string mendFor(const std::string& word, const std::vector<std::string>& known, const CLI::App& command) {
    return nearestNames(word, known).empty() ? helpHint(command) : suggestion(word, known);
}

/// Words that no option and no argument of the command has taken. CLI11 keeps the mark `--` among them.
std::vector<std::string> leftOver(const CLI::App& command) {
    std::vector<std::string> words = command.remaining();
    if (const auto mark = std::ranges::find(words, "--"); mark != words.end()) words.erase(mark);
    return words;
}

void refuseLeftOver(const CLI::App& command) {
    const std::vector<std::string> words = leftOver(command);
    if (words.empty()) return;
    const std::string prefix = command.get_parent() ? command.get_name() + ": " : "";
    const std::string& word = words.front();
    if (!word.starts_with('-')) refuseUsage(prefix + "'" + word + "' is one argument too many; " + helpHint(command));
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back("--" + name);
    const std::string option = word.substr(0, word.find('='));
    refuseUsage(prefix + "there is no option '" + option + "'; " + mendFor(option, known, command));
}

bool isScene(const std::string& word) {
    const std::string ending = std::filesystem::path(word).extension().string();
    const std::vector<std::string> builtIn = scene::builtInScenes(context::assetsRoot());
    return ending == ".json" || ending == ".obj" || std::ranges::find(builtIn, word) != builtIn.end();
}

/// A function with what it is called with.
template <typename Options>
Work with(Options options, int (*command)(const Options&)) {
    return [options = std::move(options), command] { return command(options); };
}

/// Without a command: `shadowlab SCENE` is the demo of that scene, and `shadowlab` alone that of the first one.
Work workWithoutCommand(const CLI::App& app) {
    const std::vector<std::string> words = leftOver(app);
    if (words.empty()) return with(DemoOptions{}, demo);
    if (words.size() == 1 && isScene(words.front())) {
        DemoOptions options;
        options.scene = words.front();
        return with(options, demo);
    }
    if (words.front().starts_with('-')) refuseLeftOver(app);
    if (isScene(words.front()))
        refuseUsage("'" + words[1] + "' wants a command before the scene, as in shadowlab demo " + words.front() +
                    "; shadowlab --help lists them");
    std::vector<std::string> known = scene::builtInScenes(context::assetsRoot());
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(command->get_name());
    refuseUsage("'" + words.front() + "' is neither a command nor a scene; " + mendFor(words.front(), known, app));
}

/// CLI11 2.6 leaves out the word before the usage.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* app, std::string name) const override {
        std::string usage = CLI::Formatter::make_usage(app, std::move(name));
        if (usage.find("Usage:") == std::string::npos)
            usage.insert(std::min(usage.find_first_not_of('\n'), usage.size()), "Usage: ");
        return usage;
    }
};

CLI::App* addCommand(CLI::App& app, const char* name, const char* what) {
    CLI::App* command = app.add_subcommand(name, what);
    command->allow_extras(); // refused by refuseLeftOver, after which nothing else can hide them
    // Taken out of the words before (words_anywhere.h); here for the help alone.
    addOption(*command, "--plugin", "FILE", "a plug-in with further techniques; may be repeated");
    addOption(*command, "--limit", "NAME=VALUE", "another value for a limit of `list limits`; may be repeated");
    command->add_flag("--software")->description("draws on the processor, also beside a graphics card");
    return command;
}

DemoOptions demoOptions(const CLI::App& command) {
    const GivenOptions given(command);
    DemoOptions options;
    options.scene = given.text("SCENE", options.scene);
    options.lesson = given.text("--lesson");
    options.deck = given.text("--deck");
    options.slide = given.text("--slide");
    if (given.has("--slide") && !given.has("--deck")) refuseUsage("--slide is one of a deck; write --deck NAME, too");
    if (given.has("--lesson") && given.has("--deck")) refuseUsage("--lesson, --deck: one of them; leave the other out");
    if (given.has("--size")) options.size = sizeFrom("--size", given.text("--size"), "picture-side");
    options.presenter = command.count("--presenter") > 0;
    options.keepSettings = booleanFrom("--keep-settings", given.text("--keep-settings", "true"));
    options.report = command.count("--report") > 0;
    options.allowed = given.allowedFolders();
    return options;
}

InspectOptions inspectOptions(const CLI::App& command) {
    const GivenOptions given(command);
    InspectOptions options{
        given.required("FILE", "for example shadowlab inspect bunny.obj"), command.count("--json") > 0, {}};
    options.allowed = given.allowedFolders();
    return options;
}

} // namespace

int run(int argc, char** argv) {
    std::vector<std::string> given(argv, argv + argc);
    lab::tellOldSpelling(&note);
    if (takeFlag("--software", given)) context::demandSoftware(); // before the first context
    const TakenWords limits = takeWordsOf("--limit", "triangles=50000000", given);
    for (const std::string& limit : limits.values)
        picture::setLimit(limit);
    const TakenWords plugins = takeWordsOf("--plugin", "FILE.so", limits.words);
    // Nothing of a plug-in that is graded runs in this process.
    if (plugins.words.size() < 2 || plugins.words[1] != "grade")
        for (const std::string& file : plugins.values)
            student::loadPlugin(file);
    return workFor(plugins.words, plugins.values)();
}

Work workFor(const std::vector<std::string>& given, const std::vector<std::string>& plugins) {
    CLI::App app("One scene, many ways to draw its shadows, each measured against the exact answer.", "shadowlab");
    app.set_help_flag("-h,--help", "what there is to write, and ends");
    app.set_version_flag("--version", "shadowlab " SHADOWLAB_VERSION, "the program's version, and ends");
    app.formatter(std::make_shared<HelpFormatter>()); // commands inherit it
    app.get_formatter()->column_width(36);
    app.require_subcommand(0, 1);
    app.allow_extras();

    CLI::App* captureCommand = addCommand(app, "capture", "Renders a scene to a PNG without a window");
    describeCapture(*captureCommand);

    CLI::App* measureCommand = addCommand(
        app, "measure", "What techniques get wrong, pixel by pixel against the exact answer, and what they cost");
    describeMeasure(*measureCommand);

    CLI::App* reportCommand = addCommand(
        app, "report", "Speed against error: every technique's sweeps on scenes, as a page, charts, CSV and JSON");
    describeReport(*reportCommand);

    CLI::App* probeCommand =
        addCommand(app, "probe", "What a technique knows about one pixel: facts, vectors, and the tree of its rays");
    describeProbe(*probeCommand);

    CLI::App* demoCommand =
        addCommand(app, "demo", "Opens the window: shadow map and shadow volume on one scene (H there lists all keys)");
    addOption(*demoCommand, "SCENE", "",
              "a built-in name (`list scenes`), a .json scene or an .obj mesh (default still-life)");
    addOption(*demoCommand, "--lesson", "LESSON", "begins with a lesson (`list lessons`, or a .json file); J goes on");
    addOption(*demoCommand, "--deck", "DECK", "begins with slides (`list decks`, or a .json file); S goes on");
    addOption(*demoCommand, "--slide", "NAME", "which of the deck's slides (default the first)");
    addOption(*demoCommand, "--size", "WxH", "of the window (default: as it was the last time, at first 1280x720)");
    demoCommand->add_flag("--presenter")->description("large type and high contrast from the start (D in the window)");
    addOption(*demoCommand, "--keep-settings", "true|false",
              "remember size and panels of the window from run to run (default true)");
    demoCommand->add_flag("--report")
        ->description("a line of JSON on standard output for every state that is on screen");
    addOption(*demoCommand, "--allow", "DIR", "a further folder that scenes may take meshes from; may be repeated");

    CLI::App* lessonCommand =
        addCommand(app, "lesson", "An artefact and what mends it: draws a lesson, or measures whether it holds");
    describeLesson(*lessonCommand);

    CLI::App* slidesCommand =
        addCommand(app, "slides", "A deck as pictures, as a page for a browser, and as a text for pandoc");
    describeSlides(*slidesCommand);

    CLI::App* listCommand = addCommand(
        app, "list", "What there is: techniques, parameters, stages, scenes, keys of the window, backends, limits");
    addOption(
        *listCommand, "WHAT", "",
        "techniques, plugins, parameters, stages, source, scenes, figures, decks, lessons, quantities (of lessons), "
        "backends, keys "
        "or limits");
    listCommand->add_flag("--json")->description("one JSON object instead of lines with tabs");

    CLI::App* newTechniqueCommand =
        addCommand(app, "new-technique", "Writes a folder in which a technique of your own is built as a plug-in");
    describeNewTechnique(*newTechniqueCommand);

    CLI::App* gradeCommand =
        addCommand(app, "grade", "Holds a plug-in against the truth in hard cases, and prints a score sheet");
    describeGrade(*gradeCommand);

    CLI::App* inspectCommand =
        addCommand(app, "inspect", "What a mesh or a scene is made of, and what that means for each technique");
    addOption(*inspectCommand, "FILE", "", "an .obj mesh, a .json scene or a built-in name (`list scenes`)");
    inspectCommand->add_flag("--json")->description("one JSON object instead of a table");
    addOption(*inspectCommand, "--allow", "DIR",
              "a further folder that the scene may take meshes from; may be repeated");

    // After the commands, which would inherit it.
    app.footer(
        "shadowlab COMMAND --help tells more about each. `shadowlab SCENE` is short for `shadowlab demo SCENE`.\n"
        "--plugin FILE, anywhere, adds the techniques of a plug-in to those of all commands; --limit NAME=VALUE\n"
        "sets a limit of `list limits`; --software draws on the processor, also beside a graphics card: the same\n"
        "bytes on every machine with the same Mesa and a processor with AVX.\n"
        "Exit status: 0 done, 1 judged and found wanting (grade, report --hard), 2 command line, 3 input, 4 output,\n"
        "5 no OpenGL 3.3, 6 over a limit, 70 a fault of the program; docs/errors.md tells more.");

    try {
        std::vector<std::string> words(given.rbegin(), given.rend()); // CLI11 takes them from the end
        if (!words.empty()) words.pop_back();                         // the program's own name
        app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        return [help = app.help()] {
            print(help);
            return 0;
        };
    } catch (const CLI::CallForVersion& version) {
        return [line = std::string(version.what()) + "\n"] {
            print(line);
            return 0;
        };
    } catch (const CLI::ParseError& error) {
        // All that is left to CLI11: an option without its value ("--size: 1 required ..."), or a value for a flag.
        const std::string what = error.what();
        const auto commands = app.get_subcommands();
        const CLI::App& command = commands.empty() ? app : *commands.front();
        const std::string option = what.substr(0, what.find(':'));
        if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
            refuseUsage(option + ": its value is missing; " + helpHint(command));
        refuseUsage(what + "; " + helpHint(command));
    }
    for (const CLI::App* command : app.get_subcommands()) {
        refuseLeftOver(*command);
        refuseLeftOver(app); // words before the command
    }
    if (captureCommand->parsed()) return with(captureOptions(*captureCommand), capture);
    if (measureCommand->parsed()) return with(measureOptions(*measureCommand), measure);
    if (reportCommand->parsed()) {
        const ReportOptions options = reportOptions(*reportCommand);
        return with(options, options.isHard ? reportHard : report);
    }
    if (probeCommand->parsed()) return with(probeOptions(*probeCommand), probe);
    if (lessonCommand->parsed()) return with(lessonOptions(*lessonCommand), lesson);
    if (slidesCommand->parsed()) return with(slidesOptions(*slidesCommand), slides);
    if (listCommand->parsed())
        return with(ListOptions{GivenOptions(*listCommand).required("WHAT", "for example shadowlab list techniques"),
                                listCommand->count("--json") > 0},
                    list);
    if (newTechniqueCommand->parsed()) return with(newTechniqueOptions(*newTechniqueCommand), newTechnique);
    if (gradeCommand->parsed()) return with(gradeOptions(*gradeCommand, plugins), grade);
    if (inspectCommand->parsed()) return with(inspectOptions(*inspectCommand), inspect);
    if (demoCommand->parsed()) return with(demoOptions(*demoCommand), demo);
    return workWithoutCommand(app);
}

} // namespace shadowlab::cli
