// What stands below the picture of a step in a sequence of steps: which it is, and its title.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/picture/session.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::picture {

class StepCaptions {
public:
    /// For the passes of a technique, in the order in which they run, in pictures of that size, of which the captions take the
    /// lower part. All are as high as the highest.
    StepCaptions(const TechniqueInfo& info, const std::vector<StageKey>& passes, const scene::Scene& scene,
                 const image::Font& font, ivec2 size);

    /// Pixels.
    [[nodiscard]] int height() const { return height_; }
    /// The picture of a step with its caption below. `note`: how it is shown (Panel::note).
    [[nodiscard]] image::Image below(const image::Image& picture, std::size_t step, const std::string& note = {}) const;

private:
    struct Caption {
        std::string which;
        std::vector<std::string> title; ///< in lines
    };
    const image::Font& font_;
    double smallEm_, em_; ///< pixels: type of the first line, and of the title
    int margin_, height_ = 0;
    std::vector<Caption> captions_;
};

} // namespace shadowlab::picture
