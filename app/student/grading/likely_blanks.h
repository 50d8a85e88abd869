// Which blank it may be, by the cases that fail: with each blank left empty, or filled in with the mistake that tests/plugins/solutions.py
// has for it, and all others filled in rightly, certain cases fail and no others.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/student/grading/blank_names.h"
#include "app/student/grading/grader.h"

namespace shadowlab::student {

/// Those with which just the cases of the sheet fail that do. Empty: none.
std::vector<int> likelyBlanks(const Sheet& sheet);

/// The same as a sentence; empty where there are none, or so many that it would say nothing.
std::string likelyText(const Sheet& sheet, const std::vector<Blank>& blanks);

/// The cases that fail, in order, as '1', the others as '0': what likelyBlanks() goes by.
std::string failingCases(const Sheet& sheet);

} // namespace shadowlab::student
