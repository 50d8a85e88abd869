// The picture of a state, of a lesson or a slide.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/course/shown_state.h"
#include "app/picture/figure.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

struct StateRequest {
    ivec2 size{0};
    int wholeHeight = 0;                      ///< of what is looked at as one, a slide: wrong pixels are marked for it; 0: the picture
    int supersample = 1;                      ///< N x N samples for a pixel, averaged in linear light
    std::optional<dvec2> picked{}, partner{}; ///< of stages about one pixel, in shares of the picture
    std::optional<scene::Camera> outside{};   ///< of the stage `outside`; none: as the program chooses it
    picture::OutsideChoice outsideChoice{};   ///< likewise
    std::optional<dvec2> range{};             ///< least and greatest value of a stage's colours; none: as the technique chose them
};

/// A state's slots, ready to be drawn in any size. Needs a current GL context for its whole life.
class StatePicture {
public:
    /// `font`: of numbers in stages that plot them. State and font have to live as long as this.
    StatePicture(const ShownState& state, const image::Font& font);

    struct Parts {
        std::vector<picture::Cell> cells;
        std::vector<picture::Panel> panels; ///< one for each cell, with its title where there are several
    };
    [[nodiscard]] Parts draw(const StateRequest& request);

private:
    picture::Panel panel(const StateRequest& request, std::size_t slot, picture::Cell& cell);
    picture::Panel difference(const StateRequest& request);

    const ShownState& state_;
    const image::Font& font_;
    picture::Session session_;
    picture::PictureEncoder encoder_;
    std::vector<picture::Slot> slots_;
};

/// Draws the state's slots, with titles and legends like those of any capture. Needs a current GL context.
image::Image drawState(const ShownState& state, const StateRequest& request, const image::Font& font);

} // namespace shadowlab::course
