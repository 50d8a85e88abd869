// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_words.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/base/error.h"

namespace shadowlab::course {

namespace {

using drawing::Drawing;
using drawing::TextStyle;

constexpr const char *kTextInk = "#1a1a1a", *kMarkedGround = "#ffe9b8";
constexpr double kFormulaSize = 1.25; ///< times the type beside it
constexpr double kBetween = 0.6;      ///< em between paragraphs
constexpr double kFootAbove = 0.3;    ///< em from the foot of the letters to the end of the line

/// Writes from the top down; with a null sheet it only measures.
class Column {
public:
    Column(Drawing* drawing, const Box& box, double type, const Fonts& fonts)
        : svg_(drawing), box_(box), type_(type), fonts_(fonts) {}

    void paragraph(const std::string& text) {
        for (const drawing::ProseLine& line : drawing::wrapProse(text, type_, box_.size.x, false, fonts_.formula())) {
            y_ += kLineHeight * type_;
            if (svg_)
                drawing::drawProse(*svg_, box_.corner + dvec2(0, y_ - kFootAbove * type_), line,
                                   {.size = type_, .color = kTextInk, .hasRim = false}, fonts_.formula());
        }
        y_ += kBetween * type_;
    }
    /// Lines keep their indentation, also where they go on.
    void code(const std::string& text, bool isMarked) {
        const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
        const double indent = 0.5 * type_ * static_cast<double>(blanks);
        for (const std::string& line :
             (isMarked ? fonts_.bold : fonts_.upright).wrap(text.substr(blanks), type_, static_cast<int>(box_.size.x - indent)))
            put(line, indent, isMarked);
        y_ += 0.2 * type_;
    }
    void formula(const std::string& tex) {
        const drawing::Formula formula(tex);
        const drawing::FormulaFonts fonts = fonts_.formula();
        double em = kFormulaSize * type_;
        drawing::Extent extent = formula.measure(em, fonts);
        if (extent.width > box_.size.x) {
            em *= box_.size.x / extent.width;
            extent = formula.measure(em, fonts);
        }
        smallestFormula_ = smallestFormula_ > 0 ? std::min(smallestFormula_, em) : em;
        y_ += extent.above;
        if (svg_) formula.draw(*svg_, box_.corner + dvec2(0, y_), em, kTextInk, fonts);
        y_ += extent.below + kBetween * type_;
    }
    [[nodiscard]] bool fits() const { return y_ <= box_.size.y && (smallestFormula_ == 0 || smallestFormula_ >= kLeastType); }
    [[nodiscard]] double smallestFormula() const { return smallestFormula_; }

private:
    void put(const std::string& line, double indent, bool isMarked) {
        const double height = kLineHeight * type_;
        if (svg_ && isMarked)
            svg_->rectangle(box_.corner + dvec2(-8, y_ - 0.06 * type_), {box_.size.x + 16, height}, kMarkedGround,
                            {kMarkedGround, 0, false});
        y_ += height;
        if (svg_)
            svg_->text(box_.corner + dvec2(indent, y_ - kFootAbove * type_), line,
                       {.size = type_, .isBold = isMarked, .color = kTextInk, .hasRim = false});
    }

    Drawing* svg_;
    Box box_;
    double type_;
    const Fonts& fonts_;
    double y_ = 0;
    double smallestFormula_ = 0; ///< em; 0: there is none
};

/// Text first, then formulas, then the pseudocode; or the caption alone.
Column write(Drawing* drawing, const Slide& slide, bool isCaption, const Box& box, double type, const Fonts& fonts) {
    Column column(drawing, box, type, fonts);
    if (isCaption) {
        column.paragraph(slide.written.caption);
        return column;
    }
    for (const std::string& text : slide.written.text)
        column.paragraph(text);
    for (const std::string& tex : slide.formulas)
        column.formula(tex);
    int number = 0;
    for (const std::string& line : slide.pseudocode)
        column.code(line, std::ranges::find(slide.marked, ++number) != slide.marked.end());
    return column;
}

} // namespace

WordsType wordsType(const Slide& slide, bool isCaption, dvec2 size, const Fonts& fonts) {
    for (const double type : {36.0, 32.0, 29.0, 26.0, kLeastType})
        if (const Column column = write(nullptr, slide, isCaption, {{}, size}, type, fonts); column.fits())
            return {type, column.smallestFormula()};
    return {};
}

void writeWords(Drawing& drawing, const Slide& slide, const SlideLayout& layout, const Fonts& fonts) {
    if (layout.words.size.x <= 0) return;
    const double type = wordsType(slide, layout.hasCaptionBeside, layout.words.size, fonts).letters;
    if (type > 0) {
        write(&drawing, slide, layout.hasCaptionBeside, layout.words, type, fonts);
        return;
    }
    throw Error(ExitStatus::badInput,
                "the words do not fit beside the pictures in type that can be read; make them fewer, or two slides");
}

} // namespace shadowlab::course
