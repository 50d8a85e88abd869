// One row of a picture as a curve: the technique's visibility, and the truth behind it.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/judge/verdict.h"
#include "app/picture/figure.h"
#include "app/picture/picture.h"

namespace shadowlab::picture {

/// What is plotted: all of one size.
struct Scanline {
    const judge::Truth& truth;
    const judge::Judgement& judgement;
    const VisibilityImage& visibility;
    std::string light, technique; ///< names, for the words beside the curve
};

/// The row with the most wrong pixels within the region; where all is right, the one that crosses most edges of shadows.
int mostTellingRow(const Scanline& scanline, const Region& region);

/// The picture with the row marked, and the curve over it: each column of the plot stands above or below its
/// pixel. `font` may be null: then there are no numbers.
Panel scanlinePanel(image::Image picture, const Scanline& scanline, std::optional<int> row, const Region& region,
                    const image::Font* font);

} // namespace shadowlab::picture
