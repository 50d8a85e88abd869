// Every built-in lesson: its file loads, both states are drawn, and what is measured of them is as the file says. A checker that
// lets everything pass would be worth nothing: with the bounds of before and after swapped every lesson fails.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/context/assets.h"
#include "app/course/lessons/lesson.h"
#include "app/course/lessons/lesson_figure.h"
#include "app/report/lesson_measure.h"
#include "techniques/foundation/base/error.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab::course {
namespace {

constexpr std::size_t kLeastLessons = 33;
constexpr std::size_t kLeastQuestions = 3;

scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }

std::vector<Lesson> allLessons() {
    std::vector<Lesson> lessons;
    for (const LessonText& text : builtInLessons(context::assetsRoot()))
        lessons.push_back(loadLesson(text.name, loading()));
    return lessons;
}

class LessonsTest : public testing::GlTest {};

TEST_F(LessonsTest, TheArtefactIsThereAndTheRemedyRemovesIt) {
    const std::vector<Lesson> lessons = allLessons();
    EXPECT_GE(lessons.size(), kLeastLessons);
    int numbers = 0;
    for (const Lesson& lesson : lessons) {
        const std::vector<report::MeasuredExpectation> measured = report::measureLesson(lesson);
        ASSERT_EQ(measured.size(), lesson.expectations.size());
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const Expectation& expected = lesson.expectations[i];
            const std::string what = lesson.text.name + ", " + expected.quantity;
            EXPECT_TRUE(measured[i].holds[0])
                << what << " before: " << measured[i].values[0] << ", has to be " << expected.before.text();
            EXPECT_TRUE(measured[i].holds[1])
                << what << " after: " << measured[i].values[1] << ", has to be " << expected.after.text();
            EXPECT_GT(measured[i].compared[0], 0) << what << ": nothing was compared";
            EXPECT_GT(measured[i].compared[1], 0) << what << ": nothing was compared";
            // The checker itself: what holds of one state must not hold of the other.
            EXPECT_FALSE(expected.before.holds(measured[i].values[1]) && expected.after.holds(measured[i].values[0]))
                << what << ": the bounds do not tell before from after";
            ++numbers;
        }
    }
    EXPECT_GE(numbers, static_cast<int>(kLeastLessons));
}

TEST_F(LessonsTest, SwappedBoundsAreFoundOut) {
    Lesson lesson = loadLesson("acne", loading());
    EXPECT_TRUE(report::holdsAsExpected(report::measureLesson(lesson)));
    for (Expectation& expected : lesson.expectations)
        std::swap(expected.before, expected.after);
    EXPECT_FALSE(report::holdsAsExpected(report::measureLesson(lesson)));
    lesson.expectations.clear();
    EXPECT_FALSE(report::holdsAsExpected(report::measureLesson(lesson))) << "nothing was measured, and that is no proof";
}

// Quantities that no picture tells: what a technique has counted, and what its probe knows of a pixel.
TEST_F(LessonsTest, CountersAndFactsAreMeasuredByTheirLabels) {
    const std::string text = R"({"title": "T", "scene": "still-life", "slots": [{"technique": "shadow-map"}],
        "before": {"set": ["shadow-map.resolution=64"]}, "after": {"set": ["shadow-map.resolution=128"]},
        "happens": "H.", "mends": "M.", "look": [{"box": [0.1, 0.2, 0.3, 0.4], "label": "here"}],
        "expect": [{"quantity": "counter", "label": "map-texels", "before": {"atMost": 4096}, "after": {"atLeast": 16384}},
                   {"quantity": "fact", "label": "distance from the eye", "pixel": [0.5, 0.9],
                    "before": {"atLeast": 0.1}, "after": {"atMost": 10}}]})";
    const std::vector<report::MeasuredExpectation> measured = report::measureLesson(parseLesson(text, "x.json", loading()));
    ASSERT_EQ(measured.size(), 2u);
    EXPECT_EQ(measured[0].values[0], 64 * 64);
    EXPECT_EQ(measured[0].values[1], 128 * 128);
    EXPECT_EQ(measured[0].compared[0], 1);
    EXPECT_EQ(measured[1].values[0], measured[1].values[1]) << "the map does not move the floor";
    EXPECT_TRUE(report::holdsAsExpected(measured));
    std::string misspelt = text;
    misspelt.replace(misspelt.find("map-texels"), 10, "map-texel");
    try {
        report::measureLesson(parseLesson(misspelt, "x.json", loading()));
        ADD_FAILURE() << "a counter that there is not was measured";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_NE(std::string(error.what()).find("map-texels"), std::string::npos) << error.what();
    }
}

// A list by chapters and the way through the course are one order: the lessons of a chapter follow each other.
TEST_F(LessonsTest, EveryLessonIsInAChapterAndChaptersAreWhole) {
    const std::vector<LessonText> all = builtInLessons(context::assetsRoot());
    ASSERT_GE(all.size(), 30u);
    const std::vector<std::string> chapters = chaptersOf(all);
    EXPECT_GE(chapters.size(), 5u);
    EXPECT_LE(chapters.size(), all.size() / 3) << "a chapter is more than a lesson or two";
    std::size_t changes = 1;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_FALSE(all[i].chapter.empty()) << all[i].name;
        if (i > 0 && all[i].chapter != all[i - 1].chapter) ++changes;
    }
    EXPECT_EQ(changes, chapters.size()) << "the key \"order\" of a lesson lies between those of another chapter";
}

// The window says what the remedy changes; a lesson of which it can say nothing would show two pictures without a cause.
TEST_F(LessonsTest, EveryRemedyChangesSomethingThatIsSaid) {
    int said = 0;
    for (const LessonText& text : builtInLessons(context::assetsRoot())) {
        const std::vector<LessonChange> changes = changesOf(loadLesson(text.file.string(), loading()));
        EXPECT_FALSE(changes.empty()) << text.name;
        for (const LessonChange& change : changes)
            EXPECT_NE(change.before, change.after) << text.name << ", " << change.name;
        said += changes.empty() ? 0 : 1;
    }
    EXPECT_GE(said, 30);
}

// Each artefact that is looked for has a lesson, by the name under which it is looked for.
TEST_F(LessonsTest, NoArtefactIsMissing) {
    std::set<std::string> names;
    for (const LessonText& text : builtInLessons(context::assetsRoot()))
        names.insert(text.name);
    for (const char* name : {"acne",
                             "peter-panning",
                             "grazing-light",
                             "light-bleeding",
                             "cube-seams",
                             "eye-in-shadow",
                             "near-clip",
                             "far-clip",
                             "stencil-overflow",
                             "extrusion-too-short",
                             "open-mesh",
                             "double-darkening",
                             "anti-shadow",
                             "z-fighting",
                             "ray-self-intersection",
                             "missed-rays",
                             "energy-gain",
                             "leak-under-a-wall",
                             "noise",
                             "shimmering-cascades",
                             "large-coordinates"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST_F(LessonsTest, FiguresAreTheSameBytesAgainAndFramesAreOrange) {
    const Lesson lesson = loadLesson("acne", loading());
    const std::filesystem::path fonts = context::assetsRoot() / "fonts";
    const image::Font font(fonts / "DejaVuSans.ttf"), bold(fonts / "DejaVuSans-Bold.ttf");
    const image::Image figure = lessonFigure(lesson, {0, 1}, {640, 360}, font, bold);
    EXPECT_EQ(figure, lessonFigure(lesson, {0, 1}, {640, 360}, font, bold));
    int framed = 0;
    for (int y = 0; y < figure.height; ++y)
        for (int x = 0; x < figure.width; ++x)
            framed += figure.at(x, y) == image::Color8{0xE6, 0x9F, 0x00, 255} ? 1 : 0;
    EXPECT_GT(framed, 500); // two boxes of some 400 pixels around, two pixels wide, and two headings
    EXPECT_THROW(lessonFigure(lesson, {0, 1}, {120, 400}, font, bold), Error);
}

TEST_F(LessonsTest, EveryLessonIsInTheDocumentAsItsFileSays) {
    std::set<std::string> titles;
    std::size_t questions = 0;
    for (const Lesson& lesson : allLessons()) {
        EXPECT_TRUE(titles.insert(lesson.text.title).second) << lesson.text.title << " twice";
        questions += lesson.question ? 1 : 0;
        EXPECT_NE(documentOf(lesson.states[0]), documentOf(lesson.states[1])) << lesson.text.name;
        for (const ShownState& state : lesson.states) {
            const lab::Document document = documentOf(state);
            EXPECT_EQ(document.layout, state.layout);
            EXPECT_EQ(document.camera, state.camera);
            for (std::size_t i = 0; i < state.slots.size(); ++i)
                EXPECT_EQ(document.panes[i], state.slots[i]) << lesson.text.name;
        }
    }
    EXPECT_GE(questions, kLeastQuestions);
}

} // namespace
} // namespace shadowlab::course
