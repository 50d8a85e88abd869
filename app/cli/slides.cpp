// `shadowlab slides`: decks as pictures, as a page for a browser, and as a text for pandoc.
// SPDX-License-Identifier: MIT
#include "app/cli/slides.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/drawn_deck.h"
#include "app/cli/lessons_page.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "app/context/assets.h"
#include "app/context/signals.h"
#include "app/picture/limits.h"
#include "app/student/program_digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
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
             "errors, pixels to ask; of whole decks, so not with --only");
    add.option("--explore-budget", "MB",
               "what the labs of a page take at most (default 15): fewer positions of the lamp and smaller pictures are chosen to fit");
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
    options.exploreBytes = megabytesFrom("--explore-budget", given.text("--explore-budget", "15"));
    if (options.explores && !options.only.empty())
        refuseUsage("--explore: labs are in the page of a whole deck, and with --only none is written; leave one of the two out");
    options.lessons = std::erase(options.decks, kLessonsPage) > 0 || (options.allDecks && options.explores);
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

void makeFolder(const std::filesystem::path& folder) {
    image::makeFolders(folder);
    image::probeWritable(folder / "slide.png");
}

class Slides {
public:
    explicit Slides(const SlidesOptions& options) : options_(options) {}

    int run() {
        openDecks();
        const std::unique_ptr<context::Context> context = context::createContext(options_.backend); // without graphics no folder is left behind
        std::error_code ignored;
        const std::filesystem::path folders[] = {options_.output / "pictures", options_.output};
        const bool were[] = {std::filesystem::exists(folders[0], ignored), std::filesystem::exists(folders[1], ignored)};
        makeFolder(folders[1]);
        if (!decks_.empty()) makeFolder(folders[0]);
        drawDecks();
        if (!lessons_.empty()) writeLessonsPage(options_.output, lessons_); // interrupted, it begins again, and the decks stand
        comeToTheEnd();
        for (const int i : {0, 1}) // a folder that is still empty is removed again
            if (!were[i] && std::filesystem::exists(folders[i], ignored) && std::filesystem::is_empty(folders[i], ignored))
                std::filesystem::remove(folders[i], ignored);
        const auto failed = std::ranges::find_if(decks_, [](const DrawnDeck& deck) { return deck.worst() != ExitStatus::ok; });
        return static_cast<int>(failed == decks_.end() ? ExitStatus::ok : failed->worst());
    }

private:
    void openDecks() {
        const scene::LoadOptions loading = loadOptions(options_.allowed);
        const std::vector<std::string> names = options_.allDecks ? course::builtInDecks(loading.assetsRoot) : options_.decks;
        if (options_.lessons) lessons_ = lessonNames();
        for (const std::string& name : names) {
            course::Deck deck(name, loading);
            image::keepInput(deck.file());
            if (std::ranges::any_of(decks_, [&](const DrawnDeck& other) { return other.deck().name() == deck.name(); }))
                throw Error(ExitStatus::usage, "two of the decks are called '" + scene::shown(deck.name()) +
                                                   "', and so would be their slides; draw them into two folders");
            if (options_.lessons && deck.name() == kLessonsPage)
                throw Error(ExitStatus::usage, scene::shownPath(deck.file()) + ": its page would be lessons.html, as that of all lessons; write them "
                                                                               "into two folders");
            decks_.emplace_back(std::move(deck), options_);
        }
        checkOnly();
        std::erase_if(lessons_, [this](const std::string& lesson) { return !DrawnDeck::isWanted(options_, lesson); });
        if (!lessons_.empty()) image::requireNoInput(options_.output / (std::string(kLessonsPage) + ".html"));
        for (const DrawnDeck& deck : decks_)
            deck.keepInputs();
    }

    void checkOnly() const {
        std::vector<std::string> known;
        for (const DrawnDeck& deck : decks_)
            known.insert(known.end(), deck.deck().slides().begin(), deck.deck().slides().end());
        known.insert(known.end(), lessons_.begin(), lessons_.end());
        const std::string what = lessons_.empty() ? "slide" : decks_.empty() ? "lesson" : "slide or lesson";
        for (const std::string& name : options_.only)
            if (std::ranges::find(known, name) == known.end())
                throw Error(ExitStatus::usage,
                            "--only: no " + what + " is called '" + scene::shown(name) + "'; " + suggestion(name, known));
    }

    void drawDecks() {
        const course::SlideLook& look = options_.look;
        if (const int limit = context::largestSide(); std::max(look.size.x, look.size.y) * look.supersample > limit)
            throw Error(ExitStatus::overLimit, "a picture needs more samples on a side than the " + std::to_string(limit) +
                                                   " of this OpenGL driver; choose a smaller --size or --supersample");
        course::SlidePainter painter(context::assetsRoot() / "fonts", look);
        const std::string madeBy = student::programDigest() + context::glVersion() + context::glRenderer() + std::to_string(look.size.x) + "x" +
                                   std::to_string(look.size.y) + " by " + std::to_string(look.supersample) +
                                   (options_.explores ? " " + std::to_string(options_.exploreBytes) : "");
        int all = 0, done = 0;
        for (DrawnDeck& deck : decks_)
            all += deck.countPictures();
        Progress progress(options_.explores ? "picture" : "slide", all, Progress::Remaining::told);
        try {
            for (DrawnDeck& deck : decks_)
                deck.draw(painter, madeBy, [&](int pictures) {
                    context::throwIfInterrupted();
                    progress.done(done += pictures);
                });
        } catch (const context::Interrupted&) {
            note("interrupted; the same command goes on from here");
            throw;
        }
    }

    void comeToTheEnd() const {
        int stood = 0, slides = 0;
        for (const DrawnDeck& deck : decks_) {
            deck.discardUnfinished();
            stood += deck.stood();
            slides += deck.slides();
        }
        if (stood > 0)
            note(std::to_string(stood) + " of " + std::to_string(slides) +
                 " slides were there already, from a run that did not come to its end");
    }

    const SlidesOptions& options_;
    std::vector<DrawnDeck> decks_;
    std::vector<std::string> lessons_; ///< names of those that are in the page of lessons
};

Work slidesWork(const GivenOptions& given) {
    return [options = slidesOptions(given)] { return slides(options); };
}

} // namespace

int slides(const SlidesOptions& options) { return Slides(options).run(); }

const Command kSlides{"slides", "[DECK...]", "A deck as pictures, as a page for a browser, and as a text for pandoc",
                      describeSlides, slidesWork};

} // namespace shadowlab::cli
