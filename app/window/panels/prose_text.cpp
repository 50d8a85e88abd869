// SPDX-License-Identifier: MIT
#include "app/window/panels/prose_text.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "app/drawing/prose.h"

namespace shadowlab::window {

namespace {

constexpr double kProseAbove = 1.0, kProseBelow = 0.4; ///< em of a line above and below the foot of its letters, at least
constexpr double kHeightOfEm = 1.164; ///< of DejaVu Sans from its highest to its deepest letter, which is what ImGui calls a size
constexpr float kProseSlant = 0.2f;  ///< of a variable: DejaVu Sans Oblique leans by 11 degrees
constexpr float kBoldShift = 0.06f;  ///< em: the window has no bold face, so that a vector is drawn twice

drawing::FormulaFonts fontsOf(const Theme& theme) { return {theme.faces->upright, theme.faces->bold}; }

/// A line in its place: fractions make it higher, and a formula that is too wide is set smaller.
struct SetLine {
    drawing::ProseLine line;
    double em = 0, foot = 0; ///< foot: from the top of the text
};
struct SetText {
    std::vector<SetLine> lines;
    double height = 0;
};
SetText setText(const std::string& text, float width, const Theme& theme) {
    const drawing::FormulaFonts fonts = fontsOf(theme);
    const double whole = theme.em / kHeightOfEm;
    SetText set;
    for (drawing::ProseLine& line : drawing::wrapProse(text, whole, std::max(1.0f, width), false, fonts)) {
        const double em = whole * std::min(1.0, width / std::max(1.0, drawing::proseWidth(line, whole, false, fonts)));
        double above = kProseAbove * em, below = kProseBelow * em;
        for (const drawing::ProseLine::Piece& piece : line.pieces) {
            if (!piece.isFormula) continue;
            const drawing::Extent extent = drawing::Formula(piece.text).measure(em, fonts);
            above = std::max(above, extent.above);
            below = std::max(below, extent.below);
        }
        set.lines.push_back({std::move(line), em, set.height + above});
        set.height += above + below;
    }
    return set;
}

/// What formulas are made of: letters and lines.
struct ProsePen {
    ImDrawList* list;
    const Theme& theme;
    ImVec2 origin;
    ImU32 color;

    [[nodiscard]] ImVec2 at(const dvec2& place) const {
        return {origin.x + static_cast<float>(place.x), origin.y + static_cast<float>(place.y)};
    }
    void operator()(const drawing::TextLine& text) const {
        const auto size = static_cast<float>(kHeightOfEm * text.style.size);
        const ImVec2 foot = at(text.place);
        const float ascent = theme.text->Ascent * size / theme.text->FontSize;
        const int first = list->VtxBuffer.Size;
        for (const float shift : {0.0f, kBoldShift * size})
            if (shift == 0 || text.style.isBold)
                list->AddText(theme.text, size, {foot.x + shift, foot.y - ascent}, color, text.text.c_str());
        if (!text.style.isItalic) return;
        for (int i = first; i < list->VtxBuffer.Size; ++i)
            list->VtxBuffer[i].pos.x += kProseSlant * (foot.y - list->VtxBuffer[i].pos.y);
    }
    void operator()(const drawing::Line& line) const {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
            list->AddLine(at(line.points[i]), at(line.points[i + 1]), color, static_cast<float>(line.stroke.width));
    }
    template <typename Other>
    void operator()(const Other&) const {}
};

} // namespace

float proseHeight(const std::string& text, float width, const Theme& theme) {
    return static_cast<float>(setText(text, width, theme).height);
}

float proseWidth(const std::string& text, const Theme& theme) {
    const double em = theme.em / kHeightOfEm;
    const drawing::FormulaFonts fonts = fontsOf(theme);
    return static_cast<float>(drawing::proseWidth(drawing::proseInOneLine(text, em, false, fonts), em, false, fonts));
}

Theme forHeading(Theme theme) {
    theme.em = theme.headingSize;
    return theme;
}

void proseText(const std::string& text, float width, ImU32 color, const Theme& theme) {
    const SetText set = setText(text, width, theme);
    drawing::Drawing drawing({width, set.height});
    for (const SetLine& one : set.lines)
        drawing::drawProse(drawing, {0, one.foot}, one.line, {.size = one.em, .hasRim = false}, fontsOf(theme));
    const ProsePen pen{ImGui::GetWindowDrawList(), theme, ImGui::GetCursorScreenPos(), color};
    for (const drawing::Mark& mark : drawing.marks())
        std::visit(pen, mark);
    ImGui::Dummy({width, static_cast<float>(set.height)});
}

} // namespace shadowlab::window
