// What the page of lessons asks: the right answer is there once, and no other one is true as well.
// SPDX-License-Identifier: MIT
#include "app/course/lessons_page/lesson_choices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/context/assets.h"

namespace shadowlab::course {
namespace {

Lesson lessonNamed(const std::string& name) { return loadLesson(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}); }

/// A lesson of which no more than the words are known.
Lesson lessonOf(const LessonText& text) {
    Lesson lesson;
    lesson.text = text;
    return lesson;
}

LessonText text(const std::string& name, const std::string& chapter, std::vector<std::string> alike = {}) {
    return {.name = name, .file = {}, .title = "The title of " + name, .chapter = chapter, .happens = "H.", .remedy = "M.", .alike = std::move(alike)};
}

TEST(LessonChoices, OfEveryBuiltInLessonTheRightOneIsThereOnce) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    std::map<std::size_t, int> places;
    int titles = 0;
    for (const LessonText& lesson : course) {
        const LessonChoices asked = choicesOf(lessonOf(lesson), course);
        ASSERT_LT(asked.right, asked.choices.size());
        EXPECT_EQ(asked.choices[asked.right], lesson.title);
        EXPECT_GE(asked.choices.size(), 3u) << lesson.name;
        EXPECT_LE(asked.choices.size(), 4u) << lesson.name;
        EXPECT_EQ(std::set(asked.choices.begin(), asked.choices.end()).size(), asked.choices.size()) << lesson.name;
        for (const std::string& choice : asked.choices) {
            const auto found = std::ranges::find(course, choice, &LessonText::title);
            ASSERT_NE(found, course.end()) << choice;
            EXPECT_EQ(std::ranges::count(lesson.alike, found->name), 0) << lesson.name << " is like " << found->name;
            EXPECT_EQ(std::ranges::count(found->alike, lesson.name), 0) << found->name << " is like " << lesson.name;
            EXPECT_EQ(found->chapter.substr(0, found->chapter.find(':')), lesson.chapter.substr(0, lesson.chapter.find(':')));
            ++titles;
        }
        ++places[asked.right];
        const LessonChoices again = choicesOf(lessonOf(lesson), course);
        EXPECT_EQ(again.choices, asked.choices);
    }
    EXPECT_GE(course.size(), 33u);
    EXPECT_GE(titles, 3 * 33);
    for (const std::size_t place : {0, 1, 2}) // a fair die would give each of them about a quarter of 33
        EXPECT_GE(places[place], 4) << "the right one stands hardly ever at place " << place;
}

TEST(LessonChoices, NamesOfAlikeLessonsAreLessons) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    int names = 0;
    for (const LessonText& lesson : course)
        for (const std::string& alike : lesson.alike) {
            EXPECT_NE(std::ranges::find(course, alike, &LessonText::name), course.end()) << lesson.name << " is like " << alike;
            EXPECT_NE(alike, lesson.name);
            ++names;
        }
    EXPECT_GE(names, 10);
}

TEST(LessonChoices, LessonsThatAreAlikeAreNoAnswersToEachOther) {
    const std::vector<LessonText> course{text("a", "One: x", {"b"}), text("b", "One: x"), text("c", "One: y"), text("d", "One: y"), text("e", "Two"),
                                         text("f", "Two")};
    for (const std::size_t lesson : {0, 1}) {
        const LessonChoices asked = choicesOf(lessonOf(course[lesson]), course);
        EXPECT_EQ(asked.choices.size(), 3u); // c and d; of another kind of technique none is taken where there are two
        EXPECT_EQ(std::ranges::count(asked.choices, course[1 - lesson].title), 0);
    }
    EXPECT_EQ(choicesOf(lessonOf(course[2]), course).choices.size(), 4u);
    const LessonChoices lonely = choicesOf(lessonOf(course[4]), course); // beside f one of another kind, so that there are two
    EXPECT_EQ(lonely.choices.size(), 3u);
    EXPECT_EQ(std::ranges::count(lonely.choices, course[5].title), 1);
}

TEST(LessonChoices, ALessonAsksItsOwnQuestion) {
    const std::vector<LessonText> course = builtInLessons(context::assetsRoot());
    const LessonChoices own = choicesOf(lessonNamed("stencil-overflow"), course);
    EXPECT_EQ(own.choices, (std::vector<std::string>{"under one sheet", "under two", "under three", "under all four"}));
    EXPECT_EQ(own.right, 3u);
    EXPECT_EQ(own.picture, 1u);
    // A shadow to be painted is none for a page; what is told before that stays.
    const LessonChoices painted = choicesOf(lessonNamed("lost-near-the-light"), course);
    EXPECT_EQ(painted.question, "A ball hangs high above the floor, out of the picture, and the sun stands over it. What has gone wrong here?");
    EXPECT_EQ(painted.choices[painted.right], "Too near to the light to be drawn");
    EXPECT_EQ(painted.picture, 0u);
    EXPECT_EQ(choicesOf(lessonNamed("extrusion-too-short"), course).question, "What has gone wrong here?");
}

} // namespace
} // namespace shadowlab::course
