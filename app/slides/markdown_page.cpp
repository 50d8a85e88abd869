// SPDX-License-Identifier: MIT
#include "app/slides/pages.h"

namespace shadowlab::slides {

namespace {

/// Text in which nothing is taken for a sign of Markdown's.
std::string plain(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("\\`*_{}[]()#+-.!|<>$~^'\"@").find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

/// In YAML: between double quotes.
std::string yamlText(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string wordsOf(const session::Slide& slide) {
    std::string text;
    for (const std::string& paragraph : slide.text)
        text += plain(paragraph) + "\n\n";
    for (const std::string& tex : slide.formulas)
        text += "$$" + tex + "$$\n\n";
    if (!slide.pseudocode.empty()) {
        for (const std::string& line : slide.pseudocode)
            text += "    " + line + "\n";
        text += "\n";
    }
    return text;
}

} // namespace

std::string markdown(const session::Deck& deck, const std::vector<PageSlide>& slides) {
    std::string text = "---\ntitle: " + yamlText(deck.title()) + "\n";
    if (!deck.subtitle().empty()) text += "subtitle: " + yamlText(deck.subtitle()) + "\n";
    text += "slide-level: 1\naspectratio: 169\n---\n\n";
    for (const PageSlide& one : slides) {
        const session::Slide& slide = one.slide;
        text += "# " + plain(slide.title) + "\n\n";
        const std::string words = wordsOf(slide);
        const std::string picture =
            one.pictureFile.empty() ? "" : "![" + plain(slide.caption) + "](" + one.pictureFile + ")\n\n";
        if (!picture.empty() && !words.empty())
            text += ":::::: columns\n::: {.column width=\"62%\"}\n\n" + picture +
                    ":::\n::: {.column width=\"38%\"}\n\n" + words + ":::\n::::::\n\n";
        else
            text += picture + words;
        if (picture.empty() && !slide.caption.empty()) text += plain(slide.caption) + "\n\n";
        if (!slide.alt.empty()) text += "::: notes\n" + plain(slide.alt) + "\n:::\n\n";
    }
    return text;
}

} // namespace shadowlab::slides
