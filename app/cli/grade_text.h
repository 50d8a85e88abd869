// The score sheet of `grade` as a text, and as the JSON of --json.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/student/grading/blank_names.h"
#include "app/student/grading/grader.h"
#include "app/student/grading/sheets/found_scene.h"

namespace shadowlab::cli {

/// What a sheet is made of.
struct GradedSheet {
    const student::Sheet& sheet;
    const std::vector<student::Blank>& blanks;
    const std::optional<student::SearchReport>& search; ///< none: no search was asked for
    std::string picture;                                ///< of the first failing case; empty: none was written
};

/// `columns`: of the terminal that it has to fit; none: of a pipe.
std::string sheetText(const GradedSheet& graded, std::optional<std::size_t> columns);

std::string sheetJson(const GradedSheet& graded);

} // namespace shadowlab::cli
