// SPDX-License-Identifier: MIT
#include "app/commands/command_line.h"

#include <charconv>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "techniques/foundation/error.h"
#include "techniques/foundation/nearest_names.h"

namespace shadowlab::commands {

namespace {

[[noreturn]] void usage(const std::string& message) { throw Error(ExitStatus::usage, message); }

/// "1280x720"
ivec2 parseSize(const std::string& text) {
    ivec2 size{0};
    const char *begin = text.data(), *end = begin + text.size();
    const auto [cross, widthError] = std::from_chars(begin, end, size.x);
    const auto [last, heightError] = cross != end && *cross == 'x' ? std::from_chars(cross + 1, end, size.y) : std::from_chars_result{begin, std::errc::invalid_argument};
    if (widthError != std::errc{} || heightError != std::errc{} || last != end || size.x < 1 || size.y < 1)
        usage("--size: '" + text + "' is not a size; write WIDTHxHEIGHT in pixels, as 1280x720");
    return size;
}

bool parseBoolean(const std::string& option, const std::string& text) {
    if (text != "true" && text != "false") usage(option + ": '" + text + "' is neither true nor false; write one of them");
    return text == "true";
}

double parseNumber(const std::string& option, const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= 1e6))
        usage(option + ": '" + text + "' is not a number within ±1000000; write degrees, as 360");
    return value;
}

int parseCount(const std::string& option, const std::string& text, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 1 || value > most)
        usage(option + ": '" + text + "' is not a whole number from 1 to " + std::to_string(most) + "; write one");
    return value;
}

session::Layout parseLayout(const std::string& text) {
    const std::vector<std::string> names = {"single", "side", "split", "grid"};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return static_cast<session::Layout>(i);
    usage("--layout: '" + text + "' is no layout; " + suggestion(text, names));
}

/// The texts of the capture options, before they are checked.
struct CaptureTexts {
    std::string scene, output, layout, labels = "true", stage, size = "1280x720", supersample = "1", light, backend = "auto", stats, frames = "1", orbitLight, orbitCamera;
    std::vector<std::string> techniques, settings, allowed;
};

void describeCapture(CLI::App& command, CaptureTexts& texts) {
    command.add_option("SCENE", texts.scene, "a built-in name (`list scenes`), a .json scene or an .obj mesh")->required();
    command.add_option("-o,--output", texts.output, "PNG file; of several frames: with #### for the number")->required();
    command.add_option("-t,--technique", texts.techniques, "technique ids, separated by commas (default shadow-volume-zfail)")->delimiter(',')->take_all();
    command.add_option("--layout", texts.layout, "single|side|split|grid (default: single for one technique, else side)");
    command.add_option("--labels", texts.labels, "true|false: titles on pictures of several techniques");
    command.add_option("--stage", texts.stage, "an intermediate picture: STAGE, STAGE@LIGHT or pass:ID (`list stages`)");
    command.add_option("--size", texts.size, "WIDTHxHEIGHT of the whole picture in pixels (default 1280x720)");
    command.add_option("--supersample", texts.supersample, "N: average N x N samples a pixel in linear light");
    command.add_option("--set", texts.settings, "[SLOT:]ID.PARAM=VALUE (`list parameters`); may be repeated")->take_all();
    command.add_option("--light", texts.light, "the light a stage is about (default: the first)");
    command.add_option("--backend", texts.backend, "auto|egl|osmesa|window");
    command.add_option("--stats", texts.stats, "JSON file for times, counters and settings");
    command.add_option("--frames", texts.frames, "number of frames");
    command.add_option("--orbit-light", texts.orbitLight, "degrees the lights turn about the camera's target over all frames");
    command.add_option("--orbit-camera", texts.orbitCamera, "degrees the camera turns about its target over all frames");
    command.add_option("--allow", texts.allowed, "a further folder a scene may take meshes from; may be repeated")->take_all();
}

CaptureOptions checked(const CaptureTexts& texts) {
    CaptureOptions options;
    options.scene = texts.scene;
    options.output = texts.output;
    options.techniques = texts.techniques;
    if (options.techniques.empty()) options.techniques = {"shadow-volume-zfail"};
    options.layout = texts.layout.empty() ? (options.techniques.size() > 1 ? session::Layout::side : session::Layout::single) : parseLayout(texts.layout);
    if (options.layout == session::Layout::single && options.techniques.size() > 1)
        usage("--layout single shows one technique, " + std::to_string(options.techniques.size()) + " are given; use --layout side, split or grid");
    options.labels = parseBoolean("--labels", texts.labels);
    options.stage = texts.stage;
    options.size = parseSize(texts.size);
    options.supersample = parseCount("--supersample", texts.supersample, 16);
    options.settings = texts.settings;
    options.light = texts.light;
    options.backend = context::backendFromName(texts.backend);
    options.stats = texts.stats;
    options.frames = parseCount("--frames", texts.frames, 100000);
    if (!texts.orbitLight.empty()) options.orbitLightDegrees = parseNumber("--orbit-light", texts.orbitLight);
    if (!texts.orbitCamera.empty()) options.orbitCameraDegrees = parseNumber("--orbit-camera", texts.orbitCamera);
    for (const std::string& folder : texts.allowed) options.allowed.emplace_back(folder);
    if (options.frames > 1 && options.output.filename().string().find('#') == std::string::npos)
        usage("--frames " + texts.frames + ": the frames need a place for their number in -o; write for example name_####.png");
    return options;
}

/// CLI11's own words for a fault, as one line with a mend.
[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
    std::string message = error.what();
    for (char& c : message)
        if (c == '\n') c = ' ';
    std::vector<std::string> known;
    const CLI::App* active = &app;
    for (const CLI::App* sub : app.get_subcommands()) active = sub;
    for (const CLI::Option* option : active->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const CLI::App* sub : active->get_subcommands([](const CLI::App*) { return true; })) known.push_back(sub->get_name());
    std::string mend = "see shadowlab --help";
    for (int i = 1; i < argc; ++i) {
        const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
        if (message.find(word) == std::string::npos || std::ranges::find(known, word) != known.end()) continue;
        if (const auto near = nearestNames(word, known); !near.empty()) mend = suggestion(word, known);
    }
    usage(message + "; " + mend);
}

} // namespace

int run(int argc, char** argv) {
    CLI::App app("One scene, many ways to draw its shadows, each measured against the exact answer.", "shadowlab");
    app.set_version_flag("--version", "shadowlab " SHADOWLAB_VERSION);
    app.require_subcommand(0, 1);

    CaptureTexts texts;
    CLI::App* captureCommand = app.add_subcommand("capture", "Render a scene to a PNG without a window");
    describeCapture(*captureCommand, texts);

    std::string demoScene = "still-life";
    CLI::App* demoCommand = app.add_subcommand("demo", "Shadow map and shadow volume side by side, as a picture in the current folder");
    demoCommand->add_option("SCENE", demoScene, "a built-in name (`list scenes`), a .json scene or an .obj mesh");

    ListOptions listOptions;
    CLI::App* listCommand = app.add_subcommand("list", "What there is: techniques, parameters, stages, scenes, backends, limits");
    listCommand->add_option("WHAT", listOptions.what, "techniques|parameters|stages|scenes|decks|lessons|backends|limits")->required();
    listCommand->add_flag("--json", listOptions.json, "one JSON object on standard output");

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        const auto used = app.get_subcommands();
        std::fputs((used.empty() ? app.help() : used.front()->help()).c_str(), stdout);
        return 0;
    } catch (const CLI::CallForVersion& version) {
        std::printf("%s\n", version.what());
        return 0;
    } catch (const CLI::ParseError& error) {
        refuse(app, error, argc, argv);
    }
    if (captureCommand->parsed()) return capture(checked(texts));
    if (listCommand->parsed()) return list(listOptions);
    if (demoCommand->parsed()) return demo(demoScene);
    std::fputs(app.help().c_str(), stdout);
    return 0;
}

} // namespace shadowlab::commands
