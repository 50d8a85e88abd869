// What `grade` is asked for.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/student/grading/child_program.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct GradeOptions {
    std::filesystem::path plugin;
    std::string technique;        ///< empty: the plug-in's only one
    std::string family;           ///< empty: what the plug-in says
    std::filesystem::path output; ///< a folder; empty: no picture is written
    student::ChildLimits limits;
    std::string backend = "auto";
    bool json = false;
};

void describeGrade(CLI::App& command);

/// From what was written to what is meant; `plugins` are those that the command line names. Throws Error (usage).
GradeOptions gradeOptions(const CLI::App& command, const std::vector<std::string>& plugins);

} // namespace shadowlab::cli
