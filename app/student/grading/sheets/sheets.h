// The score sheet in forms that others read. In each, every failing case has its picture, and says which blanks it is about.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/student/grading/blank_names.h"
#include "app/student/grading/grader.h"
#include "app/student/grading/sheets/found_scene.h"

namespace shadowlab::student {

/// One page that needs nothing from elsewhere: pictures are in it, as data.
std::string htmlSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search);

/// results.json of a Gradescope autograder: https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format".
std::string gradescopeSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search);

/// What a combinator template grader of Moodle's question type CodeRunner prints: https://github.com/trampgeek/moodle-qtype_coderunner,
/// "Combinator-template grading".
std::string coderunnerSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search);

} // namespace shadowlab::student
