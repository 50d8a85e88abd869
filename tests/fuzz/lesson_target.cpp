// Lessons: both states completed, all that is expected of them, and the motion of camera and lights.
// SPDX-License-Identifier: MIT
#include "app/course/lessons/lesson.h"
#include "tests/fuzz/target.h"

namespace shadowlab::fuzz {

Outcome feed(std::string_view bytes) {
    const scene::LoadOptions options{.assetsRoot = kOwnAssets, .allowed = {}, .limits = {}};
    const std::filesystem::path file = options.assetsRoot / "lessons" / "made-up.json";
    return outcomeOf([&] {
        const course::Lesson lesson = course::parseLesson(std::string(bytes), file, options);
        require(lesson.size.x >= 16 && lesson.size.y >= 16, "pictures have a size");
        for (const course::ShownState& state : lesson.states) {
            require(state.scene != nullptr && !state.slots.empty(), "a state shows something");
            require(scene::hasView(state.camera), "a state is seen from somewhere");
        }
        for (const course::Expectation& expected : lesson.expectations) {
            require(expected.slot >= 0 && expected.slot < static_cast<int>(lesson.states[0].slots.size()),
                    "an expectation is of a technique that is shown");
            require(!expected.look || *expected.look < static_cast<int>(lesson.look.size()), "boxes that there are");
        }
        for (const course::LookBox& box : lesson.look)
            static_cast<void>(course::inPictureOf(1, box));
        if (lesson.question && lesson.question->kind == course::Question::Kind::choice)
            require(lesson.question->right >= 0 &&
                        lesson.question->right < static_cast<int>(lesson.question->choices.size()),
                    "the right answer is one of the answers");
    });
}

} // namespace shadowlab::fuzz
