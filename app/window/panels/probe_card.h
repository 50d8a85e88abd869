// The card about the picked pixel: lit or in shadow, and the sums that lead there.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/window/free_places.h"

namespace shadowlab::window {

/// One line of the card, as it is broken for its width.
struct CardLine {
    std::string text;
    float size = 0; ///< of its type, pixels
    ImU32 color = 0;
    bool endsSentence = true; ///< a gap comes below it
};

struct ProbeCard {
    std::vector<CardLine> lines; ///< the verdict first
    PlaceBox box;
    ImVec2 ring; ///< the picked point in the pane's picture
};

/// In the active pane, where it covers nothing that the picture is about. Nothing while no pixel is picked, or its probe is not known,
/// or where the pane's picture does not show it.
std::optional<ProbeCard> probeCard(const WindowState& ui, const ShownPane& shown, const FreePlaces& places, const Theme& theme);

/// With a line to the ring.
void drawProbeCard(ImDrawList& list, const ProbeCard& card, const Theme& theme);

} // namespace shadowlab::window
