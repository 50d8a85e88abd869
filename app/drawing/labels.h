// Places labels beside what they name, so that none covers another, nor a line where there is room elsewhere.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/drawing/formula.h"

namespace shadowlab::drawing {

/// A rectangle of the sheet.
struct Box {
    dvec2 corner{0.0}, size{0.0};
    [[nodiscard]] bool overlaps(const Box& other) const {
        return corner.x < other.corner.x + other.size.x && other.corner.x < corner.x + size.x &&
               corner.y < other.corner.y + other.size.y && other.corner.y < corner.y + size.y;
    }
};

/// Width and height of a line of text, in pixels.
dvec2 textSize(const image::Font& font, std::string_view text, double em);

/// What a label says: "P", a lowered "L", and what comes after it.
struct LabelText {
    std::string letter, index, rest;
};
constexpr double kIndexScale = 0.72; ///< of an index' size, of that of its letter
constexpr double kLetter = 34;       ///< em of letters that have an index, so that it is read from the last row, too

class Labels {
public:
    /// All labels stay within `area`.
    Labels(const FormulaFonts& fonts, const Box& area) : fonts_(fonts), area_(area) {}
    Labels(const image::Font& font, const Box& area) : Labels(FormulaFonts{font, font}, area) {}

    /// What labels keep away from as well as they can.
    void avoid(dvec2 from, dvec2 to) { lines_.push_back({from, to}); }
    void avoid(const Box& box) { boxes_.push_back(box); }

    /// Writes a label near a place: `away` pixels from it at least. Where it has to go far, a thin line leads to it. Of
    /// places that are equally free the nearest. Nothing is written, and false returned, where there is no room at all.
    /// `text` may have formulas between $ (prose.h).
    bool place(Drawing& drawing, dvec2 anchor, const std::string& text, const TextStyle& style, double away = 10);
    bool place(Drawing& drawing, dvec2 anchor, const LabelText& text, const TextStyle& style, double away = 10);

private:
    [[nodiscard]] double cost(const Box& box) const;
    [[nodiscard]] int crossedBy(dvec2 from, dvec2 to) const;
    [[nodiscard]] std::optional<Box> roomFor(Drawing& drawing, dvec2 anchor, dvec2 size, double away);
    struct Line {
        dvec2 from, to;
    };
    FormulaFonts fonts_;
    Box area_;
    std::vector<Line> lines_;
    std::vector<Box> boxes_;
};

} // namespace shadowlab::drawing
