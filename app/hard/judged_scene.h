// One scene before its truth: any number of techniques are drawn and judged by it.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "app/measure/slot_errors.h"
#include "app/session/picture.h"
#include "app/session/session.h"
#include "app/session/shown_state.h"

namespace shadowlab::hard {

/// What came of one technique's frame.
struct JudgedFrame {
    image::Image picture;
    session::VisibilityImage visibility;
    measure::SlotErrors errors;
    int coreErrors = 0;
    double ms = 0; ///< prepare and render, to the end of the GL work
};

class JudgedScene {
public:
    /// Of the state, the scene, the camera and the light. Needs a current GL context for its whole life.
    JudgedScene(const session::ShownState& state, ivec2 size);

    [[nodiscard]] bool shows(const session::ShownState& state) const {
        return state.scene == session_.snapshot() && state.camera == view_.camera && state.light == light_;
    }
    /// Throws Error (badInput) for a technique that does not say what it makes of one light.
    JudgedFrame draw(const session::PaneState& technique);

private:
    session::Session session_;
    session::PictureEncoder encoder_;
    View view_;
    int light_;
};

} // namespace shadowlab::hard
