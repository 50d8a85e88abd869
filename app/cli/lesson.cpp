// `shadowlab lesson`: a lesson as a picture, and whether its artefact is really there and really gone.
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "app/cli/command_line.h"
#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/cli/text_table.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/lessons/lesson_figure.h"
#include "app/course/lessons/lesson_film.h"
#include "app/course/lessons/lesson_quantities.h"
#include "app/picture/limits.h"
#include "app/report/lesson_measure.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

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
           " pixels\n\n" + aligned(rows);
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

} // namespace

int lesson(const LessonOptions& options) {
    if (!options.output.empty()) image::probeWritable(options.output);
    const Lesson lesson = course::loadLesson(
        options.lesson, {.assetsRoot = context::assetsRoot(), .allowed = options.allowed, .limits = picture::limits()});
    if (!options.output.empty()) image::probeWritable(options.output); // it may be a file that the lesson is read from
    const std::unique_ptr<context::Context> context = context::createContext(options.backend);
    if (!options.output.empty()) {
        if (const int limit = context::largestSide(); std::max(options.size.x, options.size.y) > limit)
            throw Error(ExitStatus::overLimit, "this OpenGL driver draws pictures of up to " + std::to_string(limit) +
                                                   " pixels on a side; choose a smaller --size");
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

} // namespace shadowlab::cli
