// Pieces of HTML that the forms of the score sheet share.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/student/grading/blank_names.h"
#include "app/student/grading/grader.h"
#include "app/student/grading/sheets/found_scene.h"

namespace shadowlab::student {

/// What is wrong in a case, its hint, its blanks, and its picture; of one that is right, that it is.
std::string caseHtml(const CaseResult& result, const Family& family, const std::vector<Blank>& blanks);
/// The same without the picture.
std::string caseText(const CaseResult& result, const Family& family, const std::vector<Blank>& blanks);

std::string searchHtml(const SearchReport& search, const std::vector<Blank>& blanks);

} // namespace shadowlab::student
