// What of the lecture's algorithm a student is to write: assets/skeletons/*.json. A skeleton is the lecture's own source
// (techniques/lecture) with some lines taken out, so that there is no second copy of the algorithm.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "techniques/source_text.h"

namespace shadowlab::student {

/// Texts of source files by their names in the project: "techniques/lecture/planar.cpp", "shaders/lecture/project.vert".
using SourceFiles = std::map<std::string, std::string>;

/// Lines that are taken out, and what stands in their place.
struct Blank {
    std::string anchor; ///< the region they are in: what follows `// [anchor: NAME]` (techniques/source_text.h)
    std::string first,
        last;         ///< of these lines, as they stand in the source but for their indentation; often one and the same
    std::string idea; ///< of the lecture, in a few words
    std::string explanation;          ///< the idea in sentences, and what is seen with the stand-in
    std::string whenRight;            ///< what is seen when it is filled in rightly
    std::vector<std::string> standIn; ///< code with which the technique builds and runs, if wrongly
    std::string place;                ///< "FILE:LINE:COLUMN" of this description, for messages
};

struct Skeleton {
    std::string source;        ///< techniques/lecture/SOURCE.cpp
    std::string family;        ///< what `grade` asks of it (grading/families.h)
    std::string title;         ///< "Planar projected shadows"
    std::string scene;         ///< a built-in one in which one sees whether it is right
    std::vector<Blank> blanks; ///< they are numbered from 1 in this order
};

/// Throws Error (badInput) with file, line and remedy.
Skeleton readSkeleton(const std::filesystem::path& file);

/// With their anchors and their lines.
SourceText asSourceText(const SourceFiles& files);

/// Where a blank's lines are.
struct BlankedLines {
    std::string file;
    std::size_t first = 0, last = 0; ///< index of the first and of the last of them, counted from 0
};

/// Throws Error (badInput): there is no such anchor, or not exactly one such line in its region.
BlankedLines findLines(const SourceFiles& files, const Blank& blank);

/// Takes the lines out of the files, and puts in the stand-ins, each between `=== BLANK n` and `=== END OF BLANK n`. Throws as
/// findLines(), and where two blanks share a line.
void makeBlanks(SourceFiles& files, const std::vector<Blank>& blanks);

} // namespace shadowlab::student
