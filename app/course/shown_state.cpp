// SPDX-License-Identifier: MIT
#include "app/course/shown_state.h"

namespace shadowlab::course {

lab::Document documentOf(const ShownState& state) {
    lab::Document document = lab::newDocument(state.scene, state.sceneName);
    document.camera = state.camera;
    document.outsideCamera = lab::outsideCameraOf(*state.scene, state.camera);
    document.layout = state.layout;
    document.split = state.split;
    document.light = state.light;
    for (std::size_t i = 0; i < state.slots.size(); ++i)
        document.panes[i] = state.slots[i];
    return document;
}

std::vector<picture::Slot> slotsOf(const std::vector<lab::PaneState>& states) {
    std::vector<picture::Slot> slots;
    for (const lab::PaneState& state : states) {
        slots.push_back(picture::Session::makeSlot(state.technique));
        for (const auto& [id, value] : state.values())
            params::setFromText(params::find(slots.back().params, id, state.technique), value, state.technique);
    }
    return slots;
}

} // namespace shadowlab::course
