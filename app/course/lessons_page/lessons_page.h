// All lessons as one page for a browser: of each its picture, a question, and after the answer what is wrong, the remedy, and what was
// measured. It is whole without a script, and printed it is a question sheet with its key; the script (assets/pages/lessons.js) makes of it
// one lesson at a time, and keeps the answers on the reader's device.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/course/lessons_page/lesson_choices.h"
#include "app/course/lessons_page/lesson_pictures.h"

namespace shadowlab::course {

struct PageLesson {
    LessonChoices asked;
    std::array<LessonFrames, 2> pictures;
    std::vector<std::array<double, 2>> measured; ///< before and after, of each of the lesson's expectations
};

/// One line of the key to a printed page, and of the overview.
struct PageEntry {
    std::string chapter, title;
    std::string answer; ///< "B: Shadow acne"
    std::string section;
};
PageEntry pageEntry(const Lesson& lesson, const PageLesson& page, std::size_t number, std::size_t count);

/// The whole page, with script and style from the files of assets/pages. Throws Error (badInput) where one is missing.
std::string lessonsPage(const std::vector<PageEntry>& entries, const std::filesystem::path& assets);

} // namespace shadowlab::course
