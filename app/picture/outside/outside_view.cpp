// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_view.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

#include "app/picture/outside/outside_shapes.h"
#include "app/picture/outside/pixel_shapes.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::picture {

namespace {

constexpr float kGroundShare = 0.7f; ///< of the picture's light: bright floors leave room for lines that are brighter

/// Lends a slot another target for as long as it lives.
class BorrowedTarget {
public:
    BorrowedTarget(Slot& slot, gl::Target& target) : slot_(slot), target_(target) { std::swap(slot_.target, target_); }
    ~BorrowedTarget() { std::swap(slot_.target, target_); }
    BorrowedTarget(const BorrowedTarget&) = delete;
    BorrowedTarget& operator=(const BorrowedTarget&) = delete;

private:
    Slot& slot_;
    gl::Target& target_;
};

/// One entry for each label. What is drawn last is explained first: the light and the eye, then what goes between them.
std::vector<KeyEntry> keyOfShapes(std::span<const SceneShape> shapes) {
    std::vector<KeyEntry> key;
    for (const SceneShape& shape : shapes | std::views::reverse)
        if (!shape.pointsWorld.empty() && std::ranges::find(key, shape.label, &KeyEntry::label) == key.end())
            key.push_back({shape.colorLinear, shape.label});
    return key;
}

void scissorTo(const View& view) {
    const Region& region = view.region;
    if (region.size.x <= 0 || region.size.y <= 0) return;
    glEnable(GL_SCISSOR_TEST); // GL counts rows from below
    glScissor(region.corner.x, view.size.y - region.corner.y - region.size.y, region.size.x, region.size.y);
}

} // namespace

std::optional<Stage> OutsideView::render(Session& session, Slot& slot, const View& eye, const View& outside, int light,
                                         Deadline deadline) {
    {
        const BorrowedTarget borrowed(slot, target_);
        FrameRequest request;
        request.deadline = deadline;
        if (session.render(slot, outside, request).result.passes.empty()) return std::nullopt;
    }
    updateShapes(session, slot, eye, light);
    std::vector<SceneShape> all = lightShapes(*session.snapshot(), things_, light, outside.camera);
    all.insert(all.begin(), shapes_.begin(), shapes_.end()); // signs of lights are drawn last: they are small

    Stage stage{{"outside", light}, gl::Texture2D(GL_RGBA16F, outside.size, "outside"), {}};
    const gl::Texture2D depth(GL_DEPTH24_STENCIL8, outside.size, "outside");
    const gl::Framebuffer framebuffer(&stage.texture, &depth, "outside");
    const gl::DebugGroup group("outside");
    gl::setBaselineState();
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    scissorTo(outside);
    drawGround(target_.color, session.snapshot()->exposure);
    drawDepth(session, outside);
    painter_.draw(all, outside.camera, outside.size);
    gl::check("outside");
    if (eye.picked) { // its rays go through glass, and into corners
        std::vector<SceneShape> ofPixel = pixelShapes(probe_, outside.camera);
        painter_.draw(ofPixel, outside.camera, outside.size, true);
        std::ranges::move(ofPixel, std::back_inserter(all));
    }
    stage.display.key = keyOfShapes(all);
    return stage;
}

void OutsideView::updateShapes(const Session& session, Slot& slot, const View& eye, int light) {
    ShapesOf wanted{slot.info,  slot.technique.get(), {},   session.snapshot(), eye.camera, eye.size,
                    eye.picked, eye.partner,          light};
    for (const params::Param& param : slot.params)
        wanted.values.push_back(param.get());
    if (wanted == madeFor_) return;
    things_ = scene::thingsBounds(*session.snapshot());
    shapes_.clear();
    if (light != kNoLight) shapes_ = slot.technique->shapes(session.snapshot(), eye, light);
    probe_ = eye.picked ? slot.technique->probe(session.snapshot(), eye, *eye.picked, light) : Probe{};
    shapes_.push_back(eyeShape(*session.snapshot(), eye));
    madeFor_ = std::move(wanted);
}

void OutsideView::drawGround(const gl::Texture2D& radiance, float exposure) const {
    glDisable(GL_DEPTH_TEST);
    ground_.use();
    ground_.set("source", 0);
    ground_.set("exposure", exposure);
    ground_.set("share", kGroundShare);
    radiance.bind(0);
    gl::drawFullscreenTriangle();
    glEnable(GL_DEPTH_TEST);
}

void OutsideView::drawDepth(const Session& session, const View& outside) const {
    // With the camera as it is, not with a nearer plane that fits the objects: lines may lie nearer than all of them.
    // Surfaces go back by what their depth changes within one pixel, and four steps of the buffer for rounding: else they
    // would half bury the lines that lie on them.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 4);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    depthOnly_.use();
    gl::drawSurfacesWithHoles(depthOnly_, *session.snapshot(), session.buffers(),
                              gl::eyeMatrices(outside.camera, outside.size));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

} // namespace shadowlab::picture
