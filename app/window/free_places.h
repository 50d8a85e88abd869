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
};

/// What of a pane is taken.
class FreePlaces {
public:
    /// Names and icons must stay readable; objects are what the picture is about, but a name may lie over one where nothing else is free.
    static constexpr float kSign = 1000, kObject = 4;

    explicit FreePlaces(const ShownPane& pane) : pane_(pane) {}
    void take(const PlaceBox& box, float weight) { taken_.push_back({box, weight}); }
    /// Pixels of the box that are taken, each as often as its weight says.
    [[nodiscard]] float cost(const PlaceBox& box) const;
    /// A box of that size, moved into the pane.
    [[nodiscard]] PlaceBox within(ImVec2 corner, ImVec2 size) const;

private:
    struct Taken {
        PlaceBox box;
        float weight;
    };
    const ShownPane& pane_;
    std::vector<Taken> taken_;
};

/// With the objects that the pane shows, but for those that fill it: floors and rooms.
FreePlaces placesBesideObjects(WindowState& ui, const ShownPane& pane);

} // namespace shadowlab::window
