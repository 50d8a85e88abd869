// SPDX-License-Identifier: MIT
#include "app/cli/lessons_page.h"

#include <algorithm>

#include "app/cli/common_options.h"
#include "app/cli/progress.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/lessons_page/lessons_page.h"
#include "app/report/lesson_measure.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::cli {

std::vector<std::string> lessonNames() {
    std::vector<std::string> names;
    for (const course::LessonText& lesson : course::builtInLessons(context::assetsRoot()))
        names.push_back(lesson.name);
    return names;
}

void writeLessonsPage(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    const std::vector<course::LessonText> all = course::builtInLessons(context::assetsRoot());
    const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    const std::filesystem::path file = folder / (std::string(kLessonsPage) + ".html");
    image::probeWritable(file);
    Progress progress("lesson", static_cast<int>(names.size()), Progress::Remaining::told);
    std::vector<course::PageEntry> entries;
    for (const course::LessonText& text : all) {
        if (std::ranges::find(names, text.name) == names.end()) continue;
        const course::Lesson lesson = course::loadLesson(text.name, loadOptions({}));
        course::PageLesson page{course::choicesOf(lesson, all), course::lessonPictures(lesson, font, context::throwIfInterrupted), {}};
        for (const report::MeasuredExpectation& measured : report::measureLesson(lesson))
            page.measured.push_back(measured.values);
        context::throwIfInterrupted();
        entries.push_back(course::pageEntry(lesson, page, entries.size() + 1, names.size()));
        progress.done(static_cast<int>(entries.size()));
    }
    image::writeWhole(file, course::lessonsPage(entries, context::assetsRoot()));
}

} // namespace shadowlab::cli
