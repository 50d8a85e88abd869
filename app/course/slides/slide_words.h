// The words of a slide: paragraphs, formulas, and the lecture's pseudocode with its lines marked.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/course/slides/slide_layout.h"

namespace shadowlab::course {

/// Writes all of them into the layout's box, in the largest type that fits. Throws Error (badInput) where not even the smallest
/// does: what is read from the last row.
void writeWords(drawing::Drawing& drawing, const Slide& slide, const SlideLayout& layout, const Fonts& fonts);

} // namespace shadowlab::course
