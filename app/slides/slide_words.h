// The words of a slide: paragraphs, formulas, and the lecture's pseudocode with its lines marked.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/slides/slide_layout.h"

namespace shadowlab::slides {

/// Writes all of them into the layout's box, in the largest type that fits. Throws Error (badInput) where not even the smallest
/// does: what is read from the last row.
void writeWords(diagram::Drawing& drawing, const session::Slide& slide, const SlideLayout& layout, const Fonts& fonts);

} // namespace shadowlab::slides
