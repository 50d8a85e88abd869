// What a lesson's remedy changes, in words.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/course/lessons/lesson.h"
#include "app/course/lessons/lesson_quantities.h"
#include "techniques/foundation/params/in_words.h"

namespace shadowlab::course {

namespace {

/// The value of a setting, also where it is the technique's own.
std::string valueOf(const lab::PaneState& state, const params::Param& param) {
    const auto found = state.values().find(param.id);
    return found != state.values().end() ? found->second : params::initialText(param);
}

void addChangesOfSlot(std::vector<LessonChange>& changes, const lab::PaneState& before, const lab::PaneState& after) {
    if (before.technique != after.technique) {
        changes.push_back({"technique", std::string(findTechnique(before.technique).title),
                           std::string(findTechnique(after.technique).title)});
        return;
    }
    const picture::Slot slot = picture::Session::makeSlot(before.technique);
    for (const params::Param& param : slot.params) {
        const std::string from = valueOf(before, param), to = valueOf(after, param);
        if (from != to) changes.push_back({params::labelOf(param), params::inWords(from, param), params::inWords(to, param)});
    }
}

} // namespace

std::vector<LessonChange> changesOf(const Lesson& lesson) {
    const ShownState &before = lesson.states[0], &after = lesson.states[1];
    std::vector<LessonChange> changes;
    for (std::size_t i = 0; i < std::min(before.slots.size(), after.slots.size()); ++i)
        addChangesOfSlot(changes, before.slots[i], after.slots[i]);
    if (before.sceneName != after.sceneName)
        changes.push_back({"scene", before.sceneName, after.sceneName});
    else if (before.scene->lights != after.scene->lights)
        changes.push_back({"lights", "as they were", "changed"});
    if (before.camera != after.camera) changes.push_back({"camera", "where it was", "moved"});
    return changes;
}

int judgedSlot(const Lesson& lesson) {
    for (const Expectation& expected : lesson.expectations)
        if (quantityOf(expected).of == LessonQuantity::Of::visibility) return expected.slot;
    return 0;
}

std::vector<std::string> chaptersOf(const std::vector<LessonText>& lessons) {
    std::vector<std::string> chapters;
    for (const LessonText& lesson : lessons)
        if (std::ranges::find(chapters, lesson.chapter) == chapters.end()) chapters.push_back(lesson.chapter);
    return chapters;
}

} // namespace shadowlab::course
