// The blanks of a family's skeleton by number, so that a case, or a scene, can say which of them it is about.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/student/blanks.h"
#include "app/student/grading/families.h"

namespace shadowlab::student {

/// Of the family's skeleton, of a plug-in that was made from it; none where it was made from another one, or from none (empty). Throws Error
/// (badInput) where a file of the program is missing.
std::vector<Blank> blanksOf(const Family& family, const std::string& skeleton);

/// "blank 2 (the plane's equation)"; of several "blank 1 (...), or blank 2 (...)"; empty where there are none, more than three,
/// or no blanks at all.
std::string namesOf(const std::vector<int>& numbers, const std::vector<Blank>& blanks);

} // namespace shadowlab::student
