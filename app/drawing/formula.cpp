// SPDX-License-Identifier: MIT
#include "app/drawing/formula.h"

#include <algorithm>

#include "app/drawing/formula_tree.h"

namespace shadowlab::drawing {

namespace {

using Node = Formula::Node;
using Kind = Node::Kind;

// Of DejaVu Sans, in em: the height of its tall letters, what reaches below the line, and the middle of its minus.
constexpr double kTall = 0.76, kDeep = 0.236, kAxis = 0.314;
// As TeX has it for displayed formulas (Knuth 1984, The TeXbook, appendix G), rounded: sizes and shifts in em.
constexpr double kScriptSize = 0.7, kRaise = 0.42, kLower = 0.2, kOperationSpace = 0.26, kMarkSpace = 0.2,
                 kFunctionSpace = 1.0 / 6;
constexpr double kFractionSize = 0.86, kBarGap = 0.1, kRuleWidth = 0.05, kLargeSize = 1.5, kLimitGap = 0.08;
// A row of a matrix has room for an index in any case, so that matrices side by side have their rows at one height.
constexpr double kMatrixRowDeep = kLower + kScriptSize * kDeep;
constexpr double kMatrixGap = 0.7, kMatrixLineGap = 0.2, kMatrixPad = 0.2, kFencePad = 0.14;

/// Sets a tree: with a sheet it draws, without one it measures.
class Setter {
public:
    Setter(const FormulaFonts& fonts, std::string color, Drawing* drawing, bool hasRim = false)
        : fonts_(fonts), color_(std::move(color)), svg_(drawing), hasRim_(hasRim) {}

    Extent set(const Node& node, dvec2 place, double em) {
        switch (node.kind) {
        case Kind::row: return row(node, place, em);
        case Kind::space: return {node.size * em, 0, 0};
        case Kind::scripts: return scripts(node, place, em);
        case Kind::large: return large(node, place, em);
        case Kind::fraction: return fraction(node, place, em);
        case Kind::root: return root(node, place, em);
        case Kind::fenced: return fenced(node, place, em);
        case Kind::matrix: return matrix(node, place, em);
        default: return letters(node, place, em);
        }
    }

private:
    [[nodiscard]] Extent measured(const Node& node, double em) const {
        return Setter(fonts_, color_, nullptr).set(node, {0, 0}, em);
    }
    void rule(dvec2 from, dvec2 to, double em) {
        if (svg_) svg_->line(from, to, {color_, std::max(1.0, kRuleWidth * em), false});
    }

    Extent letters(const Node& node, dvec2 place, double em) {
        const bool isBold = fonts_.isBold || node.kind == Kind::bold;
        constexpr double kFine = 1000; // pixels: whole ones are fine enough then
        const image::Font& font = isBold ? fonts_.bold : fonts_.upright;
        const double width = font.measure(node.text, kFine).width / kFine * em;
        if (svg_)
            svg_->text(place, node.text,
                       {.size = em,
                        .isBold = isBold,
                        .isItalic = node.kind == Kind::variable,
                        .color = color_,
                        .hasRim = hasRim_});
        return {width, kTall * em, kDeep * em};
    }

    static bool isFunction(const Node& node) {
        return (node.kind == Kind::scripts ? node.children[0] : node).kind == Kind::function;
    }
    static double spaceAfter(const Node& node) {
        return node.kind == Kind::mark ? kMarkSpace : isFunction(node) ? kFunctionSpace : 0;
    }
    /// A function keeps away from what it is multiplied by.
    static double spaceBefore(const Node& node, const Node* before) {
        const bool isFree = !before || before->kind == Kind::operation || before->kind == Kind::opening || before->kind == Kind::mark ||
                            before->kind == Kind::space || before->kind == Kind::large;
        return isFunction(node) && !isFree ? kFunctionSpace : 0;
    }

    Extent row(const Node& node, dvec2 place, double em) {
        Extent whole;
        const Node* before = nullptr;
        for (const Node& child : node.children) {
            // A minus at the beginning, or after another sign, belongs to the number that follows.
            const bool isSign = child.kind == Kind::operation &&
                                (!before || before->kind == Kind::operation || before->kind == Kind::opening ||
                                 before->kind == Kind::mark || before->kind == Kind::space);
            const double around = child.kind == Kind::operation && !isSign ? kOperationSpace * em : 0;
            whole.width += around + spaceBefore(child, before) * em;
            const Extent extent = set(child, place + dvec2(whole.width, 0), em);
            whole.width += extent.width + around + spaceAfter(child) * em;
            whole.above = std::max(whole.above, extent.above);
            whole.below = std::max(whole.below, extent.below);
            before = &child;
        }
        return whole;
    }

    Extent scripts(const Node& node, dvec2 place, double em) {
        Extent whole = set(node.children[0], place, em);
        const double small = kScriptSize * em, base = whole.width;
        // Beside something high the scripts go to its corners.
        const double raise = std::max(kRaise * em, whole.above - 0.5 * em),
                     lower = std::max(kLower * em, whole.below - 0.2 * em);
        if (!node.children[1].children.empty() || node.children[1].kind != Kind::row) {
            const Extent low = set(node.children[1], place + dvec2(base, lower), small);
            whole.width = base + low.width;
            whole.below = std::max(whole.below, lower + low.below);
        }
        if (!node.children[2].children.empty() || node.children[2].kind != Kind::row) {
            const Extent high = set(node.children[2], place + dvec2(base, -raise), small);
            whole.width = std::max(whole.width, base + high.width);
            whole.above = std::max(whole.above, raise + high.above);
        }
        return whole;
    }

    Extent large(const Node& node, dvec2 place, double em) {
        const double size = kLargeSize * em;
        const Node sign{Kind::upright, node.text, 0, 0, false, {}};
        Extent whole = measured(sign, size);
        // The sign's middle comes to the height of a minus.
        const double drop = (0.5 * (kTall - kDeep) * size) - kAxis * em;
        whole.above -= drop;
        whole.below += drop;
        if (!node.hasLimits) {
            Node scripted{Kind::scripts, "", 0, 0, false, {Node{}, node.children[0], node.children[1]}};
            set(sign, place + dvec2(0, drop), size);
            const Extent beside = set(scripted, place + dvec2(whole.width, 0), em);
            return {whole.width + beside.width + kFencePad * em, std::max(whole.above, beside.above),
                    std::max(whole.below, beside.below)};
        }
        const double small = kScriptSize * em;
        const Extent low = measured(node.children[0], small), high = measured(node.children[1], small);
        const double width = std::max({whole.width, low.width, high.width});
        set(sign, place + dvec2((width - whole.width) / 2, drop), size);
        if (low.width > 0) {
            set(node.children[0], place + dvec2((width - low.width) / 2, whole.below + low.above), small);
            whole.below += low.above + low.below + kLimitGap * em;
        }
        if (high.width > 0) {
            set(node.children[1], place + dvec2((width - high.width) / 2, -whole.above - high.below), small);
            whole.above += high.above + high.below + kLimitGap * em;
        }
        return {width + kFencePad * em, whole.above, whole.below};
    }

    Extent fraction(const Node& node, dvec2 place, double em) {
        const double size = kFractionSize * em, gap = kBarGap * em;
        const Extent over = measured(node.children[0], size), under = measured(node.children[1], size);
        const double pad = kFencePad * em, width = std::max(over.width, under.width) + 2 * pad;
        const double bar = kAxis * em;
        set(node.children[0], place + dvec2((width - over.width) / 2, -bar - gap - over.below), size);
        set(node.children[1], place + dvec2((width - under.width) / 2, -bar + gap + under.above), size);
        rule(place + dvec2(pad / 2, -bar), place + dvec2(width - pad / 2, -bar), em);
        return {width, bar + gap + over.below + over.above, under.above + under.below + gap - bar};
    }

    Extent root(const Node& node, dvec2 place, double em) {
        const Extent inner = measured(node.children[0], em);
        const double hook = 0.55 * em, top = inner.above + kBarGap * em;
        set(node.children[0], place + dvec2(hook, 0), em);
        rule(place + dvec2(0.08 * em, -0.35 * em), place + dvec2(0.28 * em, inner.below), em);
        rule(place + dvec2(0.28 * em, inner.below), place + dvec2(hook, -top), em);
        rule(place + dvec2(hook, -top), place + dvec2(hook + inner.width, -top), em);
        return {hook + inner.width + kFencePad * em, top + kRuleWidth * em, inner.below};
    }

    /// One fence around what reaches so far above and below the line. Returns its width.
    double fence(char sign, dvec2 place, const Extent& inner, double em) {
        if (sign == '.') return 0;
        const double width = 0.3 * em, top = -inner.above, bottom = inner.below;
        const auto at = [&](double x, double y) { return place + dvec2(x * width, y); };
        if (sign == '|') {
            rule(at(0.5, top), at(0.5, bottom), em);
        } else if (sign == '[' || sign == ']') {
            const double spine = sign == '[' ? 0.3 : 0.7, end = sign == '[' ? 0.9 : 0.1;
            for (const double y : {top, bottom})
                rule(at(spine, y), at(end, y), em);
            rule(at(spine, top), at(spine, bottom), em);
        } else if (svg_) {
            constexpr int kPieces = 12; // of an arc: no corner is seen
            std::vector<dvec2> arc;
            for (int i = 0; i <= kPieces; ++i) {
                const double t = 2.0 * i / kPieces - 1, bulge = 0.7 * (1 - t * t);
                arc.push_back(at(sign == '(' ? 0.9 - bulge : 0.1 + bulge, glm::mix(top, bottom, 0.5 * (t + 1))));
            }
            svg_->path(arc, false, "", {color_, std::max(1.0, kRuleWidth * em), false});
        }
        return width;
    }

    Extent fenced(const Node& node, dvec2 place, double em) {
        Extent inner = measured(node.children[0], em);
        inner.above = std::max(inner.above, kTall * em);
        inner.below = std::max(inner.below, kDeep * em);
        double x = fence(node.text.front(), place, inner, em);
        set(node.children[0], place + dvec2(x, 0), em);
        x += inner.width;
        x += fence(node.text.back(), place + dvec2(x, 0), inner, em);
        return {x, inner.above, inner.below};
    }

    Extent matrix(const Node& node, dvec2 place, double em) {
        const auto columns = static_cast<std::size_t>(node.columns), rows = node.children.size() / columns;
        std::vector<double> widths(columns), above(rows, kTall * em), below(rows, kMatrixRowDeep * em);
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            const Extent cell = measured(node.children[i], em);
            widths[i % columns] = std::max(widths[i % columns], cell.width);
            above[i / columns] = std::max(above[i / columns], cell.above);
            below[i / columns] = std::max(below[i / columns], cell.below);
        }
        double height = kMatrixLineGap * em * static_cast<double>(rows - 1),
               width = kMatrixGap * em * static_cast<double>(columns - 1);
        for (std::size_t r = 0; r < rows; ++r)
            height += above[r] + below[r];
        for (const double w : widths)
            width += w;
        const Extent inner{width, height / 2 + kAxis * em, height / 2 - kAxis * em};
        const double left = fence('[', place, inner, em) + kMatrixPad * em;
        double y = -inner.above;
        for (std::size_t r = 0; r < rows; ++r) {
            y += above[r];
            double x = left;
            for (std::size_t c = 0; c < columns; ++c) {
                const Node& cell = node.children[r * columns + c];
                set(cell, place + dvec2(x + (widths[c] - measured(cell, em).width) / 2, y), em);
                x += widths[c] + kMatrixGap * em;
            }
            y += below[r] + kMatrixLineGap * em;
        }
        const double right = left + width + kMatrixPad * em;
        return {right + fence(']', place + dvec2(right, 0), inner, em), inner.above, inner.below};
    }

    const FormulaFonts& fonts_;
    std::string color_;
    Drawing* svg_;
    bool hasRim_;
};

bool isEmpty(const Node& node) { return node.kind == Kind::row && node.children.empty(); }

std::string spokenOf(const Node& node) {
    const auto child = [&](std::size_t i) { return spokenOf(node.children[i]); };
    const auto scripts = [&](std::size_t low, std::size_t high) {
        const std::string raised = isEmpty(node.children[high]) ? "" : child(high);
        return (isEmpty(node.children[low]) ? "" : "_" + child(low)) +
               (raised.empty() ? "" : (raised.starts_with("′") ? "" : "^") + raised);
    };
    switch (node.kind) {
    case Kind::row: {
        std::string text;
        for (std::size_t i = 0; i < node.children.size(); ++i)
            text += child(i);
        return text;
    }
    case Kind::operation: return " " + node.text + " ";
    case Kind::mark: return node.text + " ";
    case Kind::space: return node.size < 1 ? "" : "  ";
    case Kind::scripts: return child(0) + scripts(1, 2);
    case Kind::large: return node.text + scripts(0, 1) + " ";
    case Kind::fraction: return "(" + child(0) + ") / (" + child(1) + ")";
    case Kind::root: return "√(" + child(0) + ")";
    case Kind::fenced: {
        const auto sign = [](char c) { return c == '.' ? std::string() : std::string(1, c); };
        return sign(node.text.front()) + child(0) + sign(node.text.back());
    }
    case Kind::matrix: {
        std::string text = "[";
        for (std::size_t i = 0; i < node.children.size(); ++i)
            text += (i == 0 ? "" : i % static_cast<std::size_t>(node.columns) == 0 ? "; " : ", ") + child(i);
        return text + "]";
    }
    default: return node.text;
    }
}

} // namespace

Formula::Formula(std::string_view tex) : root_(std::make_unique<Node>(parseFormula(tex))) {}
Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

Extent Formula::measure(double em, const FormulaFonts& fonts) const {
    return Setter(fonts, "", nullptr).set(*root_, {0, 0}, em);
}

Extent Formula::draw(Drawing& drawing, dvec2 place, double em, const std::string& color, const FormulaFonts& fonts, bool hasRim) const {
    return Setter(fonts, color, &drawing, hasRim).set(*root_, place, em);
}

std::string Formula::spoken() const { return spokenOf(*root_); }

} // namespace shadowlab::drawing
