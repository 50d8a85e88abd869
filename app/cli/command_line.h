// The command line: one function per subcommand.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/capture_options.h"
#include "app/cli/grade_options.h"
#include "app/cli/lesson_options.h"
#include "app/cli/measure_options.h"
#include "app/cli/new_technique_options.h"
#include "app/cli/probe_options.h"
#include "app/cli/report_options.h"
#include "app/cli/slides_options.h"

namespace shadowlab::cli {

int capture(const CaptureOptions& options);

/// Prints what was measured to standard output.
int measure(const MeasureOptions& options);

/// Writes a report into a folder, or puts the parts of one together.
int report(const ReportOptions& options);
/// The same of the hard cases. 0: all are as they have to be; 1: some are not.
int reportHard(const ReportOptions& options);

/// Prints what a technique knows about one pixel to standard output.
int probe(const ProbeOptions& options);

/// Draws a lesson, measures it, or both. Fails (badInput) when what was measured is not as the lesson says.
int lesson(const LessonOptions& options);
/// Draws decks. A slide that fails is told, and the others are drawn all the same: then the exit status is that of the first.
int slides(const SlidesOptions& options);

struct ListOptions {
    std::string what;
    bool json = false;
};
int list(const ListOptions& options);

/// Writes the folder, and what to do next to standard output.
int newTechnique(const NewTechniqueOptions& options);

/// Prints a score sheet. 0: all cases are right; 1: some are not.
int grade(const GradeOptions& options);

struct InspectOptions {
    std::string file; ///< an .obj, a .json or the name of a built-in scene
    bool json = false;
    std::vector<std::filesystem::path> allowed; ///< further folders a scene may take meshes from
};
int inspect(const InspectOptions& options);

struct DemoOptions {
    std::string scene = "still-life";
    std::string lesson; ///< to begin with; empty: none
    std::string deck;   ///< the same
    std::string slide;  ///< one of the deck's by its name; empty: the first
    ivec2 size{0};      ///< of the window; zero: what it was the last time
    bool presenter = false, keepSettings = true, report = false;
    std::vector<std::filesystem::path> allowed;
};
/// Opens the window. Where there can be none it writes NAME-comparison.png into the current folder and its path to standard
/// output, and says why.
int demo(const DemoOptions& options);

/// What the words of a command line ask for: a subcommand with its options, or help. The result is the exit status.
using Work = std::function<int()>;

/// Understands the words, and refuses what is wrong in them, before anything is done. Throws Error (usage, overLimit).
/// The first word is the program's own name; `plugins`: the files of --plugin.
Work workFor(const std::vector<std::string>& words, const std::vector<std::string>& plugins);

/// Loads plug-ins, understands the other words and does what they ask for. Throws Error.
int run(int argc, char** argv);

} // namespace shadowlab::cli
