// A deck as files in a folder: each slide as a picture, the page for a browser, the text for pandoc. What an interrupted run has drawn
// stands, and is not drawn again.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/explored_deck.h"
#include "app/cli/slides.h"
#include "app/course/deck.h"
#include "app/course/slides/pages.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::cli {

class DrawnDeck {
public:
    /// Refers to the options.
    DrawnDeck(course::Deck deck, const SlidesOptions& options);

    [[nodiscard]] const course::Deck& deck() const { return deck_; }
    /// Is the slide, or the lesson, of that name asked for?
    static bool isWanted(const SlidesOptions& options, const std::string& name);
    /// How many slides of this deck are asked for.
    [[nodiscard]] int slides() const;
    /// The pictures that are drawn for them: with --explore each state of a lab is one of its own.
    int countPictures();
    /// Throws Error (usage) where a slide or the page would be written over a file that was read.
    void keepInputs() const;

    /// `madeBy`: all that the slides of a run have in common, in words. `onPicture` is called with the number of pictures since the call
    /// before; it may throw. A slide that fails is told, and the others are drawn all the same. Needs a current GL context. Throws Error
    /// (cannotWrite), and what `onPicture` throws.
    void draw(course::SlidePainter& painter, const std::string& madeBy, const std::function<void(int)>& onPicture);
    /// What was kept for a next run is removed: that draws all slides again.
    void discardUnfinished() const;

    [[nodiscard]] int stood() const { return stood_; }            ///< slides that a run before this one has drawn
    [[nodiscard]] ExitStatus worst() const { return worst_; }     ///< of the first slide that failed

private:
    [[nodiscard]] bool isWanted(std::size_t slide) const { return isWanted(options_, deck_.slides()[slide]); }
    [[nodiscard]] std::string fileName(std::size_t slide) const;
    [[nodiscard]] std::string whereWrong(std::size_t slide, const std::string& what) const;
    course::PageSlide drawSlide(std::size_t number, course::SlidePainter& painter, const std::string& madeBy, const std::function<void()>& onState);
    void writePages(std::vector<course::PageSlide>& pages) const;

    course::Deck deck_;
    const SlidesOptions& options_;
    std::vector<int> states_;              ///< of each slide: how many states its lab has; 0: it is a picture
    std::unique_ptr<ExploredDeck> explored_; ///< with --explore
    int stood_ = 0;
    ExitStatus worst_ = ExitStatus::ok;
};

} // namespace shadowlab::cli
