// SPDX-License-Identifier: MIT
#include "app/drawing/prose.h"

#include <algorithm>

#include "app/drawing/markup.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::drawing {

namespace {

using Piece = ProseLine::Piece;
using Word = std::vector<Piece>; ///< pieces without a blank between them: a formula and the full stop after it

/// Texts and formulas in turns: the odd ones stand between two $.
std::vector<Piece> piecesOf(std::string_view text) {
    std::vector<Piece> pieces;
    bool isFormula = false;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find('$', from), text.size());
        if (to == text.size() && isFormula)
            throw Error(ExitStatus::badInput, "a $ begins a formula and none ends it; write for example $d(u,v)$");
        if (to > from) pieces.push_back({std::string(text.substr(from, to - from)), isFormula});
        isFormula = !isFormula;
        from = to + 1;
    }
    return pieces;
}

std::vector<Word> wordsOf(std::string_view text) {
    std::vector<Word> words;
    bool isGlued = false; // to the word before
    for (const Piece& piece : piecesOf(text)) {
        if (piece.isFormula) {
            if (isGlued)
                words.back().push_back(piece);
            else
                words.push_back({piece});
            isGlued = true;
            continue;
        }
        for (std::size_t from = 0; from < piece.text.size();) {
            if (piece.text[from] == ' ') {
                isGlued = false;
                ++from;
                continue;
            }
            const std::size_t to = std::min(piece.text.find(' ', from), piece.text.size());
            const Piece word{piece.text.substr(from, to - from), false};
            if (isGlued)
                words.back().push_back(word);
            else
                words.push_back({word});
            isGlued = true;
            from = to;
        }
    }
    return words;
}

/// Pixels, finer than the whole ones that a font measures in.
double textWidth(std::string_view text, double em, bool isBold, const FormulaFonts& fonts) {
    constexpr double kFine = 1000;
    return (isBold ? fonts.bold : fonts.upright).measure(text, kFine).width / kFine * em;
}

/// A formula among bold words is bold as a whole.
FormulaFonts facesFor(bool isBold, const FormulaFonts& fonts) { return {fonts.upright, fonts.bold, isBold}; }

double pieceWidth(const Piece& piece, double em, bool isBold, const FormulaFonts& fonts) {
    return piece.isFormula ? Formula(piece.text).measure(em, facesFor(isBold, fonts)).width
                           : textWidth(piece.text, em, isBold, fonts);
}

/// Adds a word after a blank; words side by side are one text.
void append(ProseLine& line, const Word& word) {
    for (std::size_t i = 0; i < word.size(); ++i) {
        const std::string before = i == 0 && !line.pieces.empty() ? " " : "";
        if (word[i].isFormula) {
            if (!before.empty()) {
                if (line.pieces.back().isFormula)
                    line.pieces.push_back({before, false});
                else
                    line.pieces.back().text += before;
            }
            line.pieces.push_back(word[i]);
        } else if (!line.pieces.empty() && !line.pieces.back().isFormula) {
            line.pieces.back().text += before + word[i].text;
        } else {
            line.pieces.push_back({before + word[i].text, false});
        }
    }
}

} // namespace

double proseWidth(const ProseLine& line, double em, bool isBold, const FormulaFonts& fonts) {
    double width = 0;
    for (const Piece& piece : line.pieces)
        width += pieceWidth(piece, em, isBold, fonts);
    return width;
}

std::vector<ProseLine> wrapProse(std::string_view text, double em, double width, bool isBold, const FormulaFonts& fonts) {
    std::vector<ProseLine> lines;
    if (text.find('$') == std::string_view::npos) {
        for (const std::string& line : (isBold ? fonts.bold : fonts.upright).wrap(text, em, static_cast<int>(width)))
            lines.push_back({{{line, false}}});
        return lines;
    }
    for (const Word& word : wordsOf(text)) {
        ProseLine longer = lines.empty() ? ProseLine{} : lines.back();
        append(longer, word);
        if (!lines.empty() && proseWidth(longer, em, isBold, fonts) <= width) {
            lines.back() = std::move(longer);
        } else {
            lines.emplace_back();
            append(lines.back(), word);
        }
    }
    return lines;
}

ProseLine proseInOneLine(std::string_view text, double em, bool isBold, const FormulaFonts& fonts) {
    constexpr double kOneLine = 1e9; // pixels: no line is as wide
    std::vector<ProseLine> lines = wrapProse(text, em, kOneLine, isBold, fonts);
    return lines.empty() ? ProseLine() : std::move(lines.front());
}

void drawProse(Drawing& drawing, dvec2 place, const ProseLine& line, const TextStyle& style, const FormulaFonts& fonts) {
    const double share = style.anchor == Anchor::start ? 0 : style.anchor == Anchor::middle ? 0.5 : 1;
    if (share > 0) place.x -= share * proseWidth(line, style.size, style.isBold, fonts);
    for (const Piece& piece : line.pieces) {
        if (piece.isFormula) {
            Formula(piece.text).draw(drawing, place, style.size, style.color, facesFor(style.isBold, fonts), style.hasRim);
        } else {
            TextStyle placed = style;
            placed.anchor = Anchor::start;
            drawing.text(place, piece.text, placed);
        }
        place.x += pieceWidth(piece, style.size, style.isBold, fonts);
    }
}

void drawProse(Drawing& drawing, dvec2 place, std::string_view text, const TextStyle& style, const FormulaFonts& fonts) {
    drawProse(drawing, place, proseInOneLine(text, style.size, style.isBold, fonts), style, fonts);
}

std::string plainProse(std::string_view text) {
    std::string plain;
    for (const Piece& piece : piecesOf(text))
        plain += piece.isFormula ? Formula(piece.text).spoken() : piece.text;
    return plain;
}

std::string proseMarkup(std::string_view text) {
    std::string markup;
    for (const Piece& piece : piecesOf(text))
        markup += piece.isFormula ? Formula(piece.text).mathML(false) : escapedMarkup(piece.text);
    return markup;
}

} // namespace shadowlab::drawing
