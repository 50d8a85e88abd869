// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_view.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

#include "app/picture/outside/outside_shapes.h"
#include "app/picture/outside/pixel_shapes.h"
#include "app/picture/outside/thing_places.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/scene/query/outside_camera.h"

namespace shadowlab::picture {

namespace {

constexpr float kGroundShare = 0.7f; ///< of the picture's light: bright floors leave room for lines that are brighter

// Type of the labels, as legends have it: as shares of the figure's height, the larger one if no label is lost by it.
constexpr std::array kTypeShares = {kOutsideTypeShare, 1.0 / 45};
constexpr double kSmallestType = 10; ///< pixels; below, letters dissolve
constexpr double kTitleRoom = 1.9;   ///< em, at the top: there a figure has its title

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

void scissorTo(const View& view) {
    const Region& region = view.region;
    if (region.size.x <= 0 || region.size.y <= 0) return;
    glEnable(GL_SCISSOR_TEST); // GL counts rows from below
    glScissor(region.corner.x, view.size.y - region.corner.y - region.size.y, region.size.x, region.size.y);
}

} // namespace

std::optional<Stage> OutsideView::render(Session& session, Slot& slot, const View& eye, const View& outside, int light,
                                         const OutsideLook& look, Deadline deadline) {
    {
        const BorrowedTarget borrowed(slot, target_);
        FrameRequest request;
        request.deadline = deadline;
        const RenderedFrame ofTechnique = session.render(slot, outside, request);
        isWhole_ = ofTechnique.converged;
        drawnShare_ = ofTechnique.drawn;
        if (ofTechnique.result.passes.empty()) return std::nullopt;
    }
    if (!updateShapes(session, slot, eye, light, look.choice, deadline)) return std::nullopt;
    const std::vector<SceneShape> lights = lightShapes(*session.snapshot(), things_, light, outside.camera);
    const std::vector<SceneShape> ofPixel = pixelShapes(probe_, outside.camera);

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
    std::vector<const SceneShape*> inScene; // signs of lights are drawn last: they are small
    for (const std::vector<SceneShape>* some : {&std::as_const(ofTechnique_), &std::as_const(ofEye_), &lights})
        for (const SceneShape& shape : *some)
            inScene.push_back(&shape);
    painter_.draw(inScene, outside.camera, outside.size);
    std::vector<const SceneShape*> onTop; // the pixel's rays go through glass, and into corners
    for (const SceneShape& shape : ofPixel)
        onTop.push_back(&shape);
    painter_.draw(onTop, outside.camera, outside.size, true);
    stage.display.key = label(eye, outside, lights, ofPixel, look);
    gl::check("outside");
    return stage;
}

/// False when the rays by which a caster is chosen could not be sent by the deadline.
bool OutsideView::updateShapes(Session& session, Slot& slot, const View& eye, int light, const OutsideChoice& choice,
                               Deadline deadline) {
    const scene::Snapshot& snapshot = session.snapshot();
    ShapesOf wanted{slot.info,  slot.technique.get(), {},    snapshot, eye.camera, eye.size,
                    eye.picked, eye.partner,          light, choice};
    for (const params::Param& param : slot.params)
        wanted.values.push_back(param.get());
    if (wanted == madeFor_) return true;
    std::vector<SceneShape> published;
    if (light != kNoLight) published = slot.technique->shapes(snapshot, eye, light);
    Probe probe = eye.picked ? slot.technique->probe(snapshot, eye, *eye.picked, light) : Probe{};
    const bool isChosen = choice.caster && hasShapesOf(published, *choice.caster);
    std::optional<std::size_t> caster = isChosen ? choice.caster : casterAbove(probe);
    const bool isOfObjects = std::ranges::any_of(published, [](const SceneShape& shape) { return shape.object.has_value(); });
    if (isOfObjects && !caster && !choice.allVolumes) {
        if (session.prepareTruth(deadline) < 1) return false;
        caster = mostSeenCaster(session.tracer(), eye, light, published);
    }
    things_ = scene::thingsBounds(*snapshot);
    ofTechnique_ = chosenShapes(published, choice, caster);
    ofEye_ = eyeShapes(*snapshot, eye);
    probe_ = std::move(probe);
    madeFor_ = std::move(wanted);
    return true;
}

/// Labels the things, the most important first: the eye and the light, then what goes between them. Returns the key of the
/// colours of those that are seen and found no room.
std::vector<KeyEntry> OutsideView::label(const View& eye, const View& outside, std::span<const SceneShape> lights,
                                         std::span<const SceneShape> ofPixel, const OutsideLook& look) {
    std::vector<const SceneShape*> order;
    const auto addFromLast = [&](std::span<const SceneShape> shapes) {
        for (const SceneShape& shape : shapes | std::views::reverse)
            order.push_back(&shape);
    };
    addFromLast(lights); // the chosen one is the last
    addFromLast(ofPixel);
    addFromLast(ofTechnique_);
    addFromLast(ofEye_);
    std::ranges::stable_partition(
        order, [](const SceneShape* shape) { return shape->colorLinear != look::kOtherLight; });

    std::vector<NamedPoint> points{{"eye", look::kEye, eye.camera.positionWorld}};
    const std::vector<NamedPoint> names = pixelNames(probe_, outside.camera); // in no key: each names one line alone
    points.insert(points.end(), names.begin(), names.end());
    const int height = look.typeHeight > 0 ? look.typeHeight : outside.size.y;
    std::vector<KeyEntry> missing;
    labels_.clear();
    double em = 0;
    for (const double share : kTypeShares) {
        const double size = std::max(kSmallestType / look.draft, share * height);
        const ThingPlaces things = thingPlaces(points, order, outside.camera, outside.size, size);
        std::vector<PlacedLabel> placed =
            placeLabels(things.wishes, things.cover, {outside.size, size, kTitleRoom * size},
                        [&](const std::string& text) { return labelPainter_.sizeOf(text, size); });
        if (em != 0 && placed.size() <= labels_.size()) continue;
        em = size;
        labels_ = std::move(placed);
        missing.clear();
        for (const LabelWish& wish : things.wishes)
            if (std::ranges::find(labels_, wish.text, &PlacedLabel::text) == labels_.end() &&
                std::ranges::find(names, wish.text, &NamedPoint::text) == names.end())
                missing.push_back({wish.colorLinear, wish.text});
    }
    labelPainter_.draw(labels_, em, painter_, outside.size);
    return missing;
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
