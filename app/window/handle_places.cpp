// SPDX-License-Identifier: MIT
#include "app/window/handle_places.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::window {

namespace {

constexpr float kArrowEm = 4.5f; ///< length of an axis arrow, however far away the thing is
constexpr float kEdgeEm = 1.8f;  ///< how far within the picture a light outside it has its mark

} // namespace

std::optional<ImVec2> SeenPane::place(const dvec3& positionWorld) const {
    const auto pixel = lab::pixelOf(camera, size, positionWorld);
    if (!pixel) return {};
    return ImVec2(pane.pictureCorner.x + static_cast<float>(pixel->x), pane.pictureCorner.y + static_cast<float>(pixel->y));
}

ImVec2 SeenPane::iconPlace(ImVec2 place, const Theme& theme) const {
    const float margin = kIconEm * theme.em;
    const auto inward = [margin](float at, int corner, int size) {
        const auto low = static_cast<float>(corner), high = static_cast<float>(corner + size);
        // What belongs to the neighbouring part of the picture stays there.
        if (at < low || at > high || high - low < 2 * margin) return at;
        return std::clamp(at, low + margin, high - margin);
    };
    return {inward(place.x, pane.area.corner.x, pane.area.size.x), inward(place.y, pane.area.corner.y, pane.area.size.y)};
}

std::optional<lab::EdgeMark> SeenPane::edgeMark(const lab::Handle& handle, bool selected, const Theme& theme) const {
    if (handle.what.kind != lab::Selection::Kind::light && !selected) return {};
    auto mark = lab::edgeMarkOf(camera, size, kEdgeEm * theme.em, handle.positionWorld);
    if (!mark) return {};
    mark->pixel += dvec2(pane.pictureCorner.x, pane.pictureCorner.y);
    const ImVec2 clear = iconPlace({static_cast<float>(mark->pixel.x), static_cast<float>(mark->pixel.y)}, theme);
    mark->pixel = {clear.x, clear.y};
    return mark;
}

std::optional<ImVec2> SeenPane::arrowEnd(const lab::Handle& handle, int axis, const Theme& theme) const {
    const auto from = place(handle.positionWorld);
    const double metres = 1e-3 * glm::length(handle.positionWorld - camera.positionWorld);
    dvec3 directionWorld(0.0);
    directionWorld[axis] = 1;
    const auto toward = place(handle.positionWorld + metres * directionWorld);
    if (!from || !toward) return {};
    const double seenLength = std::hypot(toward->x - from->x, toward->y - from->y);
    // What a metre on the screen would be if it were not foreshortened; less than a fifth of it cannot be aimed with.
    const double full = 1e-3 * size.y / (2 * std::tan(glm::radians(camera.fovYDegrees) / 2));
    if (seenLength < 0.2 * full) return {};
    const auto scale = static_cast<float>(kArrowEm * theme.em / seenLength);
    return ImVec2(from->x + (toward->x - from->x) * scale, from->y + (toward->y - from->y) * scale);
}

SeenPane seenIn(const ShownPane& pane, const scene::Camera& camera) {
    return {pane, camera, {static_cast<int>(pane.pictureSize.x), static_cast<int>(pane.pictureSize.y)}};
}

bool showsHandles(const WindowState& ui, const ShownPane& pane) { return ui.bench.pane(pane.pane).showsTheEyesView(); }

} // namespace shadowlab::window
