// SPDX-License-Identifier: MIT
#include "app/window/free_places.h"

#include <algorithm>
#include <cmath>

#include "app/window/widget_renderer.h"

namespace shadowlab::window {

ImVec2 PlaceBox::nearest(ImVec2 to) const { return {std::clamp(to.x, low.x, high.x), std::clamp(to.y, low.y, high.y)}; }

float PlaceBox::distance(ImVec2 from) const {
    const ImVec2 near = nearest(from);
    return std::hypot(near.x - from.x, near.y - from.y);
}

float overlap(const PlaceBox& a, const PlaceBox& b) {
    return std::max(0.0f, std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x)) *
           std::max(0.0f, std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y));
}

float FreePlaces::cost(const PlaceBox& box, float least, float most) const {
    float sum = 0;
    for (const Taken& taken : taken_) {
        if (sum > most) break;
        if (taken.weight >= least) sum += taken.weight * overlap(taken.box, box);
    }
    return sum;
}

bool FreePlaces::isTaken(ImVec2 at) const {
    return std::ranges::any_of(taken_, [at](const Taken& taken) { return taken.box.distance(at) == 0; });
}

PlaceBox FreePlaces::within(ImVec2 corner, ImVec2 size) const {
    const ImVec2 low = imVec(area_.corner), high = imVec(area_.corner + area_.size);
    const ImVec2 at(std::clamp(corner.x, low.x, std::max(low.x, high.x - size.x)),
                    std::clamp(corner.y, low.y, std::max(low.y, high.y - size.y)));
    return {at, {at.x + size.x, at.y + size.y}};
}

} // namespace shadowlab::window
