// A step of an algorithm as text: its formula, its place in the lecture's pseudocode, and the lines of source that do it, each
// with the probe of a picked pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/source_text.h"

namespace shadowlab::picture {

struct StepLine {
    int number = 0; ///< in its text, from 1
    std::string text;
    bool isCurrent = false;
    std::string values; ///< "d(u,v) = 0.93": of the names in it that have one; each is said where it stands first
};

/// The lines of the step alone; what is left out before, between and after them is a line "..." each. All lines, where none is of the step.
std::vector<StepLine> linesOfStep(const std::vector<StepLine>& lines);

/// Lines that follow each other in one file: those of the step, and a few around them.
struct SourcePiece {
    std::string file; ///< relative to the project
    std::vector<std::string> anchors;
    std::vector<StepLine> lines;
};

struct StepSource {
    std::vector<StepLine> formula;
    std::vector<StepLine> pseudocode; ///< of the whole algorithm; the lines of the step are current
    std::vector<SourcePiece> pieces;
    std::vector<std::string>
        faults; ///< anchors that are missing or doubled, as while a shader is being edited; a line each
};

/// Of a pass; without one, of the algorithm as a whole, which is its pseudocode. `params` are those of the technique as they are
/// set: they choose between lines of which only some run. `probe`: what is known of a pixel; none: nothing.
StepSource stepSource(const TechniqueInfo& info, const PassInfo* pass, const params::ParamList& params,
                      const SourceText& source, const Probe* probe = nullptr);

} // namespace shadowlab::picture
