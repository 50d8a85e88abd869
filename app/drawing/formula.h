// A formula, set as in a book.
//
// It is written in a small part of TeX's mathematics, so that the same text also serves programs that read TeX: letters, numbers
// and signs; _ and ^; \frac{}{}, \sqrt{}; \sum, \int, \iint with limits; \mathbf{N} for a vector, \text{...} for words;
// \left( ... \right) with ( [ | or a full stop for none; \begin{bmatrix} a & b \\ c & d \end{bmatrix}; Greek letters and the
// usual signs by their names. Blanks mean nothing; \, \; and \quad are space.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "app/drawing/drawing.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::drawing {

/// What something takes of the sheet around the foot of its line, in pixels.
struct Extent {
    double width = 0, above = 0, below = 0;
};

/// The faces that formulas are set in. Letters of variables lean; there is no face for them, so they are drawn slanted.
struct FormulaFonts {
    const image::Font &upright, &bold;
    bool isBold = false; ///< all of it, as in a heading
};

class Formula {
public:
    /// Throws Error (badInput) that names the column and what can be written there.
    explicit Formula(std::string_view tex);
    ~Formula();
    Formula(Formula&&) noexcept;
    Formula& operator=(Formula&&) noexcept;

    [[nodiscard]] Extent measure(double em, const FormulaFonts& fonts) const;
    /// Draws with the left end of the foot line at `place`. Returns what measure() returns. `hasRim`: as TextStyle::hasRim.
    Extent draw(Drawing& drawing, dvec2 place, double em, const std::string& color, const FormulaFonts& fonts, bool hasRim = false) const;

    /// In one line for who cannot see it: "N · P' + D = 0", "F_jk = (1)/(A_j) ∫∫ ...".
    [[nodiscard]] std::string spoken() const;

    /// For a page: an element that browsers set as a book does, on a line of its own if displayed. The page's style has to slant
    /// `.variable` and to make `.vector` bold.
    [[nodiscard]] std::string mathML(bool isDisplayed) const;

    struct Node; ///< of the tree that was read

private:
    std::unique_ptr<Node> root_;
};

} // namespace shadowlab::drawing
