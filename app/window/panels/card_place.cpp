// SPDX-License-Identifier: MIT
#include "app/window/panels/card_place.h"

#include <algorithm>
#include <cmath>

#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr float kMarginEm = 0.4f; ///< to the pane's edges
constexpr float kStepEm = 1.0f;   ///< between the places that are tried
constexpr float kLineStepEm = 0.5f;
constexpr float kFarEm = 8;   ///< away from the point: farther is no better
// What lines are made narrower for: points that the line crosses less, and how much farther away.
constexpr float kWorthCrossed = 2, kWorthEm = 3;

/// A place of one size, what the card covers there, and what its line to the point crosses.
struct Tried {
    PlaceBox box;
    float cost = FLT_MAX, crossed = FLT_MAX, away = 0;
    [[nodiscard]] bool isBetterThan(const Tried& other) const {
        if (cost != other.cost) return cost < other.cost;
        return crossed != other.crossed ? crossed < other.crossed : away > other.away;
    }
};

/// How often points on the line lie over what is taken; beyond `most` they are not counted to the end.
float crossedBy(ImVec2 from, ImVec2 to, const FreePlaces& places, float step, float most) {
    const int pieces = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
    float crossed = 0;
    for (int i = 1; i < pieces && crossed <= most; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(pieces);
        const ImVec2 at(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
        crossed += places.isTaken(at) ? 1 : 0;
    }
    return crossed;
}

/// From low to high in equal steps, both of them included.
std::vector<float> steps(float low, float high, float step) {
    std::vector<float> all{low};
    const int count = static_cast<int>(std::ceil(std::max(0.0f, high - low) / step));
    for (int i = 1; i <= count; ++i)
        all.push_back(low + (high - low) * static_cast<float>(i) / static_cast<float>(count));
    return all;
}

Tried bestPlace(ImVec2 size, ImVec2 point, float keepFree, const FreePlaces& places, const Theme& theme) {
    const float margin = kMarginEm * theme.em;
    const ImVec2 low = imVec(places.area().corner), high = imVec(places.area().corner + places.area().size);
    Tried best;
    for (const float y : steps(low.y + margin, high.y - margin - size.y, kStepEm * theme.em))
        for (const float x : steps(low.x + margin, high.x - margin - size.x, kStepEm * theme.em)) {
            const PlaceBox box = places.within({x, y}, size);
            const float onPoint = FreePlaces::kSign * overlap(box, PlaceBox::around(point, keepFree));
            Tried tried{box, places.cost(box, 0, best.cost - onPoint) + onPoint, 0, std::min(box.distance(point), kFarEm * theme.em)};
            if (tried.cost > best.cost) continue;
            const float most = tried.cost < best.cost ? FLT_MAX : best.crossed; // more is not better
            tried.crossed = crossedBy(point, box.nearest(point), places, kLineStepEm * theme.em, most);
            if (tried.isBetterThan(best)) best = tried;
        }
    return best;
}

} // namespace

std::optional<CardPlace> freestPlace(const std::vector<CardShape>& shapes, ImVec2 point, float keepFree, const FreePlaces& places,
                                     const Theme& theme) {
    std::optional<CardPlace> found;
    Tried best;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const bool shrinks = i > 0 && shapes[i].lines < shapes[i - 1].lines;
        if (shrinks && best.cost == 0) break; // more is said where there is room for it
        if (shrinks) best = {};
        const Tried tried = bestPlace(shapes[i].size, point, keepFree, places, theme);
        // Wide lines are read more easily: narrow ones have to be worth it.
        const bool isWorthIt = tried.cost != best.cost || tried.crossed + kWorthCrossed < best.crossed ||
                               (tried.crossed == best.crossed && tried.away > best.away + kWorthEm * theme.em);
        if (!tried.isBetterThan(best) || !isWorthIt) continue;
        best = tried;
        found = CardPlace{i, tried.box};
    }
    return found;
}

} // namespace shadowlab::window
