// Lessons in the window: every step of every lesson, the questions, and what was there before.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <set>
#include <thread>

#include "app/context/assets.h"
#include "app/lab/camera_control.h"
#include "app/window/panels/story_page.h"
#include "app/window/screen.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using window::LessonStep;

class LessonStateTest : public testing::GlTest {
protected:
    static scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }
    static lab::Document beginning() {
        return lab::newDocument(scene::loadScene("sphere-on-plane", loading()), "sphere-on-plane");
    }
    struct Lab {
        /// `live`: with a user, to whom the judge yields; without one exact errors come at once.
        explicit Lab(bool live = true) : ui(beginning()), screen(with(ui, live), font()) {
            ui.lesson.all = course::builtInLessons(context::assetsRoot());
            ui.lesson.loading = loading();
        }
        void press(int key, bool shift = false) {
            ui.keys.push_back({key, false, shift, false, false});
            screen.frame(0.03);
        }
        static std::filesystem::path font() { return context::assetsRoot() / "fonts" / "DejaVuSans.ttf"; }
        static window::WindowState& with(window::WindowState& ui, bool live) {
            ui.live = live;
            return ui;
        }
        window::WindowState ui;
        window::Screen screen;
    };
};

TEST_F(LessonStateTest, TheCourseGoesThroughAllLessonsAndBackAndLeavesNothing) {
    Lab lab;
    window::WindowState& ui = lab.ui;
    const lab::Document before = ui.bench.document();
    std::vector<std::pair<std::string, LessonStep>> way;
    std::set<std::string> names;
    for (std::size_t i = 0; names.size() < ui.lesson.all.size() || ui.lesson.step != LessonStep::remedy; ++i) {
        ASSERT_LT(i, 200u);
        window::stepLesson(ui, 1);
        ASSERT_TRUE(ui.messages.empty()) << ui.messages.front().text;
        ASSERT_TRUE(ui.lesson.isOn());
        way.emplace_back(ui.lesson.now->text.name, ui.lesson.step);
        names.insert(way.back().first);
    }
    EXPECT_GE(way.size(), 2 * ui.lesson.all.size() + 4); // two steps each, and more where they ask
    for (auto step = way.rbegin() + 1; step != way.rend(); ++step) {
        window::stepLesson(ui, -1);
        EXPECT_EQ(ui.lesson.now->text.name, step->first);
        EXPECT_EQ(ui.lesson.step, step->second);
    }
    window::leaveLesson(ui);
    EXPECT_EQ(ui.bench.document(), before);
}

// What the class is to find out, no key may show; and no pixel is picked in a picture that nobody sees.
TEST_F(LessonStateTest, TheCourseEndsWhereItBegins) {
    Lab lab;
    window::WindowState& ui = lab.ui;
    window::openLesson(ui, ui.lesson.all.front().name);
    const LessonStep first = ui.lesson.step;
    window::stepLesson(ui, -1);
    EXPECT_EQ(ui.lesson.now->text.name, ui.lesson.all.front().name) << "not the last lesson";
    EXPECT_EQ(ui.lesson.step, first);
    EXPECT_FALSE(ui.requests.news.empty());
    window::openLesson(ui, ui.lesson.all.back().name, true);
    window::stepLesson(ui, 1);
    EXPECT_EQ(ui.lesson.now->text.name, ui.lesson.all.back().name) << "not the first";
}

TEST_F(LessonStateTest, WhileTheShadowIsPaintedNothingShowsIt) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const lab::Document before = lab.ui.bench.document();
    for (const course::LessonText& text : lab.ui.lesson.all) {
        window::openLesson(lab.ui, text.name);
        if (lab.ui.lesson.paints()) break;
    }
    ASSERT_TRUE(lab.ui.lesson.paints());
    lab.screen.frame(0.03);
    const lab::Document asked = lab.ui.bench.document();
    for (const int key : {GLFW_KEY_E, GLFW_KEY_U, GLFW_KEY_O, GLFW_KEY_X, GLFW_KEY_N, GLFW_KEY_V}) {
        lab.press(key);
        EXPECT_EQ(lab.ui.bench.document(), asked) << "key " << key;
    }
    ASSERT_EQ(lab.ui.messages.size(), 6u) << "each says why";
    EXPECT_FALSE(lab.ui.messages[0].fault);
    lab.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::reveal);
    window::leaveLesson(lab.ui);
    EXPECT_EQ(lab.ui.bench.document(), before);
}

TEST_F(LessonStateTest, KeysGoOnAnswerAndLeave) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const lab::Document before = lab.ui.bench.document();
    window::openLesson(lab.ui, "eye-in-shadow");
    ASSERT_TRUE(lab.ui.lesson.asksChoice());
    lab.press(GLFW_KEY_2);
    EXPECT_EQ(lab.ui.lesson.chosen, 1);
    EXPECT_EQ(lab.ui.bench.document().panes[0].technique, "shadow-volume-zpass"); // an answer, and no technique
    lab.press(GLFW_KEY_J);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_J);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::remedy);
    EXPECT_EQ(lab.ui.bench.document().panes[0].values().at("eye-correction"), "true");
    lab.press(GLFW_KEY_J, true);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(lab.ui.lesson.isOn());
    EXPECT_EQ(lab.ui.bench.document(), before);
}

// One pair of keys goes through whatever the band tells of; steps within a lesson lead back to it.
TEST_F(LessonStateTest, PageKeysGoThroughTheLessonAndStepsWithinItLeadBack) {
    Lab lab;
    lab.screen.fit({960, 600}, 1);
    const lab::Document before = lab.ui.bench.document();
    window::openLesson(lab.ui, "acne");
    lab.screen.frame(0.03);
    EXPECT_EQ(storyMode(lab.ui), window::StoryMode::lesson);
    const lab::Document artefact = lab.ui.bench.document();
    lab.press(GLFW_KEY_N);
    EXPECT_TRUE(isStepping(lab.ui));
    EXPECT_EQ(storyMode(lab.ui), window::StoryMode::steps);
    EXPECT_EQ(outerMode(lab.ui), window::StoryMode::lesson);
    lab.press(GLFW_KEY_PAGE_DOWN); // now through the steps
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::artefact);
    EXPECT_EQ(storyMode(lab.ui), window::StoryMode::steps);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(storyMode(lab.ui), window::StoryMode::lesson);
    EXPECT_EQ(lab.ui.bench.document(), artefact);
    lab.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::remedy);
    lab.press(GLFW_KEY_PAGE_UP);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_PAGE_UP, true); // Shift scrolls the source
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(storyMode(lab.ui), window::StoryMode::explore);
    EXPECT_EQ(lab.ui.bench.document(), before);
}

// What is beyond the last step of a technique, or before the first, is the lesson again.
TEST_F(LessonStateTest, StepsWithinALessonEndInIt) {
    Lab lab;
    lab.screen.fit({960, 600}, 1);
    window::openLesson(lab.ui, "acne");
    lab.screen.frame(0.03);
    const lab::Document artefact = lab.ui.bench.document();
    int steps = 0;
    for (lab.press(GLFW_KEY_N); storyMode(lab.ui) == window::StoryMode::steps && steps < 20; lab.press(GLFW_KEY_N))
        ++steps;
    EXPECT_GE(steps, 3) << "lights off, the map, the comparison";
    EXPECT_EQ(lab.ui.bench.document(), artefact);
    EXPECT_FALSE(lab.ui.innerSteps.on);
}

// The band says what the judge has found of either state, and which setting made the difference.
TEST_F(LessonStateTest, WrongPixelsOfBothStatesAreKept) {
    Lab lab(false);
    lab.screen.setPatience(std::chrono::hours(1));
    lab.screen.fit({640, 400}, 1);
    const auto found = [&](std::size_t state) {
        for (int i = 0; i < 4000 && !lab.ui.lesson.judged[state]; ++i) {
            lab.screen.frame(0.03);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return lab.ui.lesson.judged[state];
    };
    window::openLesson(lab.ui, "acne");
    ASSERT_TRUE(found(0));
    EXPECT_FALSE(lab.ui.lesson.judged[1]);
    window::stepLesson(lab.ui, 1);
    ASSERT_TRUE(found(1));
    EXPECT_GT(lab.ui.lesson.judged[0]->wrong, 10 * lab.ui.lesson.judged[1]->wrong) << "stripes all over, and a few at edges";
    const std::vector<course::LessonChange> changes = course::changesOf(*lab.ui.lesson.now);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].name, "Bias type");
    EXPECT_EQ(changes[0].before, "no bias");
    EXPECT_EQ(changes[0].after, "receiver's plane at each texel") << "in words, as the panel has it";
}

// A lesson about edges says in the band what the pane's header says: one number for one thing, in the picture on show.
TEST_F(LessonStateTest, TheEdgeErrorIsThatOfThePictureOnShow) {
    Lab lab(false);
    lab.screen.setPatience(std::chrono::hours(1));
    lab.screen.fit({640, 400}, 1);
    window::openLesson(lab.ui, "grazing-light");
    EXPECT_FALSE(window::isMeasuredApart(*lab.ui.lesson.now));
    for (int i = 0; i < 4000 && !lab.ui.lesson.judged[0]; ++i) {
        lab.screen.frame(0.03);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(lab.ui.lesson.judged[0] && lab.ui.lesson.judged[0]->edgeErrorPx);
    const lab::PaneErrors* const shown = lab.screen.errors().errors(0);
    ASSERT_TRUE(shown && shown->edgeErrorPx);
    EXPECT_EQ(*lab.ui.lesson.judged[0]->edgeErrorPx, *shown->edgeErrorPx);
    EXPECT_EQ(lab.ui.lesson.judged[0]->pictureSize, shown->judged.view.size);
    EXPECT_TRUE(lab.screen.errors().areFinal(0));
    lab.ui.bench.setCamera(lab::orbited(lab.ui.bench.document().camera, 5, 0));
    lab.screen.frame(0.03);
    EXPECT_FALSE(lab.screen.errors().areFinal(0)) << "it is now the number of another picture";
}

// Radiosity that is solved while it is drawn has none of its stages before: the pane waits, and does not fail.
TEST_F(LessonStateTest, AStageThatIsNotThereYetIsWaitedFor) {
    Lab lab;
    lab.screen.setPatience(std::chrono::milliseconds(0));
    lab.screen.fit({640, 400}, 1);
    window::openLesson(lab.ui, "energy-gain");
    int waited = 0;
    const lab::Pane& pane = lab.ui.bench.pane(0);
    for (int i = 0; i < 4000 && (waited == 0 || !pane.picture().texture || pane.progress() < 1); ++i) {
        lab.screen.frame(0.03);
        waited += pane.progress() < 1;
        ASSERT_EQ(pane.failure(), "");
    }
    EXPECT_GE(waited, 2);
    EXPECT_TRUE(pane.picture().texture);
    EXPECT_EQ(pane.picture().display.unit, "sum of form factors");
}

// Of a lesson about something else the band has the number itself, and not what it has to be.
TEST_F(LessonStateTest, OtherNumbersAreMeasuredForTheBand) {
    Lab lab(false);
    lab.screen.setPatience(std::chrono::hours(1));
    lab.screen.fit({640, 400}, 1);
    window::openLesson(lab.ui, "cube-seams"); // the spread of levels in a shadow that should be even
    const auto found = [&](std::size_t state) {
        for (int i = 0; i < 200 && lab.ui.lesson.measured[state].empty(); ++i)
            lab.screen.frame(0.03);
        return lab.ui.lesson.measured[state];
    };
    const std::string artefact = found(0);
    ASSERT_FALSE(artefact.empty());
    EXPECT_GE(std::stod(artefact), 5) << "seams across the shadow";
    EXPECT_TRUE(lab.ui.lesson.measured[1].empty());
    window::stepLesson(lab.ui, 1);
    EXPECT_EQ(found(1), "0") << "even";
    const auto& lines = window::lessonPage(lab.ui).lines;
    EXPECT_TRUE(std::ranges::any_of(lines, [&](const window::StoryLine& line) {
        return line.text.ends_with(artefact + " → 0");
    }));
    EXPECT_TRUE(std::ranges::any_of(lines, [](const window::StoryLine& line) {
        return line.text.find("Seams of the cube map: ") != std::string::npos;
    }));
}

TEST_F(LessonStateTest, AQuestionDoesNotShowItsAnswer) {
    Lab lab;
    window::openLesson(lab.ui, "stencil-overflow");
    ASSERT_TRUE(lab.ui.lesson.asksChoice());
    EXPECT_EQ(lab.ui.bench.document().panes, course::documentOf(lab.ui.lesson.now->states[1]).panes);
    window::stepLesson(lab.ui, 1);
    EXPECT_EQ(lab.ui.bench.document().panes, course::documentOf(lab.ui.lesson.now->states[0]).panes);
}

TEST_F(LessonStateTest, NothingOfAShadowIsSeenBeforeItIsPredicted) {
    Lab lab;
    window::openLesson(lab.ui, "extrusion-too-short");
    ASSERT_TRUE(lab.ui.lesson.paints());
    EXPECT_EQ(lab.ui.bench.document().panes[0].technique, "unshadowed");
    lab.ui.lesson.painted.paint({0.43, 0.62}, 0.05, true); // amid the shadow
    window::stepLesson(lab.ui, 1);
    EXPECT_EQ(lab.ui.lesson.step, LessonStep::reveal);
    EXPECT_EQ(lab.ui.bench.document().panes[0].technique, "unshadowed");
    ASSERT_TRUE(lab.ui.lesson.score);
    EXPECT_EQ(lab.ui.lesson.score->paintedRight(), 1);
    EXPECT_GT(lab.ui.lesson.score->right, 40); // a disc of radius 4.5 cells has 64
    EXPECT_LT(lab.ui.lesson.score->shadowFound(), 0.5);
}

TEST_F(LessonStateTest, ALessonThatCannotBeLoadedLeavesAllAsItWas) {
    Lab lab;
    const lab::Document before = lab.ui.bench.document();
    window::openLesson(lab.ui, "no-such-lesson");
    EXPECT_FALSE(lab.ui.lesson.isOn());
    EXPECT_EQ(lab.ui.bench.document(), before);
    ASSERT_EQ(lab.ui.messages.size(), 1u);
    EXPECT_TRUE(lab.ui.messages[0].fault);
}

} // namespace
} // namespace shadowlab
