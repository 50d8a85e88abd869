// The page of lessons, as `shadowlab slides lessons` writes it: lessons.html.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace shadowlab::cli {

/// What the page is called beside the names of decks, and its file without the ending.
constexpr const char* kLessonsPage = "lessons";

/// The names of the built-in lessons in the order of the course.
std::vector<std::string> lessonNames();

/// Draws and measures the built-in lessons of these names, in the order of the course, and writes DIR/lessons.html when all is there.
/// Throws Error (cannotWrite), what loading and measuring lessons throws, and context::Interrupted. Needs a current GL context.
void writeLessonsPage(const std::filesystem::path& folder, const std::vector<std::string>& names);

} // namespace shadowlab::cli
