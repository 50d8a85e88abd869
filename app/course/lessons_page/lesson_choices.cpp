// SPDX-License-Identifier: MIT
#include "app/course/lessons_page/lesson_choices.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "techniques/foundation/base/fnv.h"

namespace shadowlab::course {

namespace {

constexpr std::size_t kFewestWrong = 2, kMostWrong = 3; ///< answers: four are read at a glance

/// "Shadow map" of "Shadow map: bias".
std::string_view kindOf(const LessonText& lesson) { return std::string_view(lesson.chapter).substr(0, lesson.chapter.find(':')); }

/// The same on every machine, as std::hash need not be. The shift brings down the high bits, which depend on all letters; the lowest
/// alone would be a sum of them.
std::uint64_t digest(std::string_view text) { return fnv(text.data(), text.size()) >> 32; }

bool areAlike(const LessonText& a, const LessonText& b) {
    return a.title == b.title || std::ranges::find(a.alike, b.name) != a.alike.end() ||
           std::ranges::find(b.alike, a.name) != b.alike.end();
}

/// "A ball hangs high above the floor." of "A ball hangs high above the floor. Where is its shadow? Paint it.": what is told before something
/// is asked that a page cannot take, a shadow to be painted.
std::string toldBefore(const std::string& question) {
    const std::size_t asks = question.find('?'), end = question.rfind(". ", asks);
    return asks == std::string::npos || end == std::string::npos ? "" : question.substr(0, end + 2);
}

} // namespace

LessonChoices choicesOf(const Lesson& lesson, const std::vector<LessonText>& course) {
    if (lesson.question && lesson.question->kind == Question::Kind::choice)
        return {lesson.question->text, lesson.question->choices, static_cast<std::size_t>(lesson.question->right),
                lesson.question->picture};
    const LessonText& own = lesson.text;
    std::vector<const LessonText*> others;
    for (const LessonText& other : course)
        if (other.name != own.name && !areAlike(own, other)) others.push_back(&other);
    const auto rank = [&own](const LessonText* other) {
        return std::tuple(kindOf(*other) != kindOf(own), other->chapter != own.chapter, digest(own.name + " " + other->name));
    };
    std::ranges::sort(others, {}, rank);
    LessonChoices asked{(lesson.question ? toldBefore(lesson.question->text) : "") + "What has gone wrong here?", {}, 0, 0};
    for (const LessonText* other : others) {
        const std::size_t most = kindOf(*other) == kindOf(own) ? kMostWrong : kFewestWrong;
        if (asked.choices.size() < most) asked.choices.push_back(other->title);
    }
    asked.right = digest(own.name) % (asked.choices.size() + 1);
    asked.choices.insert(asked.choices.begin() + static_cast<std::ptrdiff_t>(asked.right), own.title);
    return asked;
}

} // namespace shadowlab::course
