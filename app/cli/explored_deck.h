// The explorable slides of one deck, one by one: each within its share of the page's size, with frame times that are measured once.
//
//     DIR/DECK.times.json     how long frames took, so that a page that is made again has the same bytes; delete it to measure anew
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "app/course/explore/explored_slide.h"

namespace shadowlab::cli {

class ExploredDeck {
public:
    /// `budgetBytes`: of all explorable slides of the deck together, of which there are `slides`.
    ExploredDeck(const std::filesystem::path& folder, const std::string& deck, std::size_t budgetBytes, int slides, int supersample);

    /// The slide's elements for the page. `onState` as in course::ExploreRequest. Throws Error (overLimit) where the slide does not fit, and
    /// all that course::exploredSlide() throws; Error (cannotWrite).
    std::string elementsOf(const course::Slide& slide, const std::function<void()>& onState);
    /// The same for a slide that stands from an earlier run: it takes its share, too.
    void countStanding(std::size_t bytes);

private:
    void readTimes();
    void writeTimes() const;

    std::filesystem::path timesFile_;
    std::size_t equalBytes_; ///< of each slide, if all took the same
    std::size_t bytesLeft_;
    int slidesLeft_;
    int supersample_;
    image::Font font_, bold_;
    course::FrameTimes times_;
    bool isForeign_ = false; ///< another program's file is in the place of ours
};

} // namespace shadowlab::cli
