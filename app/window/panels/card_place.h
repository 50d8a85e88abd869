// The freest place of a pane for a card about a point: what it may never cover, and how far it may shrink.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/window/free_places.h"

namespace shadowlab::window {

/// A card of some size. Those with more on them are tried first.
struct CardShape {
    ImVec2 size;
    std::size_t lines = 0; ///< that it has room for
};

struct CardPlace {
    std::size_t shape = 0; ///< index of the shape that was chosen
    PlaceBox box;
};

/// Of the shapes with most lines that have a place where nothing is taken, the place from which the line to the point crosses least,
/// well away from the point; if none has one, of the shapes with fewest lines the place at which least is covered. Nothing without
/// shapes. `keepFree`: pixels around the point.
std::optional<CardPlace> freestPlace(const std::vector<CardShape>& shapes, ImVec2 point, float keepFree, const FreePlaces& places,
                                     const Theme& theme);

} // namespace shadowlab::window
