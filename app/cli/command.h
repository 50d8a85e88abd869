// A command of the program: its name, its options, and its work. Each command is a file that describes its options, checks
// what was written for them, and does the work.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "app/cli/options.h"

namespace shadowlab::cli {

/// What a command line asks for. The result is the exit status.
using Work = std::function<int()>;

struct Command {
    const char* name; ///< the word on the command line
    const char*
        arguments;    ///< what stands behind the options: "SCENE"; in brackets what may be left out; empty: nothing
    const char* help; ///< a sentence for `shadowlab --help`
    void (*describe)(DescribedOptions& add);
    /// Checks what was written, before anything is done. Throws Error (usage, overLimit) for what is wrong in itself; what
    /// depends on the scene, or on the graphics card, is checked by the work.
    Work (*work)(const GivenOptions& given);
};

extern const Command kCapture, kMeasure, kReport, kProbe, kDemo, kLesson, kSlides, kList, kNewTechnique, kGrade,
    kInspect, kPack, kExport, kJudge, kExercise;

} // namespace shadowlab::cli
