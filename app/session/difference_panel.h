// Two techniques in one picture: where they answer differently, which of them is right.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "app/measure/verdict.h"
#include "app/session/figure.h"

namespace shadowlab::session {

/// `ground` is the picture of either; its colours are taken away. On it every pixel that the first or the second technique
/// gets wrong, in a colour for each, and those that both get wrong; ties are nobody's. Each has
/// been judged by the truth that it answers to, all over the picture. No GL.
Panel differencePanel(image::Image ground, const std::array<const measure::Judgement*, 2>& judgements,
                      const std::array<std::string, 2>& titles);

} // namespace shadowlab::session
