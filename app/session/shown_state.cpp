// SPDX-License-Identifier: MIT
#include "app/session/shown_state.h"

namespace shadowlab::session {

Document documentOf(const ShownState& state) {
    Document document = newDocument(state.scene, state.sceneName);
    document.camera = state.camera;
    document.outsideCamera = outsideCameraOf(*state.scene, state.camera);
    document.layout = state.layout;
    document.split = state.split;
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
