// `shadowlab lesson`: a lesson as a picture, and whether its artefact is really there and really gone.
// SPDX-License-Identifier: MIT
#include "app/cli/lesson.h"

#include <array>
#include <charconv>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/text_table.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/lessons/lesson_figure.h"
#include "app/course/lessons/lesson_film.h"
#include "app/course/lessons/lesson_quantities.h"
#include "app/film/film.h"
#include "app/report/lesson_measure.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

void describeLesson(DescribedOptions& add) {
    add.option("LESSON", "", "a built-in name (`list lessons`) or a .json lesson");
    add.option("-o,--output", "OUT.png", "draws it: pictures, title, sentences, and what to look at");
    add.option("--state", "STATE", "what to draw: before, after or both, side by side (default both)");
    add.option("--size", "WxH",
               "width and height of the picture in pixels (default 1600x900, with --animate 1280x720)");
    add.flag("--animate",
             "question, answer, artefact and remedy one after the other in one file, an animated PNG or, if -o "
             "ends in .mp4, a film; each with its words below");
    add.option("--hold", "SECONDS",
               "with --animate: how long each picture stays (default: as long as its words take to read)");
    add.flag("--measure", "prints what is measured before and after beside what it has to be (without -o the default)");
    add.flag("--json", "the numbers as one JSON object instead of a table");
    describeBackend(add);
    add.option("--allow", "DIR", "a further folder that the lesson's scene may take meshes from; may be repeated");
    add.footer("--measure ends with status 3 where a number is not as the lesson says.\n"
               "Examples:\n"
               "  shadowlab lesson acne -o acne.png\n"
               "  shadowlab lesson acne --measure\n"
               "  shadowlab lesson acne --animate -o acne.mp4\n"
               "  shadowlab demo --lesson acne");
}

LessonOptions lessonOptions(const GivenOptions& given) {
    LessonOptions options;
    options.lesson = given.required("LESSON", "shadowlab lesson NAME -o OUT.png");
    options.json = given.has("--json");
    options.animate = given.has("--animate");
    if (given.has("--output")) {
        options.output = given.text("--output");
        if (film::isMp4(options.output) && !options.animate)
            refuseUsage("-o: '" + options.output.string() +
                        "' is a film, and this is one picture; add --animate, or write a .png");
        if (!film::isMp4(options.output)) requireEnding("-o", options.output, ".png");
    }
    for (const char* option : {"--state", "--size", "--animate"})
        if (given.has(option) && options.output.empty())
            refuseUsage(std::string(option) + ": only a picture has it; add -o OUT.png");
    if (given.has("--state") && options.animate)
        refuseUsage("--state: an animation shows both states one after the other; leave --state or --animate out");
    if (given.has("--hold") && !options.animate)
        refuseUsage("--hold: only the pictures of an animation are held; add --animate");
    if (given.has("--hold")) options.holdSeconds = secondsFrom("--hold", given.text("--hold", ""));
    options.measure = given.has("--measure") || options.output.empty();
    if (options.json && !options.measure) refuseUsage("--json: nothing is printed; add --measure");
    const std::vector<std::vector<std::size_t>> states = {{0}, {1}, {0, 1}};
    options.states = states[static_cast<std::size_t>(
        choiceFrom("--state", given.text("--state", "both"), {"before", "after", "both"}))];
    options.size = sizeFrom("--size", given.text("--size", options.animate ? "1280x720" : "1600x900"), "picture-side");
    options.backend = backendFrom(given);
    options.allowed = given.allowedFolders();
    return options;
}

using course::Expectation;
using course::Lesson;
using report::MeasuredExpectation;

/// "falseShadow of slot 2 in box 1", "fact 'sum of form factors'".
std::string nameOfExpectation(const Lesson& lesson, const Expectation& expected) {
    std::string name = expected.quantity;
    if (!expected.fact.empty()) name += " '" + expected.fact + "'";
    if (lesson.states[0].slots.size() > 1) name += " of slot " + std::to_string(expected.slot + 1);
    if (expected.look) name += " in box " + std::to_string(*expected.look + 1);
    if (expected.reference) name += " against " + expected.reference->technique;
    return name;
}

/// Six digits are more than a table needs, and what rounding may change is not among them.
std::string shortNumber(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6);
    return error == std::errc{} ? std::string(buffer.data(), end) : std::string();
}

std::string table(const Lesson& lesson, const std::vector<MeasuredExpectation>& measured) {
    Rows rows{{"quantity", "before", "has to be", "after", "has to be", ""}};
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const Expectation& expected = lesson.expectations[i];
        const auto [before, after] = measured[i].values;
        rows.push_back({nameOfExpectation(lesson, expected), shortNumber(before), expected.before.text(),
                        shortNumber(after), expected.after.text(),
                        report::holdsAsExpected({measured[i]}) ? "as expected" : "NOT as expected"});
    }
    return lesson.text.title + ", " + std::to_string(lesson.size.x) + " x " + std::to_string(lesson.size.y) +
           " pixels\n\n" + aligned(rows, terminalColumns());
}

Json boundJson(const course::Bound& bound) {
    Json json = Json::object();
    if (bound.atLeast) json["atLeast"] = *bound.atLeast;
    if (bound.atMost) json["atMost"] = *bound.atMost;
    return json;
}

std::string lessonJson(const Lesson& lesson, const std::vector<MeasuredExpectation>& measured) {
    Json root{{"lesson", lesson.text.name},
              {"title", lesson.text.title},
              {"size", {lesson.size.x, lesson.size.y}},
              {"asExpected", report::holdsAsExpected(measured)},
              {"expectations", Json::array()}};
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const Expectation& expected = lesson.expectations[i];
        Json entry{{"quantity", nameOfExpectation(lesson, expected)}};
        const char* const names[] = {"before", "after"};
        for (std::size_t state = 0; state < 2; ++state) {
            Json one{{"value", measured[i].values[state]}, {"compared", measured[i].compared[state]}};
            one["bound"] = boundJson(state == 0 ? expected.before : expected.after);
            one["holds"] = measured[i].holds[state];
            entry[names[state]] = std::move(one);
        }
        root["expectations"].push_back(std::move(entry));
    }
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Work lessonWork(const GivenOptions& given) {
    return [options = lessonOptions(given)] { return lesson(options); };
}

} // namespace

int lesson(const LessonOptions& options) {
    if (!options.output.empty()) image::probeWritable(options.output);
    const Lesson lesson = course::loadLesson(options.lesson, loadOptions(options.allowed));
    if (!options.output.empty()) image::probeWritable(options.output); // it may be a file that the lesson is read from
    const std::unique_ptr<context::Context> context = context::createContext(options.backend);
    if (!options.output.empty()) {
        requireDriverDraws(options.size);
        const std::filesystem::path fonts = context::assetsRoot() / "fonts";
        const image::Font font(fonts / "DejaVuSans.ttf"), bold(fonts / "DejaVuSans-Bold.ttf");
        const std::vector<image::PngText> text{{"Title", lesson.text.title}};
        if (options.animate) {
            const auto film = film::makeFilm(options.output, course::kLessonTick, text);
            course::filmLesson(lesson, {options.size, options.holdSeconds}, font, bold, *film);
            film->finish();
        } else {
            const image::Image figure = course::lessonFigure(lesson, options.states, options.size, font, bold);
            context::throwIfInterrupted();
            image::writeWhole(options.output, image::encodePng(figure, {.opaque = true, .text = text}));
        }
    }
    if (!options.measure) return 0;
    const std::vector<MeasuredExpectation> measured = report::measureLesson(lesson);
    context::throwIfInterrupted();
    print(options.json ? lessonJson(lesson, measured) : table(lesson, measured));
    if (!report::holdsAsExpected(measured))
        throw Error(ExitStatus::badInput, scene::shownPath(lesson.text.file) +
                                              ": what was measured is not as the lesson says; change its settings, or "
                                              "its bounds under \"expect\"");
    return 0;
}

const Command kLesson{"lesson", "LESSON", "An artefact and its remedy: draws a lesson, or measures whether it holds",
                      describeLesson, lessonWork};

} // namespace shadowlab::cli
