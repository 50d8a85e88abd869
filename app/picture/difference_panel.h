// Two techniques in one picture: where they answer differently, which of them is right.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <string>

#include "app/judge/verdict.h"
#include "app/picture/figure.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "app/picture/wrong_marks.h"

namespace shadowlab::picture {

/// `ground` is the picture of either; its colours are taken away. On it every pixel that the first or the second technique
/// gets wrong, in a colour for each, and those that both get wrong; ties are not
/// coloured. Each technique was judged by its own kind of truth, over the whole picture. Pixels that stand alone are drawn as
/// squares of that width (wrong_marks.h), and counted as one. No OpenGL.
Panel differencePanel(image::Image ground, const std::array<const judge::Judgement*, 2>& judgements,
                      const std::array<std::string, 2>& titles, int markWidth = kOnePixel);

struct RenderedDifference {
    Panel panel; ///< without title
    std::array<RenderedFrame, 2> rendered;
};
/// Renders two slots whose techniques publish their visibility, and holds both against the truth about one light.
RenderedDifference renderDifference(Session& session, std::span<Slot> slots, const PictureEncoder& encoder, const View& view,
                                    int light, int markWidth, bool timePasses = false);

} // namespace shadowlab::picture
