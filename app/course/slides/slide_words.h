// The words of a slide: paragraphs, formulas, and the lecture's pseudocode with its lines marked.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/course/slides/slide_layout.h"

namespace shadowlab::course {

/// In em: that of letters, 0 where not even the smallest fits, and that of the smallest formula, 0 without one.
struct WordsType {
    double letters = 0, formulas = 0;
    friend bool operator==(const WordsType&, const WordsType&) = default;
};
/// The largest type in which the words fit into a column of that size. `isCaption`: the slide's caption alone, else all but that.
WordsType wordsType(const Slide& slide, bool isCaption, dvec2 size, const Fonts& fonts);

/// Writes all of them into the layout's box, in the largest type that fits. Throws Error (badInput) where not even the smallest
/// does: what is read from the last row.
void writeWords(drawing::Drawing& drawing, const Slide& slide, const SlideLayout& layout, const Fonts& fonts);

} // namespace shadowlab::course
