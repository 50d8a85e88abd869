// SPDX-License-Identifier: MIT
#include "app/window/free_places.h"

#include <algorithm>

#include "app/window/handle_places.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr float kFillsPane = 0.3f; ///< of its area: there is no place beside what is larger

/// Pixels of the window that lie in both.
float overlap(const PlaceBox& a, const PlaceBox& b) {
    return std::max(0.0f, std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x)) *
           std::max(0.0f, std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y));
}

/// Around the eight corners of an object's box in the picture; nothing where one of them lies behind the eye.
std::optional<PlaceBox> seenBox(const SeenPane& seen, const scene::Bounds& bounds) {
    PlaceBox box{{FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX}};
    for (int i = 0; i < 8; ++i) {
        const auto at = seen.place(bounds.corner(i));
        if (!at) return {};
        box = {{std::min(box.low.x, at->x), std::min(box.low.y, at->y)}, {std::max(box.high.x, at->x), std::max(box.high.y, at->y)}};
    }
    return box;
}

} // namespace

float FreePlaces::cost(const PlaceBox& box) const {
    float sum = 0;
    for (const Taken& taken : taken_)
        sum += taken.weight * overlap(taken.box, box);
    return sum;
}

PlaceBox FreePlaces::within(ImVec2 corner, ImVec2 size) const {
    const ImVec2 low = imVec(pane_.area.corner), high = imVec(pane_.area.corner + pane_.area.size);
    const ImVec2 at(std::clamp(corner.x, low.x, std::max(low.x, high.x - size.x)),
                    std::clamp(corner.y, low.y, std::max(low.y, high.y - size.y)));
    return {at, {at.x + size.x, at.y + size.y}};
}

FreePlaces placesBesideObjects(WindowState& ui, const ShownPane& pane) {
    FreePlaces places(pane);
    if (!showsHandles(ui, pane)) return places; // seen from elsewhere they are in other places
    const SeenPane seen = seenIn(pane, ui.bench.document().camera);
    const float most = kFillsPane * static_cast<float>(pane.area.size.x) * static_cast<float>(pane.area.size.y);
    const ImVec2 low = imVec(pane.area.corner), high = imVec(pane.area.corner + pane.area.size);
    for (const scene::Bounds& bounds : ui.bench.bounds()) {
        const auto box = bounds.isEmpty() ? std::nullopt : seenBox(seen, bounds);
        if (box && overlap(*box, {low, high}) < most) places.take(*box, FreePlaces::kObject);
    }
    return places;
}

} // namespace shadowlab::window
