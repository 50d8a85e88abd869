// SPDX-License-Identifier: MIT
#include "app/course/slides/pages.h"

namespace shadowlab::course {

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

std::string wordsOf(const Slide& slide) {
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

// Of LaTeX alone: two lines of caption have room below a picture, and are not numbered.
constexpr std::string_view kBeamer = R"(header-includes:
- |
  \setkeys{Gin}{width=\maxwidth,height=0.72\textheight,keepaspectratio}
  \setbeamertemplate{caption}{\raggedright\insertcaption\par}
  \setbeamerfont{caption}{size=\footnotesize}
)";
constexpr std::size_t kMostBeside = 240; ///< characters that pandoc's own slides have room for beside a picture

} // namespace

bool showsWordsAsPicture(const Slide& slide) {
    std::size_t length = 0;
    for (const std::string& paragraph : slide.text)
        length += paragraph.size();
    return !slide.formulas.empty() || !slide.pseudocode.empty() || (length > kMostBeside && !slide.pictures.empty());
}

std::string markdown(const Deck& deck, const std::vector<PageSlide>& slides) {
    std::string text = "---\ntitle: " + yamlText(deck.title()) + "\n";
    if (!deck.subtitle().empty()) text += "subtitle: " + yamlText(deck.subtitle()) + "\n";
    text += "slide-level: 1\naspectratio: 169\n" + std::string(kBeamer) + "---\n\n";
    for (const PageSlide& one : slides) {
        const Slide& slide = one.slide;
        text += "# " + plain(slide.title) + "\n\n";
        const bool isAllPicture = !one.wordsFile.empty();
        const std::string words = isAllPicture ? "" : wordsOf(slide);
        const std::string file = isAllPicture ? one.wordsFile : one.pictureFile;
        // Without a caption below it a picture is larger, as one with words in it has to be.
        const std::string caption = plain(slide.caption);
        const std::string picture = file.empty() ? "" : "![" + (isAllPicture ? "" : caption) + "](" + file + ")\n\n";
        if (!picture.empty() && !words.empty())
            text += ":::::: columns\n::: {.column width=\"62%\"}\n\n" + picture +
                    ":::\n::: {.column width=\"38%\"}\n\n" + words + ":::\n::::::\n\n";
        else
            text += picture + words;
        if (picture.empty() && !caption.empty()) text += caption + "\n\n";
        std::string spoken;
        for (const std::string& note : slide.notes)
            spoken += plain(note) + "\n\n";
        const std::string notes = spoken + (slide.alt.empty() ? "" : plain(slide.alt) + "\n\n") +
                                  (isAllPicture ? caption + "\n\n" + wordsOf(slide) : "");
        if (!notes.empty()) text += "::: notes\n" + notes + ":::\n\n";
    }
    return text;
}

} // namespace shadowlab::course
