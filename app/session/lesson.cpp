// SPDX-License-Identifier: MIT
#include "app/session/lesson.h"

#include "techniques/foundation/scene/message_text.h"

namespace shadowlab::session {

std::string Bound::text() const {
    std::string text;
    if (atLeast) text = "at least " + scene::numberText(*atLeast);
    if (atMost) text += (text.empty() ? "" : ", ") + ("at most " + scene::numberText(*atMost));
    return text;
}

LookBox inPictureOf(double aspect, LookBox box) {
    const double narrower = kLessonAspect / aspect;
    box.corner.x = 0.5 + (box.corner.x - 0.5) * narrower;
    box.size.x *= narrower;
    return box;
}

Document documentOf(const LessonState& state) {
    Document document = newDocument(state.scene, state.sceneName);
    document.camera = state.camera;
    document.outsideCamera = outsideCameraOf(*state.scene, state.camera);
    document.layout = state.layout;
    document.light = state.light;
    for (std::size_t i = 0; i < state.slots.size(); ++i)
        document.panes[i] = state.slots[i];
    return document;
}

std::vector<Slot> slotsOf(const std::vector<PaneState>& states) {
    std::vector<Slot> slots;
    for (const PaneState& state : states) {
        slots.push_back(Session::makeSlot(state.technique));
        for (const auto& [id, value] : state.values())
            params::setFromText(params::find(slots.back().params, id, state.technique), value, state.technique);
    }
    return slots;
}

} // namespace shadowlab::session
