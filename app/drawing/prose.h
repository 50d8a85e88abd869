// Words with formulas among them: "the texel holds $d(u,v)$". What stands between two $ is set as a formula (formula.h), all else as
// it is. Lines break at blanks outside of formulas.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/drawing/formula.h"

namespace shadowlab::drawing {

/// A line of prose, in pieces that stand side by side.
struct ProseLine {
    struct Piece {
        std::string text; ///< of a formula: its TeX
        bool isFormula = false;
    };
    std::vector<Piece> pieces;
};

/// Lines no wider than `width` pixels, where words allow it. Throws Error (badInput) for a formula that cannot be read, and for a $
/// without its partner.
std::vector<ProseLine> wrapProse(std::string_view text, double em, double width, bool isBold, const FormulaFonts& fonts);

/// The text as one line, however long. Throws as wrapProse() does.
ProseLine proseInOneLine(std::string_view text, double em, bool isBold, const FormulaFonts& fonts);

/// Pixels from the line's left end to its right end.
double proseWidth(const ProseLine& line, double em, bool isBold, const FormulaFonts& fonts);

/// Draws a line with its anchor at `place`, the foot of its letters. Letters of formulas are as bold as the words.
void drawProse(Drawing& drawing, dvec2 place, const ProseLine& line, const TextStyle& style, const FormulaFonts& fonts);
/// The same of a text in one line.
void drawProse(Drawing& drawing, dvec2 place, std::string_view text, const TextStyle& style, const FormulaFonts& fonts);

/// The same in plain words, for who reads no formulas: "the texel holds d(u, v)". Throws as wrapProse() does.
std::string plainProse(std::string_view text);

/// The same for a page: words with the signs of markup escaped, formulas as MathML. Throws as wrapProse() does.
std::string proseMarkup(std::string_view text);

} // namespace shadowlab::drawing
