// Where plates with text find room in a pane: beside lamps and their names, and rather beside the objects than over them.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// A rectangle of the window, in pixels.
struct PlaceBox {
    ImVec2 low, high;
    [[nodiscard]] ImVec2 size() const { return {high.x - low.x, high.y - low.y}; }
    /// A square around a point.
    static PlaceBox around(ImVec2 at, float radius) { return {{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}}; }
    [[nodiscard]] ImVec2 nearest(ImVec2 to) const;
    [[nodiscard]] float distance(ImVec2 from) const;
};

/// Pixels of the window that lie in both.
float overlap(const PlaceBox& a, const PlaceBox& b);

/// What of a pane is taken.
class FreePlaces {
public:
    /// Names and icons must stay readable; objects are what the picture is about, but a name may lie over one where nothing else is free.
    static constexpr float kSign = 1000, kObject = 4;
    struct Taken {
        PlaceBox box;
        float weight;
    };

    explicit FreePlaces(const Area& area) : area_(area) {}
    void take(const PlaceBox& box, float weight) { taken_.push_back({box, weight}); }
    /// Pixels of the box that are taken, each as often as its weight says; of what weighs less than `least`, none. Beyond `most` it is not
    /// counted to its end.
    [[nodiscard]] float cost(const PlaceBox& box, float least = 0, float most = FLT_MAX) const;
    [[nodiscard]] bool isTaken(ImVec2 at) const;
    /// A box of that size, moved into the pane.
    [[nodiscard]] PlaceBox within(ImVec2 corner, ImVec2 size) const;
    [[nodiscard]] const Area& area() const { return area_; }
    [[nodiscard]] const std::vector<Taken>& taken() const { return taken_; }

private:
    Area area_;
    std::vector<Taken> taken_;
};

} // namespace shadowlab::window
