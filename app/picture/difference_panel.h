// Two techniques in one picture: where they answer differently, which of them is right.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "app/judge/verdict.h"
#include "app/picture/figure.h"

namespace shadowlab::picture {

/// `ground` is the picture of either; its colours are taken away. On it every pixel that the first or the second technique
/// gets wrong, in a colour for each, and those that both get wrong; ties are nobody's. Each has
/// been judged by the truth that it answers to, all over the picture. No GL.
Panel differencePanel(image::Image ground, const std::array<const judge::Judgement*, 2>& judgements,
                      const std::array<std::string, 2>& titles);

} // namespace shadowlab::picture
