// A deck's slides as one page for a browser, and as a text for pandoc.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/course/explore/explore_page.h"
#include "app/drawing/labels.h"

namespace shadowlab::course {

/// A slide that was drawn.
struct PageSlide {
    Slide slide;
    std::vector<std::uint8_t> png; ///< of the whole slide
    drawing::Box picturesAt;       ///< where on it its pictures are, in shares of it; empty: it has none
    std::string pictureFile;       ///< of its pictures alone, beside the page; empty: it has none
    std::string wordsFile;         ///< of its pictures with the words beside them, where showsWordsAsPicture()
    std::vector<std::uint8_t> webp{}; ///< the same slide for a page that has to be small; empty: the page takes `png`
    std::string explored{};        ///< elements of the page that make a lab of it (explore/explore_page.h); empty: it is a picture
};

/// Presentation programs set words too large to stand beside a picture, and not all of them set formulas: where a slide has many
/// words, formulas or pseudocode, Markdown shows them as they are drawn.
bool showsWordsAsPicture(const Slide& slide);

/// One HTML page that needs nothing else: keys, captions, descriptions, an overview, and one slide on each printed page. On a phone a
/// slide is its title, its pictures cut out of it, and its words and formulas as text. `aspect`: a slide's width by its height. `code`: for
/// slides that are explored, if there are any.
std::string htmlPage(const Deck& deck, const std::vector<PageSlide>& slides, double aspect, const ExploreCode& code = {});

/// Markdown that pandoc turns into PPTX or Beamer: headings, pictures, captions; descriptions as notes, with the
/// formulas as TeX.
std::string markdown(const Deck& deck, const std::vector<PageSlide>& slides);

} // namespace shadowlab::course
