// The blanks of a family's skeleton by number, so that a case, or a scene, can say which of them it is about.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/student/blanks.h"
#include "app/student/grading/families.h"

namespace shadowlab::student {

/// Of the skeleton with that family. Throws Error (badInput) where a file of the program is missing.
std::vector<Blank> blanksOf(const Family& family);

/// "blank 2 (the plane's equation)"; of several "blank 1 (...), or blank 2 (...)"; empty where there are none, or more than three.
std::string namesOf(const std::vector<int>& numbers, const std::vector<Blank>& blanks);

} // namespace shadowlab::student
