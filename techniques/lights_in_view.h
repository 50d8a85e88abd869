// A light that shines elsewhere need not be drawn: for all techniques that add one light after the other.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/query/view/light_reach.h"
#include "techniques/frame.h"

namespace shadowlab {

/// False when that light certainly lights nothing that is in view of the frame.
inline bool mayLight(const Frame& frame, int light) {
    const gl::EyeMatrices& eye = frame.eye();
    return scene::mayLight(frame.scene(), frame.scene().light(light), frame.buffers().bounds(),
                           frame.camera().positionWorld, eye.clipFromView * eye.viewFromWorld,
                           eye.part.value_or(scene::PicturePart{}));
}

} // namespace shadowlab
