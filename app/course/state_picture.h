// The picture of a state, of a lesson or a slide.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/course/shown_state.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

struct StateRequest {
    ivec2 size{0};
    int supersample = 1; ///< N x N samples for a pixel, averaged in linear light
    int typeHeight = 0;  ///< the height that type sizes are shares of; 0: the picture's own
    int roomBelow = 0;   ///< how much higher the picture may become, so that its legends stand below it
    std::optional<dvec2> picked{}, partner{}; ///< of stages about one pixel, in shares of the picture
    std::optional<scene::Camera> outside{};   ///< of the stage `outside`; none: as the program chooses it
};

/// Draws the state's slots, with titles and legends like those of any capture. Needs a current GL context.
image::Image drawState(const ShownState& state, const StateRequest& request, const image::Font& font);

} // namespace shadowlab::course
