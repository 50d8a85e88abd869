// SPDX-License-Identifier: MIT
#include "app/picture/exact_view.h"

#include "techniques/foundation/scene/query/view/depth_fit.h"

namespace shadowlab::picture {

namespace {

double tieRadiusPx() {
    GLint subpixelBits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    return judge::tieRadius(subpixelBits);
}

} // namespace

const judge::Truth& ExactView::truth(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers,
                                       const View& view, const LightTruth& light) {
    const Key key{snapshot, view.camera, view.size, light};
    Made& made = made_[light.of == judge::TruthOf::area ? 1 : 0];
    if (!(made.key == key)) {
        tracer_.advance(snapshot, Deadline::max());
        made.truth = judge::exactTruth(tracer_, view.camera, view.size, light.light,
                                         rasterise(snapshot, buffers, view), {}, light.of);
        made.key = key;
    }
    return made.truth;
}

judge::Rasterised ExactView::rasterise(const scene::Snapshot& snapshot, const gl::SceneBuffers& buffers,
                                         const View& view) {
    // With the camera that techniques draw with (Frame::camera).
    const scene::Camera camera =
        scene::withTightNear(view.camera, *snapshot, buffers.bounds(), static_cast<double>(view.size.x) / view.size.y);
    ids_.draw(*snapshot, buffers, gl::eyeMatrices(camera, view.size), view.size);
    return {tieRadiusPx(), ids_.read()};
}

std::vector<std::uint8_t> ExactView::tiesAmong(const scene::Snapshot& snapshot, const View& view,
                                               const LightTruth& light, const std::vector<ivec2>& pixels) {
    tracer_.advance(snapshot, Deadline::max());
    return judge::tiesAmong(tracer_, view.camera, view.size, light.light, tieRadiusPx(), pixels, light.of);
}

const std::vector<judge::OutlineSegment>& ExactView::outline(const scene::Snapshot& snapshot, const View& view,
                                                               int light) {
    const Key key{snapshot, view.camera, view.size, light};
    if (!(outlinedFor_ == key)) {
        const judge::Truth centres = truthAtCentres(snapshot, view, light);
        outline_ = judge::shadowOutline(tracer_, view.camera, centres, light);
        outlinedFor_ = key;
    }
    return outline_;
}

judge::Truth ExactView::truthAtCentres(const scene::Snapshot& snapshot, const View& view, const LightTruth& light) {
    tracer_.advance(snapshot, Deadline::max());
    return judge::truthAtCentres(tracer_, view.camera, view.size, light.light, {}, light.of);
}

} // namespace shadowlab::picture
