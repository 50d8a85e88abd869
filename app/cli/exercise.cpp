// `shadowlab exercise`: a question sheet with random numbers, and its key.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/course/exercises/exercise.h"
#include "app/course/exercises/page_filling.h"
#include "app/course/exercises/sheet_page.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::cli {

namespace {

constexpr int kMostQuestions = 48;

struct ExerciseOptions {
    int seed = 1, questions = 8;
    std::filesystem::path output, key; ///< a folder to be made; a file, empty: in that folder
    std::vector<const course::ExerciseKind*> kinds;
    course::Paper paper = course::Paper::a4;
};

std::string kindNames() {
    std::string names;
    for (const course::ExerciseKind& kind : course::exerciseKinds())
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

void describeExercise(DescribedOptions& add) {
    add.option("--seed", "N", "which sheet: from 1 to 2000000000 (default 1); the same number, the same bytes");
    add.option("-o,--output", "DIR", "the folder to be made; it is not there yet");
    add.option("--questions", "K", "number of exercises, 1 to 48 (default 8)");
    add.option("--kind", "NAME[,NAME...]", "exercises of that kind alone; may be repeated (default: all kinds)");
    add.option("--key", "FILE.html", "where the key goes (default DIR/key.html)");
    add.option("--paper", "a4|letter", "what the pages are printed on (default a4)");
    add.footer(
        "Writes DIR/sheet.html, which is handed out and has no answers, and DIR/key.html. Both print from a browser.\n"
        "Kinds: " +
        kindNames() +
        "\n"
        "Examples:\n"
        "  shadowlab exercise --seed 7 -o sheet-7\n"
        "  shadowlab exercise --seed 7 --kind counts,texel --questions 4 -o volumes-and-maps\n"
        "  shadowlab exercise --seed 7 -o handed-out --key teacher/key-7.html --paper letter");
}

ExerciseOptions exerciseOptions(const GivenOptions& given) {
    ExerciseOptions options;
    options.seed = countFrom("--seed", given.text("--seed", "1"), kMostSeed);
    options.questions = countFrom("--questions", given.text("--questions", "8"), kMostQuestions);
    options.output = given.required("--output", "shadowlab exercise --seed 7 -o DIR");
    options.key = given.text("--key");
    if (!options.key.empty()) requireEnding("--key", options.key, ".html");
    for (const std::string& name : splitAtCommas(given.texts("--kind")))
        options.kinds.push_back(&course::findExerciseKind(name));
    if (options.kinds.empty())
        for (const course::ExerciseKind& kind : course::exerciseKinds())
            options.kinds.push_back(&kind);
    options.paper = choiceFrom("--paper", given.text("--paper", "a4"), {"a4", "letter"}) == 0 ? course::Paper::a4
                                                                                              : course::Paper::letter;
    return options;
}

int exercise(const ExerciseOptions& options) {
    if (!options.key.empty()) image::probeWritable(options.key);
    const auto seed = static_cast<std::uint64_t>(options.seed);
    const std::vector<course::Exercise> exercises =
        course::fillPages(course::makeExercises(seed, options.questions, options.kinds));
    const std::string key = course::keyPage(exercises, seed, options.paper);
    image::writeFolder(options.output, [&](const std::filesystem::path& folder) {
        image::writeWhole(folder / "sheet.html", course::sheetPage(exercises, seed, options.paper));
        // Before the folder has its name: a run that is stopped in between can be started again, and then writes both.
        image::writeWhole(options.key.empty() ? folder / "key.html" : options.key, key);
    });
    print("Written: " + (options.output / "sheet.html").string() + " and " +
          (options.key.empty() ? options.output / "key.html" : options.key).string() + "\n");
    return 0;
}

Work exerciseWork(const GivenOptions& given) {
    return [options = exerciseOptions(given)] { return exercise(options); };
}

} // namespace

const Command kExercise{"exercise", "", "A question sheet with random numbers and figures, and its key",
                        describeExercise, exerciseWork};

} // namespace shadowlab::cli
