// SPDX-License-Identifier: MIT
#include "app/cli/drawn_deck.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include "app/cli/messages.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/explore/explore_budget.h"
#include "app/course/explore/explore_page.h"
#include "app/course/slides/unfinished.h"
#include "app/picture/digest.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/image/webp/webp.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

constexpr std::uint64_t kLargestElements = 1 << 16; ///< bytes beside the pieces: what the elements of a lab have around them

/// "07-silhouettes"
std::string numbered(const course::Deck& deck, std::size_t slide) {
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "%02zu-", slide + 1);
    return number.data() + deck.slides()[slide];
}

/// Kept until all is drawn: the page holds it then.
std::string exploredFile(const std::string& slide) { return slide + ".explored.html"; }

/// A page of labs is sent to phones: its stills are WebP. Drawings and words alone lose nothing.
std::vector<std::uint8_t> smallStill(const course::PageSlide& page) {
    const image::Image still = image::decodePng(page.png, page.slide.name).image;
    const bool isDrawn = std::ranges::all_of(page.slide.pictures, [](const course::SlidePicture& one) { return !one.figure.empty(); });
    return image::encodeWebp(still, isDrawn ? image::WebpKind::exact : image::WebpKind::letters);
}

course::ExploreCode codeFor(const std::vector<course::PageSlide>& pages) {
    const bool isNeeded = std::ranges::any_of(pages, [](const course::PageSlide& page) { return !page.explored.empty(); });
    return isNeeded ? course::exploreCode(context::assetsRoot()) : course::ExploreCode();
}

/// A digest of all that the slide's files depend on.
std::string madeFrom(const std::string& madeBy, const course::Deck& deck, const course::Slide& slide) {
    std::string all = madeBy + deck.text();
    for (const course::SlidePicture& picture : slide.pictures)
        all += picture::digestOf(*picture.state.scene);
    return picture::digestOf(all);
}

} // namespace

DrawnDeck::DrawnDeck(course::Deck deck, const SlidesOptions& options)
    : deck_(std::move(deck)), options_(options), states_(deck_.slides().size()) {}

bool DrawnDeck::isWanted(const SlidesOptions& options, const std::string& name) {
    return options.only.empty() || std::ranges::find(options.only, name) != options.only.end();
}

int DrawnDeck::slides() const {
    return static_cast<int>(std::ranges::count_if(deck_.slides(), [this](const std::string& slide) { return isWanted(options_, slide); }));
}

int DrawnDeck::countPictures() {
    int pictures = slides();
    for (std::size_t i = 0; options_.explores && i < states_.size(); ++i) {
        try {
            const course::Slide slide = deck_.read(i);
            if (slide.explore) states_[i] = course::exploredStates(slide, *slide.explore, course::askedSize(*slide.explore));
        } catch (const Error&) { // said when the slide's turn comes
            continue;
        }
        pictures += states_[i];
    }
    return pictures;
}

std::string DrawnDeck::fileName(std::size_t slide) const { return deck_.name() + "-" + numbered(deck_, slide); }

void DrawnDeck::keepInputs() const {
    for (std::size_t i = 0; i < deck_.slides().size(); ++i)
        image::requireNoInput(options_.output / (fileName(i) + ".png"));
    for (const char* ending : {".html", ".md"})
        image::requireNoInput(options_.output / (deck_.name() + ending));
}

void DrawnDeck::draw(course::SlidePainter& painter, const std::string& madeBy, const std::function<void(int)>& onPicture) {
    if (const course::Unfinished unfinished(options_.output, deck_.name()); unfinished.isForeign())
        note(scene::shownPath(unfinished.file()) + ": is none of ours, so an interrupted run would begin again; move it away");
    const auto labs = static_cast<int>(std::ranges::count_if(states_, [](int states) { return states > 0; }));
    if (options_.explores)
        explored_ = std::make_unique<ExploredDeck>(options_.output, deck_.name(), options_.exploreBytes, labs, options_.look.supersample);
    std::vector<course::PageSlide> pages;
    for (std::size_t i = 0; i < deck_.slides().size(); ++i) {
        if (!isWanted(i)) continue;
        context::throwIfInterrupted();
        int drawn = 0; // states of this slide
        try {
            pages.push_back(drawSlide(i, painter, madeBy, [&] { onPicture(1), ++drawn; }));
        } catch (const Error& error) {
            if (error.status() == ExitStatus::cannotWrite) throw; // the next would fail as well
            complain(whereWrong(i, error.what()));
            if (worst_ == ExitStatus::ok) worst_ = error.status();
        }
        onPicture(1 + states_[i] - drawn); // whatever of it was drawn, or stood already
    }
    if (options_.only.empty() && !pages.empty()) writePages(pages);
}

void DrawnDeck::writePages(std::vector<course::PageSlide>& pages) const {
    if (options_.explores)
        for (course::PageSlide& page : pages)
            page.webp = smallStill(page);
    const double aspect = static_cast<double>(options_.look.size.x) / options_.look.size.y;
    image::writeWhole(options_.output / (deck_.name() + ".html"), course::htmlPage(deck_, pages, aspect, codeFor(pages)));
    image::writeWhole(options_.output / (deck_.name() + ".md"), course::markdown(deck_, pages));
}

/// What is wrong with a slide, naming it; what the file's readers say names file and line already.
std::string DrawnDeck::whereWrong(std::size_t slide, const std::string& what) const {
    const std::string file = scene::shownPath(deck_.file()), name = "slide '" + deck_.slides()[slide] + "'";
    if (what.starts_with(file + ":")) return what + " (" + name + ")";
    return file + ": " + name + ": " + what;
}

course::PageSlide DrawnDeck::drawSlide(std::size_t number, course::SlidePainter& painter, const std::string& madeBy,
                                       const std::function<void()>& onState) {
    course::PageSlide page{deck_.read(number), {}, {}, "", ""};
    const std::string name = fileName(number);
    course::SlideFiles files{name + ".png"};
    if (!page.slide.pictures.empty()) files.emplace_back(page.pictureFile = "pictures/" + name + ".png");
    if (course::showsWordsAsPicture(page.slide)) files.emplace_back(page.wordsFile = "pictures/" + name + "-with-words.png");
    const bool isExplored = options_.explores && page.slide.explore;
    if (isExplored) files.emplace_back(exploredFile(name)); // last
    const course::Unfinished unfinished(options_.output, deck_.name());
    const std::string from = madeFrom(madeBy, deck_, page.slide);
    if (std::optional<course::StandingSlide> standing = unfinished.find(numbered(deck_, number), from, files)) {
        page.png = std::move(standing->png);
        page.picturesAt = standing->picturesAt;
        if (isExplored) {
            page.explored = scene::readFile(options_.output / files.back(), options_.exploreBytes + kLargestElements);
            explored_->countStanding(page.explored.size());
        }
        ++stood_;
        return page;
    }
    const course::DrawnSlide drawn = painter.draw(page.slide, {deck_.title(), number + 1, deck_.slides().size()});
    std::vector<image::PngText> text{{"Title", page.slide.title}};
    if (!page.slide.alt.empty()) text.push_back({"Description", page.slide.alt});
    std::vector<std::string> digests;
    const auto write = [&](const std::string& file, const image::Image& picture) {
        std::vector<std::uint8_t> png = image::encodePng(picture, {.opaque = true, .text = text});
        image::writeWhole(options_.output / file, png);
        digests.push_back(picture::digestOf(png));
        return png;
    };
    page.png = write(name + ".png", drawn.slide);
    page.picturesAt = drawn.picturesAt;
    if (!page.pictureFile.empty()) write(page.pictureFile, drawn.pictures);
    if (!page.wordsFile.empty()) write(page.wordsFile, drawn.content);
    if (isExplored) {
        page.explored = explored_->elementsOf(page.slide, onState);
        image::writeWhole(options_.output / files.back(), page.explored);
        digests.push_back(picture::digestOf(page.explored));
    }
    unfinished.keep(numbered(deck_, number), from, digests, page.picturesAt); // last: with it the slide stands
    return page;
}

void DrawnDeck::discardUnfinished() const {
    const course::Unfinished unfinished(options_.output, deck_.name());
    if (options_.only.empty()) unfinished.discardAll();
    std::vector<std::string> drawn;
    for (std::size_t i = 0; i < deck_.slides().size(); ++i)
        if (isWanted(i)) drawn.push_back(numbered(deck_, i));
    unfinished.discard(drawn);
    std::error_code ignored;
    for (std::size_t i = 0; options_.explores && i < deck_.slides().size(); ++i)
        std::filesystem::remove(options_.output / exploredFile(fileName(i)), ignored);
}

} // namespace shadowlab::cli
