// Lessons in the window: every step of every lesson, the questions, and what was there before.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>

#include "app/context/assets.h"
#include "app/window/screen.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using window::LessonStep;

class LessonDeskTest : public testing::GlTest {
protected:
    static scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }
    static lab::Document beginning() {
        return lab::newDocument(scene::loadScene("sphere-on-plane", loading()), "sphere-on-plane");
    }
    struct Lab {
        Lab() : desk(beginning()) {
            desk.lesson.all = course::builtInLessons(context::assetsRoot());
            desk.lesson.loading = loading();
        }
        void press(int key, bool shift = false) {
            desk.keys.push_back({key, false, shift, false, false});
            screen.frame(0.03);
        }
        window::Desk desk;
        window::Screen screen{desk, context::assetsRoot() / "fonts" / "DejaVuSans.ttf"};
    };
};

TEST_F(LessonDeskTest, TheCourseGoesThroughAllLessonsAndBackAndLeavesNothing) {
    Lab lab;
    window::Desk& desk = lab.desk;
    const lab::Document before = desk.bench.document();
    std::vector<std::pair<std::string, LessonStep>> way;
    std::set<std::string> names;
    for (std::size_t i = 0; names.size() < desk.lesson.all.size() || desk.lesson.step != LessonStep::mend; ++i) {
        ASSERT_LT(i, 200u);
        window::stepLesson(desk, 1);
        ASSERT_TRUE(desk.messages.empty()) << desk.messages.front().text;
        ASSERT_TRUE(desk.lesson.isOn());
        way.emplace_back(desk.lesson.now->text.name, desk.lesson.step);
        names.insert(way.back().first);
    }
    EXPECT_GE(way.size(), 2 * desk.lesson.all.size() + 4); // two steps each, and more where they ask
    for (auto step = way.rbegin() + 1; step != way.rend(); ++step) {
        window::stepLesson(desk, -1);
        EXPECT_EQ(desk.lesson.now->text.name, step->first);
        EXPECT_EQ(desk.lesson.step, step->second);
    }
    window::leaveLesson(desk);
    EXPECT_EQ(desk.bench.document(), before);
}

// What the class is to find out, no key may show; and no pixel is picked in a picture that nobody sees.
TEST_F(LessonDeskTest, WhileTheShadowIsPaintedNothingShowsIt) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const lab::Document before = lab.desk.bench.document();
    for (const course::LessonText& text : lab.desk.lesson.all) {
        window::openLesson(lab.desk, text.name);
        if (lab.desk.lesson.paints()) break;
    }
    ASSERT_TRUE(lab.desk.lesson.paints());
    lab.screen.frame(0.03);
    const lab::Document asked = lab.desk.bench.document();
    for (const int key : {GLFW_KEY_E, GLFW_KEY_U, GLFW_KEY_O, GLFW_KEY_X, GLFW_KEY_PAGE_DOWN, GLFW_KEY_V}) {
        lab.press(key);
        EXPECT_EQ(lab.desk.bench.document(), asked) << "key " << key;
    }
    ASSERT_EQ(lab.desk.messages.size(), 6u) << "each says why";
    EXPECT_FALSE(lab.desk.messages[0].fault);
    lab.press(GLFW_KEY_J);
    EXPECT_EQ(lab.desk.lesson.step, LessonStep::reveal);
    window::leaveLesson(lab.desk);
    EXPECT_EQ(lab.desk.bench.document(), before);
}

TEST_F(LessonDeskTest, KeysGoOnAnswerAndLeave) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const lab::Document before = lab.desk.bench.document();
    window::openLesson(lab.desk, "eye-in-shadow");
    ASSERT_TRUE(lab.desk.lesson.asksChoice());
    lab.press(GLFW_KEY_2);
    EXPECT_EQ(lab.desk.lesson.chosen, 1);
    EXPECT_EQ(lab.desk.bench.document().panes[0].technique, "shadow-volume-zpass"); // an answer, and no technique
    lab.press(GLFW_KEY_J);
    EXPECT_EQ(lab.desk.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_J);
    EXPECT_EQ(lab.desk.lesson.step, LessonStep::mend);
    EXPECT_EQ(lab.desk.bench.document().panes[0].values().at("eye-correction"), "true");
    lab.press(GLFW_KEY_J, true);
    EXPECT_EQ(lab.desk.lesson.step, LessonStep::artefact);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(lab.desk.lesson.isOn());
    EXPECT_EQ(lab.desk.bench.document(), before);
}

TEST_F(LessonDeskTest, AQuestionDoesNotShowItsAnswer) {
    Lab lab;
    window::openLesson(lab.desk, "stencil-overflow");
    ASSERT_TRUE(lab.desk.lesson.asksChoice());
    EXPECT_EQ(lab.desk.bench.document().panes, course::documentOf(lab.desk.lesson.now->states[1]).panes);
    window::stepLesson(lab.desk, 1);
    EXPECT_EQ(lab.desk.bench.document().panes, course::documentOf(lab.desk.lesson.now->states[0]).panes);
}

TEST_F(LessonDeskTest, NothingOfAShadowIsSeenBeforeItIsPredicted) {
    Lab lab;
    window::openLesson(lab.desk, "extrusion-too-short");
    ASSERT_TRUE(lab.desk.lesson.paints());
    EXPECT_EQ(lab.desk.bench.document().panes[0].technique, "unshadowed");
    lab.desk.lesson.painted.paint({0.43, 0.62}, 0.05, true); // amid the shadow
    window::stepLesson(lab.desk, 1);
    EXPECT_EQ(lab.desk.lesson.step, LessonStep::reveal);
    EXPECT_EQ(lab.desk.bench.document().panes[0].technique, "unshadowed");
    ASSERT_TRUE(lab.desk.lesson.score);
    EXPECT_EQ(lab.desk.lesson.score->paintedRight(), 1);
    EXPECT_GT(lab.desk.lesson.score->right, 40); // a disc of radius 4.5 cells has 64
    EXPECT_LT(lab.desk.lesson.score->shadowFound(), 0.5);
}

TEST_F(LessonDeskTest, ALessonThatCannotBeLoadedLeavesAllAsItWas) {
    Lab lab;
    const lab::Document before = lab.desk.bench.document();
    window::openLesson(lab.desk, "no-such-lesson");
    EXPECT_FALSE(lab.desk.lesson.isOn());
    EXPECT_EQ(lab.desk.bench.document(), before);
    ASSERT_EQ(lab.desk.messages.size(), 1u);
    EXPECT_TRUE(lab.desk.messages[0].fault);
}

} // namespace
} // namespace shadowlab
