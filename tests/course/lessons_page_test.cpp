// The page of lessons: whatever is built in stands in it, in order, with its words, its question, its remedy and its numbers.
// SPDX-License-Identifier: MIT
#include "app/course/lessons_page/lessons_page.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "app/drawing/markup.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::course {
namespace {

/// As it would be drawn and measured: pictures of a few bytes, and numbers that hold or do not.
PageLesson pageOf(const Lesson& lesson, const std::vector<LessonText>& course, double measured) {
    const auto frames = static_cast<std::size_t>(lesson.motion.frames);
    const std::vector<std::uint8_t> picture{1, 2, 3};
    return {choicesOf(lesson, course), {LessonFrames(frames, picture), LessonFrames(frames, picture)},
            std::vector<std::array<double, 2>>(lesson.expectations.size(), {measured, measured})};
}

TEST(LessonsPage, EveryBuiltInLessonStandsInIt) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    std::vector<PageEntry> entries;
    for (const LessonText& text : course) {
        const Lesson lesson = loadLesson(text.name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        entries.push_back(pageEntry(lesson, pageOf(lesson, course, 0), entries.size() + 1, course.size()));
        const std::string& section = entries.back().section;
        for (const std::string& words : {text.chapter, text.title, text.happens, text.remedy, lesson.look[0].label.substr(0, lesson.look[0].label.find(" ("))})
            EXPECT_NE(section.find(drawing::escapedMarkup(words)), std::string::npos) << words;
        EXPECT_EQ(section.find("(Space)"), std::string::npos) << "a key of the window's";
        for (const LessonChange& change : changesOf(lesson))
            EXPECT_NE(section.find("<td>" + drawing::escapedMarkup(change.after) + "</td>"), std::string::npos) << change.name;
    }
    ASSERT_GE(entries.size(), 33u);
    const std::string page = lessonsPage(entries, context::assetsRoot());
    std::size_t at = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        EXPECT_NE(page.find("<a href=\"#lesson-" + number + "\">"), std::string::npos);
        const std::size_t section = page.find("id=\"lesson-" + number + "\" data-name=\"" + course[i].name + "\"");
        ASSERT_NE(section, std::string::npos) << course[i].name;
        EXPECT_GT(section, at) << "in the order of the course";
        at = section;
    }
    for (const std::string& chapter : chaptersOf(course))
        EXPECT_NE(page.find("<h2>" + chapter + "</h2>"), std::string::npos) << chapter;
}

TEST(LessonsPage, ANumberThatIsNotAsExpectedSaysSo) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    const Lesson acne = loadLesson("acne", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    ASSERT_EQ(acne.expectations.size(), 1u);
    const auto numberSaid = [&](double value) { return pageEntry(acne, pageOf(acne, course, value), 1, 1).section; };
    const std::string few = numberSaid(100.25); // too few before, few enough after
    EXPECT_NE(few.find("<data value=\"100.25\">100</data> <small>expected at least 5000, and it is not</small>"), std::string::npos) << few;
    EXPECT_NE(few.find("<data value=\"100.25\">100</data> <small>expected at most 150</small>"), std::string::npos) << few;
}

TEST(LessonsPage, WhatIsWrittenInALessonIsNoMarkup) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    Lesson lesson = loadLesson("acne", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    lesson.text.name = "o\"wn";
    lesson.text.title = lesson.text.chapter = lesson.text.happens = lesson.text.remedy = lesson.look[0].label = "<script>&\"";
    const PageEntry entry = pageEntry(lesson, pageOf(lesson, course, 0), 1, 1);
    const std::string page = lessonsPage({entry}, context::assetsRoot());
    EXPECT_EQ(page.find("<script>&"), std::string::npos);
    EXPECT_NE(page.find("&lt;script&gt;&amp;"), std::string::npos);
    EXPECT_NE(page.find("data-name=\"o&quot;wn\""), std::string::npos) << entry.section.substr(0, 300);
}

TEST(LessonsPage, AMissingScriptIsNamed) {
    try {
        static_cast<void>(lessonsPage({}, "no-such-folder"));
        FAIL() << "there is no script";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("lessons.css"), std::string::npos) << error.what();
        EXPECT_EQ(error.status(), ExitStatus::badInput);
    }
}

} // namespace
} // namespace shadowlab::course
