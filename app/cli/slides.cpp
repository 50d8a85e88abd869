// `shadowlab slides`: decks as pictures, as a page for a browser, and as a text for pandoc.
// SPDX-License-Identifier: MIT
#include "app/cli/slides.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/explored_deck.h"
#include "app/cli/lessons_page.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/course/explore/explore_budget.h"
#include "app/course/explore/explore_page.h"
#include "app/course/slides/pages.h"
#include "app/course/slides/unfinished.h"
#include "app/picture/digest.h"
#include "app/picture/limits.h"
#include "app/student/program_digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/image/webp/webp.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::cli {

namespace {

void describeSlides(DescribedOptions& add) {
    add.arguments("DECK",
                  "a built-in name (`list decks`), lessons for the page of all lessons, or a .json deck; may be repeated (default: all "
                  "built-in decks, with --explore also lessons)");
    add.option("-o,--output", "DIR", "the folder that the slides are written into; it is made where there is none");
    add.option("--only", "SLIDE", "draws that slide alone, and no page of all; several with commas between them; of lessons, a page of those alone");
    add.option("--size", "WxH", "width and height of the slides in pixels (default 1920x1080; 4K is 3840x2160)");
    add.option("--supersample", "N", "N x N samples for each pixel of a picture, from 1 to 8 (default 2)");
    add.flag("--explore",
             "slides that a deck calls explorable become labs in its page: a lamp to drag, a split line, steps, settings with their "
             "errors, pixels to ask");
    add.option("--explore-budget", "MB",
               "what the labs of a page take at most (default 14): fewer positions of the lamp and smaller pictures are chosen to fit");
    describeBackend(add);
    add.option("--allow", "DIR", "a further folder that the decks' scenes may take meshes from; may be repeated");
    add.footer(
        "For each deck: DECK-01-NAME.png ..., the same without words as pictures/DECK-01-NAME.png, DECK.html for "
        "a browser, and DECK.md for pandoc. Interrupted, the same command goes on where it was. The page of lessons is\n"
        "one file, lessons.html: pictures with a fault, a question, the answer, and the remedy.\n"
        "Examples:\n"
        "  shadowlab slides -o out\n"
        "  shadowlab slides my-deck.json -o out --size 3840x2160\n"
        "  shadowlab slides lessons -o out\n"
        "  cd out && pandoc shadow-rendering-techniques.md -o lecture.pptx");
}

SlidesOptions slidesOptions(const GivenOptions& given) {
    SlidesOptions options;
    options.decks = given.texts("DECK");
    options.allDecks = options.decks.empty();
    options.output = given.required("--output", "shadowlab slides -o DIR");
    options.only = splitAtCommas(given.texts("--only"));
    options.look.size = sizeFrom("--size", given.text("--size", "1920x1080"), "picture-side");
    constexpr int kLeastHeight = 360;                 // below, type dissolves
    constexpr double kNarrowest = 1.2, kWidest = 2.5; // shapes that slides are laid out for
    options.explores = given.has("--explore") || given.has("--explore-budget");
    options.exploreBytes = megabytesFrom("--explore-budget", given.text("--explore-budget", "14"));
    options.lessons = std::erase(options.decks, kLessonsPage) > 0 || (options.allDecks && options.explores && options.only.empty());
    const double aspect = static_cast<double>(options.look.size.x) / options.look.size.y;
    if (options.look.size.y < kLeastHeight || aspect < kNarrowest || aspect > kWidest)
        refuseUsage(
            "--size: slides are at least 360 pixels high and 1.2 to 2.5 times as wide; write for example 1920x1080");
    constexpr int kMostSamples = 8;
    options.look.supersample = countFrom("--supersample", given.text("--supersample", "2"), kMostSamples);
    const std::uint64_t samplesOnASide = static_cast<std::uint64_t>(options.look.supersample);
    picture::reserveForPictures(static_cast<std::uint64_t>(options.look.size.x) * samplesOnASide *
                                    static_cast<std::uint64_t>(options.look.size.y) * samplesOnASide,
                                picture::kBytesPerDrawnSample, "--size " + given.text("--size", "1920x1080"),
                                "choose a smaller --size or --supersample");
    options.backend = backendFrom(given);
    options.allowed = given.allowedFolders();
    return options;
}

using course::Deck;

constexpr std::uint64_t kLargestElements = 1 << 16; ///< bytes beside the pieces: what the elements of a lab have around them

void makeFolder(const std::filesystem::path& folder) {
    image::makeFolders(folder);
    image::probeWritable(folder / "slide.png");
}

/// "07-silhouettes"
std::string numbered(const Deck& deck, std::size_t slide) {
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "%02zu-", slide + 1);
    return number.data() + deck.slides()[slide];
}

class Slides {
public:
    explicit Slides(const SlidesOptions& options) : options_(options) {}

    int run() {
        openDecks();
        context_ = context::createContext(options_.backend); // before the folders: without graphics none is left behind
        std::error_code ignored;
        const std::filesystem::path folders[] = {options_.output / "pictures", options_.output};
        const bool were[] = {std::filesystem::exists(folders[0], ignored),
                             std::filesystem::exists(folders[1], ignored)};
        makeFolder(folders[1]);
        if (!decks_.empty()) makeFolder(folders[0]);
        makePainter();
        countStates();
        progress_.emplace(options_.explores ? "picture" : "slide", total_, Progress::Remaining::told);
        try {
            for (Deck& deck : decks_)
                draw(deck);
        } catch (const context::Interrupted&) {
            note("interrupted; the same command goes on from here");
            throw;
        }
        progress_.reset();
        if (!lessons_.empty()) writeLessonsPage(options_.output, lessons_); // interrupted, it begins again, and the decks stand
        comeToTheEnd();
        for (const int i : {0, 1}) // a folder that is still empty is removed again
            if (!were[i] && std::filesystem::exists(folders[i], ignored) && std::filesystem::is_empty(folders[i], ignored))
                std::filesystem::remove(folders[i], ignored);
        return static_cast<int>(worst_);
    }

private:
    void openDecks() {
        const scene::LoadOptions loading = loadOptions(options_.allowed);
        const std::vector<std::string> names = options_.allDecks ? course::builtInDecks(loading.assetsRoot) : options_.decks;
        if (options_.lessons) lessons_ = lessonNames();
        for (const std::string& name : names) {
            Deck deck(name, loading);
            image::keepInput(deck.file());
            if (std::ranges::find(decks_, deck.name(), &Deck::name) != decks_.end())
                throw Error(ExitStatus::usage, "two of the decks are called '" + scene::shown(deck.name()) +
                                                   "', and so would be their slides; draw them into two folders");
            if (options_.lessons && deck.name() == kLessonsPage)
                throw Error(ExitStatus::usage, scene::shownPath(deck.file()) + ": its page would be lessons.html, as that of all lessons; write them "
                                                                               "into two folders");
            decks_.push_back(std::move(deck));
        }
        checkOnly();
        std::erase_if(lessons_, [this](const std::string& lesson) { return !isWanted(lesson); });
        if (!lessons_.empty()) image::requireNoInput(options_.output / (std::string(kLessonsPage) + ".html"));
        for (const Deck& deck : decks_) {
            for (std::size_t i = 0; i < deck.slides().size(); ++i)
                image::requireNoInput(options_.output / (deck.name() + "-" + numbered(deck, i) + ".png"));
            for (const char* ending : {".html", ".md"})
                image::requireNoInput(options_.output / (deck.name() + ending));
        }
        for (const Deck& deck : decks_)
            for (const std::string& slide : deck.slides())
                total_ += isWanted(slide);
    }

    /// Of explorable slides every state is a picture of its own. One that cannot be read says so when its turn comes.
    void countStates() {
        slides_ = total_;
        if (!options_.explores) return;
        for (Deck& deck : decks_) {
            std::vector<int>& states = states_.emplace_back(deck.slides().size());
            for (std::size_t i = 0; i < deck.slides().size(); ++i) {
                if (!isWanted(deck.slides()[i])) continue;
                try {
                    const course::Slide slide = deck.read(i);
                    if (slide.explore) states[i] = course::exploredStates(slide, *slide.explore, course::askedSize(*slide.explore));
                } catch (const Error&) {
                    continue;
                }
                total_ += states[i];
            }
        }
    }

    void makePainter() {
        const course::SlideLook& look = options_.look;
        if (const int limit = context::largestSide(); std::max(look.size.x, look.size.y) * look.supersample > limit)
            throw Error(ExitStatus::overLimit, "a picture needs more samples on a side than the " +
                                                   std::to_string(limit) +
                                                   " of this OpenGL driver; choose a smaller --size or --supersample");
        painter_ = std::make_unique<course::SlidePainter>(context::assetsRoot() / "fonts", look);
        madeBy_ = student::programDigest() + context::glVersion() + context::glRenderer() +
                  std::to_string(look.size.x) + "x" + std::to_string(look.size.y) + " by " +
                  std::to_string(look.supersample) + (options_.explores ? " " + std::to_string(options_.exploreBytes) : "");
    }

    /// The next run draws all slides again.
    void comeToTheEnd() {
        for (const Deck& deck : decks_) {
            const course::Unfinished unfinished(options_.output, deck.name());
            if (options_.only.empty()) unfinished.discardAll();
            std::vector<std::string> drawn;
            for (std::size_t i = 0; i < deck.slides().size(); ++i)
                if (isWanted(deck.slides()[i])) drawn.push_back(numbered(deck, i));
            unfinished.discard(drawn);
            std::error_code ignored;
            if (options_.explores)
                for (std::size_t i = 0; i < deck.slides().size(); ++i)
                    std::filesystem::remove(options_.output / exploredFile(deck.name() + "-" + numbered(deck, i)), ignored);
        }
        if (stood_ > 0)
            note(std::to_string(stood_) + " of " + std::to_string(slides_) +
                 " slides were there already, from a run that did not come to its end");
    }

    [[nodiscard]] bool isWanted(const std::string& slide) const {
        return options_.only.empty() || std::ranges::find(options_.only, slide) != options_.only.end();
    }

    void checkOnly() const {
        std::vector<std::string> known;
        for (const Deck& deck : decks_)
            known.insert(known.end(), deck.slides().begin(), deck.slides().end());
        known.insert(known.end(), lessons_.begin(), lessons_.end());
        const std::string what = lessons_.empty() ? "slide" : decks_.empty() ? "lesson" : "slide or lesson";
        for (const std::string& name : options_.only)
            if (std::ranges::find(known, name) == known.end())
                throw Error(ExitStatus::usage,
                            "--only: no " + what + " is called '" + scene::shown(name) + "'; " + suggestion(name, known));
    }

    void draw(Deck& deck) {
        if (const course::Unfinished unfinished(options_.output, deck.name()); unfinished.isForeign())
            note(scene::shownPath(unfinished.file()) +
                 ": is none of ours, so an interrupted run would begin again; move it away");
        std::vector<course::PageSlide> pages;
        const auto number = static_cast<std::size_t>(&deck - decks_.data());
        if (options_.explores)
            explored_.emplace(options_.output, deck.name(), options_.exploreBytes,
                              static_cast<int>(std::ranges::count_if(states_[number], [](int states) { return states > 0; })),
                              options_.look.supersample);
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            if (!isWanted(deck.slides()[i])) continue;
            context::throwIfInterrupted();
            const int before = done_;
            try {
                pages.push_back(draw(deck, i));
            } catch (const Error& error) {
                if (error.status() == ExitStatus::cannotWrite) throw; // the next would fail as well
                complain(place(deck, i, error.what()));
                if (worst_ == ExitStatus::ok) worst_ = error.status();
            }
            done_ = before + 1 + (options_.explores ? states_[number][i] : 0); // whatever of it was drawn, or stood already
            progress_->done(done_);
        }
        if (!options_.only.empty() || pages.empty()) return;
        const double aspect = static_cast<double>(options_.look.size.x) / options_.look.size.y;
        if (options_.explores)
            for (course::PageSlide& page : pages)
                page.webp = smallStill(page);
        image::writeWhole(options_.output / (deck.name() + ".html"), course::htmlPage(deck, pages, aspect, exploreCode(pages)));
        image::writeWhole(options_.output / (deck.name() + ".md"), course::markdown(deck, pages));
    }

    /// A page of labs is sent to phones: its stills are WebP. Drawings and words alone lose nothing.
    static std::vector<std::uint8_t> smallStill(const course::PageSlide& page) {
        const image::Image still = image::decodePng(page.png, page.slide.name).image;
        const bool isDrawn = std::ranges::all_of(page.slide.pictures, [](const course::SlidePicture& one) { return !one.figure.empty(); });
        return image::encodeWebp(still, isDrawn ? image::WebpKind::exact : image::WebpKind::letters);
    }

    static course::ExploreCode exploreCode(const std::vector<course::PageSlide>& pages) {
        const bool isNeeded = std::ranges::any_of(pages, [](const course::PageSlide& page) { return !page.explored.empty(); });
        return isNeeded ? course::exploreCode(context::assetsRoot()) : course::ExploreCode();
    }

    /// What is wrong with a slide, naming it; what the file's readers say names file and line already.
    static std::string place(const Deck& deck, std::size_t slide, const std::string& what) {
        const std::string file = scene::shownPath(deck.file());
        const std::string which = "slide '" + deck.slides()[slide] + "': ";
        if (what.starts_with(file + ":")) return what + " (slide '" + deck.slides()[slide] + "')";
        return file + ": " + which + what;
    }

    course::PageSlide draw(Deck& deck, std::size_t number) {
        course::PageSlide page{deck.read(number), {}, {}, "", ""};
        const std::string name = deck.name() + "-" + numbered(deck, number);
        course::SlideFiles files{name + ".png"};
        if (!page.slide.pictures.empty()) files.emplace_back(page.pictureFile = "pictures/" + name + ".png");
        if (course::showsWordsAsPicture(page.slide))
            files.emplace_back(page.wordsFile = "pictures/" + name + "-with-words.png");
        const bool isExplored = options_.explores && page.slide.explore;
        if (isExplored) files.emplace_back(exploredFile(name)); // last
        const course::Unfinished unfinished(options_.output, deck.name());
        const std::string from = madeFrom(deck, page.slide);
        if (std::optional<course::StandingSlide> standing = unfinished.find(numbered(deck, number), from, files)) {
            page.png = std::move(standing->png);
            page.picturesAt = standing->picturesAt;
            if (isExplored) {
                page.explored = scene::readFile(options_.output / files.back(), options_.exploreBytes + kLargestElements);
                explored_->countStanding(page.explored.size());
            }
            ++stood_;
            return page;
        }
        const course::DrawnSlide drawn = painter_->draw(page.slide, {deck.title(), number + 1, deck.slides().size()});
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
            page.explored = explored_->elementsOf(page.slide, [this] {
                context::throwIfInterrupted();
                progress_->done(++done_);
            });
            image::writeWhole(options_.output / files.back(), page.explored);
            digests.push_back(picture::digestOf(page.explored));
        }
        unfinished.keep(numbered(deck, number), from, digests, page.picturesAt); // last: with it the slide stands
        return page;
    }

    /// Kept until all is drawn: the page holds it then.
    static std::string exploredFile(const std::string& slide) { return slide + ".explored.html"; }

    /// A digest of all that the slide's files depend on.
    [[nodiscard]] std::string madeFrom(const Deck& deck, const course::Slide& slide) const {
        std::string all = madeBy_ + deck.text();
        for (const course::SlidePicture& picture : slide.pictures)
            all += picture::digestOf(*picture.state.scene);
        return picture::digestOf(all);
    }

    const SlidesOptions& options_;
    std::vector<Deck> decks_;
    std::vector<std::string> lessons_; ///< names of those that are in the page of lessons
    std::string madeBy_; ///< what all slides have in common
    std::unique_ptr<context::Context> context_;
    std::unique_ptr<course::SlidePainter> painter_;
    std::optional<Progress> progress_;
    std::optional<ExploredDeck> explored_; ///< of the deck that is drawn now
    std::vector<std::vector<int>> states_; ///< of each deck's slides: how many states a lab has; 0: it is a picture
    int slides_ = 0;                    ///< that are asked for
    int total_ = 0, done_ = 0;          ///< pictures: slides and states; so far
    int stood_ = 0;                     ///< slides that a run before this one has drawn
    ExitStatus worst_ = ExitStatus::ok; ///< of the first slide that failed
};

Work slidesWork(const GivenOptions& given) {
    return [options = slidesOptions(given)] { return slides(options); };
}

} // namespace

int slides(const SlidesOptions& options) { return Slides(options).run(); }

const Command kSlides{"slides", "[DECK...]", "A deck as pictures, as a page for a browser, and as a text for pandoc",
                      describeSlides, slidesWork};

} // namespace shadowlab::cli
