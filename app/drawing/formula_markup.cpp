// Writes a formula as MathML Core (W3C, 2023), which browsers set themselves.
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "app/drawing/formula_tree.h"
#include "app/drawing/markup.h"

namespace shadowlab::drawing {

namespace {

using Node = Formula::Node;
using Kind = Node::Kind;

std::string element(const std::string& name, const std::string& content, const std::string& attributes = "") {
    return "<" + name + (attributes.empty() ? "" : " " + attributes) + ">" + content + "</" + name + ">";
}

std::string space(double em) {
    std::array<char, 32> width{}; // with a point in any language of the system
    const auto end = std::to_chars(width.data(), width.data() + width.size(), em, std::chars_format::fixed, 3).ptr;
    return "<mspace width=\"" + std::string(width.data(), end) + "em\"></mspace>";
}

/// Blanks at the ends of words count, which MathML leaves out.
std::string words(const std::string& text) {
    std::string kept;
    for (const char c : text)
        kept += c == ' ' ? "\u00a0" : std::string(1, c);
    return escapedMarkup(kept);
}

bool isNumber(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789.") == std::string::npos;
}

bool isMissing(const Node& node) { return node.kind == Kind::row && node.children.empty(); }

std::string markupOf(const Node& node);

/// Without an operator before it a sign belongs to what follows.
std::string rowMarkup(const Node& node) {
    std::string markup;
    const Node* before = nullptr;
    for (const Node& child : node.children) {
        const bool isSign = child.kind == Kind::operation &&
                            (!before || before->kind == Kind::operation || before->kind == Kind::opening ||
                             before->kind == Kind::mark || before->kind == Kind::space);
        markup += isSign ? element("mo", escapedMarkup(child.text), "form=\"prefix\" lspace=\"0\" rspace=\"0\"") : markupOf(child);
        before = &child;
    }
    return element("mrow", markup);
}

/// `below`, `above` and `both` are the names of the elements that put something there.
std::string scripted(const std::string& base, const Node& low, const Node& high, const std::array<const char*, 3>& names) {
    const auto [below, above, both] = names;
    if (isMissing(low) && isMissing(high)) return base;
    if (isMissing(high)) return element(below, base + markupOf(low));
    if (isMissing(low)) return element(above, base + markupOf(high));
    return element(both, base + markupOf(low) + markupOf(high));
}

std::string matrixMarkup(const Node& node) {
    std::string table, row;
    const auto columns = static_cast<std::size_t>(node.columns);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        row += element("mtd", markupOf(node.children[i]));
        if ((i + 1) % columns != 0) continue;
        table += element("mtr", row);
        row.clear();
    }
    return element("mrow", element("mo", "[") + element("mtable", table) + element("mo", "]"));
}

std::string fencedMarkup(const Node& node) {
    const auto fence = [](char sign, const char* form) {
        return sign == '.' ? std::string()
                           : element("mo", std::string(1, sign), "fence=\"true\" stretchy=\"true\" form=\"" + std::string(form) + "\"");
    };
    return element("mrow", fence(node.text.front(), "prefix") + markupOf(node.children[0]) + fence(node.text.back(), "postfix"));
}

std::string markupOf(const Node& node) {
    constexpr double kFunctionSpace = 1.0 / 6; // em, as formulas are drawn
    const std::string text = escapedMarkup(node.text);
    switch (node.kind) {
    case Kind::row: return rowMarkup(node);
    // Slanted by the page's style: the slanted letters that Unicode has of its own are in few of a phone's fonts.
    case Kind::variable: return element("mi", text, "mathvariant=\"normal\" class=\"variable\"");
    case Kind::bold: return element("mi", text, "mathvariant=\"normal\" class=\"vector\"");
    case Kind::function: return space(kFunctionSpace) + element("mi", text, "mathvariant=\"normal\"") + space(kFunctionSpace);
    case Kind::upright: return isNumber(node.text) ? element("mn", text) : element("mtext", words(node.text));
    case Kind::operation: return element("mo", text, "form=\"infix\"");
    case Kind::opening: return element("mtext", text);
    case Kind::mark: return element("mo", text, "separator=\"true\"");
    case Kind::space: return space(node.size);
    case Kind::large: {
        const std::string sign = element("mo", text, "largeop=\"true\"");
        return scripted(sign, node.children[0], node.children[1],
                        node.hasLimits ? std::array{"munder", "mover", "munderover"} : std::array{"msub", "msup", "msubsup"});
    }
    case Kind::scripts: {
        // What is lowered or raised stands beside the letters: the space around a function lies outside of both.
        const Node& base = node.children[0];
        const bool isFunction = base.kind == Kind::function;
        const std::string letters = isFunction ? element("mi", escapedMarkup(base.text), "mathvariant=\"normal\"") : markupOf(base);
        const std::string whole = scripted(letters, node.children[1], node.children[2], {"msub", "msup", "msubsup"});
        return isFunction ? space(kFunctionSpace) + whole + space(kFunctionSpace) : whole;
    }
    case Kind::fraction: return element("mfrac", markupOf(node.children[0]) + markupOf(node.children[1]));
    case Kind::root: return element("msqrt", markupOf(node.children[0]));
    case Kind::fenced: return fencedMarkup(node);
    case Kind::matrix: return matrixMarkup(node);
    }
    return "";
}

} // namespace

std::string Formula::mathML(bool isDisplayed) const {
    return element("math", markupOf(*root_), isDisplayed ? "display=\"block\"" : "");
}

} // namespace shadowlab::drawing
