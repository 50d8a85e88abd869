// SPDX-License-Identifier: MIT
#include "app/window/picture_view.h"

#include <algorithm>
#include <cmath>

#include "app/window/widget_renderer.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::window {

namespace {

bool holds(const PlaceBox& box, ImVec2 at) {
    return at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y;
}

ImVec2 placeAt(const PlaceBox& picture, const dvec2& share) {
    return {picture.low.x + static_cast<float>(share.x) * picture.size().x,
            picture.low.y + static_cast<float>(share.y) * picture.size().y};
}

/// In a picture taken from the light: the stage's maps are in the probe of the pane that shows them.
std::optional<dvec2> shareInLightsPicture(const WindowState& ui, const lab::Pane& pane) {
    const lab::PickedPixel& known = ui.bench.pickedPixel();
    const auto* const map = known.probe.find<MapProbe>();
    const lab::PaneRequest& drawn = pane.drawnFor();
    if (!map || pane.showsAnother() || known.askedFor.state != drawn.state) return {};
    const StageKey& stage = pane.picture().stage;
    if (stage.light != drawn.light) return {}; // the probe is of the current light
    for (const MapProbe::InPicture& one : map->inPictures)
        if (one.stage == stage.id) return one.share;
    return {};
}

} // namespace

PlaceBox fittedPicture(ImVec2 size, const Area& area) {
    const float scale = std::min(static_cast<float>(area.size.x) / size.x, static_cast<float>(area.size.y) / size.y);
    const ImVec2 shown(size.x * scale, size.y * scale);
    const ImVec2 corner(
        std::round(static_cast<float>(area.corner.x) + (static_cast<float>(area.size.x) - shown.x) / 2),
        std::round(static_cast<float>(area.corner.y) + (static_cast<float>(area.size.y) - shown.y) / 2));
    return {corner, {corner.x + shown.x, corner.y + shown.y}};
}

PictureView::PictureView(const scene::Camera& camera, const PlaceBox& picture)
    : picture_(picture), projection_(camera, {picture.size().x, picture.size().y}) {}

std::optional<ImVec2> PictureView::place(const dvec3& positionWorld) const {
    const auto pixel = projection_.pixel(positionWorld);
    if (!pixel) return {};
    return ImVec2(picture_.low.x + static_cast<float>(pixel->x), picture_.low.y + static_cast<float>(pixel->y));
}

std::optional<PictureView> pictureView(const WindowState& ui, const ShownPane& shown) {
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    const lab::Document& document = ui.bench.document();
    if (pane.showsTheEyesView()) {
        const ImVec2 low = shown.pictureCorner, size = shown.pictureSize;
        return PictureView{document.camera, {low, {low.x + size.x, low.y + size.y}}};
    }
    const gl::Texture2D& texture = pane.picture().texture;
    if (!texture || pane.showsAnother() || !pane.drawnFor().state.stage.isOutside()) return {};
    const ivec2 size = texture.size();
    const double aspect = static_cast<double>(size.x) / size.y;
    return PictureView{scene::widenedFor(pane.drawnFor().outsideCamera, aspect), fittedPicture(imVec(size), shown.area)};
}

std::optional<ImVec2> pickedPlace(const WindowState& ui, const ShownPane& shown) {
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    const lab::Document& document = ui.bench.document();
    if (!document.picked) return {};
    if (pane.showsTheEyesView()) {
        const ImVec2 at = shown.at(*document.picked);
        const ImVec2 low = shown.pictureCorner, size = shown.pictureSize;
        return holds({low, {low.x + size.x, low.y + size.y}}, at) ? std::optional(at) : std::nullopt;
    }
    if (const auto view = pictureView(ui, shown)) {
        const std::vector<Probe::Segment>& rays = ui.bench.pickedPixel().probe.geometry;
        const auto at = rays.empty() ? std::nullopt : view->place(rays.front().toWorld); // where the eye's ray ends
        return at && holds(view->picture(), *at) ? at : std::nullopt;
    }
    const gl::Texture2D& texture = pane.picture().texture;
    const std::optional<dvec2> share = texture ? shareInLightsPicture(ui, pane) : std::nullopt;
    if (!share) return {};
    return placeAt(fittedPicture(imVec(texture.size()), shown.area), *share);
}

} // namespace shadowlab::window
