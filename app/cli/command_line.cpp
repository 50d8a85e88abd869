// CLI11 splits the words into options and arguments and writes the help. The messages for wrong words are written here,
// because each is one line that says how to put it right.
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>

#include "app/cli/demo.h"
#include "app/cli/exit_statuses.h"
#include "app/cli/global_options.h"
#include "app/cli/help_text.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/context/assets.h"
#include "app/context/software.h"
#include "app/lab/old_spelling.h"
#include "app/picture/limits.h"
#include "app/student/plugins.h"
#include "app/student/search/drawing_service.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/scene_file.h"

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
    const std::vector<std::string> builtIn = scene::builtInScenes(context::assetsRoot());
    return scene::fileKind(word) != scene::FileKind::none || std::ranges::find(builtIn, word) != builtIn.end();
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

/// In the order of the help text.
constexpr std::array kCommands{&kCapture, &kMeasure,  &kReport,  &kProbe, &kDemo,   &kLesson, &kSlides, &kExercise,
                               &kList,    &kNewTechnique, &kGrade,  &kInspect, &kPack, &kExport, &kJudge};

const Command* findCommand(const std::string& name) {
    const auto found = std::ranges::find(kCommands, name, [](const Command* one) { return std::string(one->name); });
    return found == kCommands.end() ? nullptr : *found;
}

/// The options that may stand anywhere.
const std::array kAnywhere{
    HelpEntry{"--plugin FILE", "adds the techniques of a plug-in; may be repeated"},
    HelpEntry{"--limit NAME=VALUE", "another value for a limit of `list limits`; may be repeated"},
    HelpEntry{"--software",
              "draws on the processor, also beside a graphics card: the same bytes on every machine with the "
              "same Mesa and a processor with AVX"},
};

constexpr const char* kEveryCommand = "With every command"; ///< heading of the options that all have

void addCommand(CLI::App& app, const Command& command) {
    CLI::App* added = app.add_subcommand(command.name, command.help);
    added->allow_extras(); // refused by refuseLeftOver, so that the message is ours
    DescribedOptions options(*added);
    command.describe(options);
    // Taken out of the words before they are parsed (global_options.h); described here for the help text.
    for (const HelpEntry& entry : kAnywhere) {
        const std::size_t blank = std::min(entry.name.find(' '), entry.name.size());
        if (blank < entry.name.size())
            options.option(entry.name.substr(0, blank), entry.name.substr(blank + 1), entry.help);
        else
            options.flag(entry.name, entry.help);
    }
    for (const char* name : {"--plugin", "--limit", "--software", "--help"})
        added->get_option(name)->group(kEveryCommand);
}

std::vector<HelpEntry> exitStatuses() {
    std::vector<HelpEntry> entries;
    for (const auto& [status, meaning] : kExitMeanings)
        entries.push_back({status, meaning});
    return entries;
}

std::string helpOf(const CLI::App& app) {
    HelpPage page{app.get_description(), "shadowlab", {}, app.get_footer()};
    std::vector<HelpEntry> arguments, options, everywhere, commands;
    const Command* const command = findCommand(app.get_name());
    const std::string behind = command ? command->arguments : "[COMMAND]";
    if (app.get_parent())
        page.usage += " " + app.get_name() + (command ? " [OPTIONS]" : "") + (behind.empty() ? "" : " ") + behind;
    else
        page.usage += " COMMAND [OPTIONS] ...\n       shadowlab [SCENE]";
    for (const CLI::Option* option : app.get_options()) {
        const std::string value = option->get_type_name();
        if (option->get_positional()) {
            arguments.push_back({option->get_name(true), option->get_description()});
            continue;
        }
        std::string name;
        for (const std::string& letter : option->get_snames())
            name += "-" + letter + ", ";
        for (const std::string& word : option->get_lnames())
            name += "--" + word;
        const bool isFlag = option->get_items_expected_max() == 0;
        (option->get_group() == kEveryCommand ? everywhere : options)
            .push_back({name + (isFlag || value.empty() ? "" : " " + value), option->get_description()});
    }
    for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
        commands.push_back({one->get_name(), one->get_description()});
    if (!app.get_parent()) everywhere.assign(kAnywhere.begin(), kAnywhere.end());
    page.sections = {
        {"Commands", commands}, {"Arguments", arguments}, {"Options", options}, {kEveryCommand, everywhere}};
    if (!app.get_parent()) page.sections.emplace_back("Exit status", exitStatuses());
    return helpText(page);
}

/// CLI11 asks it for the text of --help.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override { return helpOf(*app); }
};

constexpr const char* kProgramFooter =
    "`shadowlab help COMMAND` tells more about each. `shadowlab SCENE` is short for `shadowlab demo SCENE`, and "
    "`shadowlab` alone opens the window on the first scene. What to do about an exit status stands in docs/errors.md.\n"
    "Examples:\n"
    "  shadowlab\n"
    "  shadowlab capture still-life -o still-life.png\n"
    "  shadowlab measure still-life -t all\n"
    "  shadowlab probe still-life --pixel 640,360 -t shadow-map\n"
    "  shadowlab list";

/// Describes the program and its commands.
void describeProgram(CLI::App& app) {
    app.set_help_flag("-h,--help", "prints this text, and ends");
    app.set_version_flag("--version", "shadowlab " SHADOWLAB_VERSION, "prints the program's version, and ends");
    app.formatter(std::make_shared<HelpFormatter>()); // commands inherit it
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (const Command* command : kCommands)
        addCommand(app, *command);
    CLI::App* const help = app.add_subcommand("help", "This text, or that of a command: shadowlab help capture");
    help->allow_extras();
    DescribedOptions(*help).option("COMMAND", "", "the command whose help is wanted (default: this program's)");
    help->get_option("--help")->group(kEveryCommand);
    DescribedOptions(*help).footer("Examples:\n  shadowlab help\n  shadowlab help capture");
    // After the commands, which would inherit it.
    app.footer(kProgramFooter);
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

/// The text of `shadowlab help` and of `shadowlab help COMMAND`.
std::string helpOn(const std::string& name, const CLI::App& app) {
    if (name.empty()) return helpOf(app);
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == name) return helpOf(*command);
        known.push_back(command->get_name());
    }
    refuseUsage("help: there is no command '" + name + "'; " + remedyFor(name, known, app));
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
    if (plugins.words.size() > 1 && plugins.words[1] == student::kServeDrawings)
        return student::serveDrawings({plugins.words.begin() + 2, plugins.words.end()});
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
    const GivenOptions options(*parsed.front(), plugins);
    const Command* const command = findCommand(parsed.front()->get_name());
    return command ? command->work(options) : printing(helpOn(options.text("COMMAND"), app));
}

} // namespace shadowlab::cli
