// One scene before its truth: any number of techniques are drawn and judged by it.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "app/course/shown_state.h"
#include "app/picture/judged_slot.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"

namespace shadowlab::hard {

/// The result of one technique's frame.
struct JudgedFrame {
    image::Image picture;
    image::Image errorMap; ///< report::errorMap()
    picture::VisibilityImage visibility;
    judge::SlotErrors errors;
    int coreErrors = 0;
    double served = 1; ///< share of the pixels with a surface that the technique serves at all
    double ms = 0;     ///< prepare and render, to the end of the GL work
};

class JudgedScene {
public:
    /// Of the state, the scene, the camera and the light. Needs a current GL context for its whole life.
    JudgedScene(const course::ShownState& state, ivec2 size);

    [[nodiscard]] bool shows(const course::ShownState& state) const {
        return state.scene == session_.snapshot() && state.camera == view_.camera && state.light == light_;
    }
    enum class Timing {
        first, ///< the frame that is judged: shaders are compiled, and all is prepared from nothing
        again, ///< one more frame, in which the light has gone on by one degree and nothing that follows from it can be kept
    };
    /// Throws Error (badInput) for a technique that does not say what it makes of one light.
    JudgedFrame draw(const lab::PaneState& technique, Timing timing = Timing::first);

private:
    double msWithLightMoved(picture::Slot& slot);

    picture::Session session_;
    picture::PictureEncoder encoder_;
    View view_;
    int light_;
};

} // namespace shadowlab::hard
