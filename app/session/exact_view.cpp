// SPDX-License-Identifier: MIT
#include "app/session/exact_view.h"

#include "techniques/foundation/scene/depth_fit.h"

namespace shadowlab::session {

namespace {

measure::Rasterised rasterise(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers, const View& view) {
    GLint subpixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    return {measure::tieRadius(subpixelBits), {}};
}

} // namespace

const measure::Truth& ExactView::truth(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers,
                                       const View& view, int light) {
    const Key key{snapshot, view.camera, view.size, light};
    if (!(madeFor_ == key)) {
        tracer_.advance(snapshot, Deadline::max());
        truth_ = measure::exactTruth(tracer_, view.camera, view.size, light, rasterise(snapshot, buffers, view));
        madeFor_ = key;
    }
    return truth_;
}

measure::Truth ExactView::truthAtCentres(const scene::Snapshot& snapshot, const View& view, int light) {
    tracer_.advance(snapshot, Deadline::max());
    return measure::truthAtCentres(tracer_, view.camera, view.size, light);
}

} // namespace shadowlab::session
