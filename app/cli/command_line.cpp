// CLI11 splits the words into options and arguments and writes the help. The messages for wrong words are written here,
// because each is one line that says how to put it right.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>

#include "app/cli/demo.h"
#include "app/cli/global_options.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
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
std::string remedyFor(const std::string& word, const std::vector<std::string>& known, const CLI::App& command) {
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
    refuseUsage(prefix + "there is no option '" + option + "'; " + remedyFor(option, known, command));
}

bool isScene(const std::string& word) {
    const std::string ending = std::filesystem::path(word).extension().string();
    const std::vector<std::string> builtIn = scene::builtInScenes(context::assetsRoot());
    return ending == ".json" || ending == ".obj" || std::ranges::find(builtIn, word) != builtIn.end();
}

/// Without a command: `shadowlab SCENE` is the demo of that scene, and `shadowlab` alone that of the first one.
Work workWithoutCommand(const CLI::App& app) {
    const std::vector<std::string> words = leftOver(app);
    if (words.empty()) return demoOf({});
    if (words.size() == 1 && isScene(words.front())) return demoOf(words.front());
    if (words.front().starts_with('-')) refuseLeftOver(app);
    if (isScene(words.front()))
        refuseUsage("'" + words[1] + "' wants a command before the scene, as in shadowlab demo " + words.front() +
                    "; shadowlab --help lists them");
    std::vector<std::string> known = scene::builtInScenes(context::assetsRoot());
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(command->get_name());
    refuseUsage("'" + words.front() + "' is neither a command nor a scene; " + remedyFor(words.front(), known, app));
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

/// In the order of the help text.
constexpr std::array kCommands{&kCapture, &kMeasure, &kReport,       &kProbe, &kDemo,   &kLesson,
                               &kSlides,  &kList,    &kNewTechnique, &kGrade, &kInspect};

void addCommand(CLI::App& app, const Command& command) {
    CLI::App* added = app.add_subcommand(command.name, command.help);
    added->allow_extras(); // refused by refuseLeftOver, so that the message is ours
    DescribedOptions options(*added);
    // Taken out of the words before they are parsed (global_options.h); described here for the help text.
    options.option("--plugin", "FILE", "a plug-in with further techniques; may be repeated");
    options.option("--limit", "NAME=VALUE", "another value for a limit of `list limits`; may be repeated");
    options.flag("--software", "draws on the processor, also beside a graphics card");
    command.describe(options);
}

/// Describes the program and its commands.
void describeProgram(CLI::App& app) {
    app.set_help_flag("-h,--help", "what there is to write, and ends");
    app.set_version_flag("--version", "shadowlab " SHADOWLAB_VERSION, "the program's version, and ends");
    app.formatter(std::make_shared<HelpFormatter>()); // commands inherit it
    app.get_formatter()->column_width(36);
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (const Command* command : kCommands)
        addCommand(app, *command);
    // After the commands, which would inherit it.
    app.footer(
        "shadowlab COMMAND --help tells more about each. `shadowlab SCENE` is short for `shadowlab demo SCENE`.\n"
        "--plugin FILE, anywhere, adds the techniques of a plug-in to those of all commands; --limit NAME=VALUE\n"
        "sets a limit of `list limits`; --software draws on the processor, also beside a graphics card: the same\n"
        "bytes on every machine with the same Mesa and a processor with AVX.\n"
        "Exit status: 0 done, 1 judged and found wanting (grade, report --hard), 2 command line, 3 input, 4 output,\n"
        "5 no OpenGL 3.3, 6 over a limit, 70 a fault of the program; docs/errors.md tells more.");
}

/// What is left to CLI11 to refuse: an option without its value ("--size: 1 required ..."), or a value for a flag.
[[noreturn]] void refuseParsed(const CLI::ParseError& error, const CLI::App& app) {
    const std::string what = error.what();
    const auto commands = app.get_subcommands();
    const CLI::App& command = commands.empty() ? app : *commands.front();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        refuseUsage(what.substr(0, what.find(':')) + ": its value is missing; " + helpHint(command));
    refuseUsage(what + "; " + helpHint(command));
}

/// Prints a text, for --help and --version.
Work printing(std::string text) {
    return [text = std::move(text)] {
        print(text);
        return 0;
    };
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
    describeProgram(app);
    try {
        std::vector<std::string> words(given.rbegin(), given.rend()); // CLI11 takes them from the end
        if (!words.empty()) words.pop_back();                         // the program's own name
        app.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        return printing(app.help());
    } catch (const CLI::CallForVersion& version) {
        return printing(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& error) {
        refuseParsed(error, app);
    }
    const std::vector<CLI::App*> parsed = app.get_subcommands(); // at most one
    if (parsed.empty()) return workWithoutCommand(app);
    refuseLeftOver(*parsed.front());
    refuseLeftOver(app); // words before the command
    const Command& command = **std::ranges::find(kCommands, parsed.front()->get_name(),
                                                 [](const Command* one) { return std::string(one->name); });
    return command.work(GivenOptions(*parsed.front(), plugins));
}

} // namespace shadowlab::cli
