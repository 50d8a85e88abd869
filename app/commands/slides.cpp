// `shadowlab slides`: decks as pictures, as a page for a browser, and as a text for pandoc.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands/command_line.h"
#include "app/commands/messages.h"
#include "app/commands/progress.h"
#include "app/commands/slides_options.h"
#include "app/context/signals.h"
#include "app/session/assets.h"
#include "app/session/limits.h"
#include "app/slides/pages.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/image/png.h"
#include "techniques/foundation/nearest_names.h"
#include "techniques/foundation/scene/message_text.h"

namespace shadowlab::commands {

namespace {

using session::Deck;

void makeFolder(const std::filesystem::path& folder) {
    image::makeFolders(folder);
    image::probeWritable(folder / "slide.png");
}

/// "shadows-07-silhouettes"
std::string fileName(const Deck& deck, std::size_t slide) {
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "-%02zu-", slide + 1);
    return deck.name() + number.data() + deck.slides()[slide];
}

class Slides {
public:
    explicit Slides(const SlidesOptions& options) : options_(options) {}

    int run() {
        const scene::LoadOptions loading{
            .assetsRoot = session::assetsRoot(), .allowed = options_.allowed, .limits = session::limits()};
        std::vector<std::string> names = options_.decks;
        if (names.empty()) names = session::builtInDecks(loading.assetsRoot);
        std::vector<Deck> decks;
        for (const std::string& name : names)
            decks.emplace_back(name, loading);
        checkOnly(decks);
        context_ = context::createContext(options_.backend); // before the folders: without graphics none is left behind
        std::error_code ignored;
        const std::filesystem::path folders[] = {options_.output / "pictures", options_.output};
        const bool were[] = {std::filesystem::exists(folders[0], ignored),
                             std::filesystem::exists(folders[1], ignored)};
        makeFolder(folders[1]);
        makeFolder(folders[0]);
        if (const int limit = context::largestSide();
            std::max(options_.look.size.x, options_.look.size.y) * options_.look.supersample > limit)
            throw Error(ExitStatus::overLimit, "a picture needs more samples on a side than the " +
                                                   std::to_string(limit) +
                                                   " of this OpenGL driver; choose a smaller --size or --supersample");
        painter_ = std::make_unique<slides::SlidePainter>(session::assetsRoot() / "fonts", options_.look);
        int total = 0;
        for (const Deck& deck : decks)
            for (const std::string& slide : deck.slides())
                total += isWanted(slide);
        progress_.emplace("slide", total);
        for (Deck& deck : decks)
            draw(deck);
        for (const int i : {0, 1}) // one that nothing came into goes again
            if (!were[i] && std::filesystem::is_empty(folders[i], ignored))
                std::filesystem::remove(folders[i], ignored);
        return static_cast<int>(worst_);
    }

private:
    [[nodiscard]] bool isWanted(const std::string& slide) const {
        return options_.only.empty() || std::ranges::find(options_.only, slide) != options_.only.end();
    }

    void checkOnly(const std::vector<Deck>& decks) const {
        std::vector<std::string> known;
        for (const Deck& deck : decks)
            known.insert(known.end(), deck.slides().begin(), deck.slides().end());
        for (const std::string& slide : options_.only)
            if (std::ranges::find(known, slide) == known.end())
                throw Error(ExitStatus::usage,
                            "--only: no slide is called '" + scene::shown(slide) + "'; " + suggestion(slide, known));
    }

    void draw(Deck& deck) {
        std::vector<slides::PageSlide> pages;
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            if (!isWanted(deck.slides()[i])) continue;
            context::throwIfInterrupted();
            try {
                pages.push_back(draw(deck, i));
            } catch (const Error& error) {
                if (error.status() == ExitStatus::cannotWrite) throw; // the next would fail as well
                complain(place(deck, i, error.what()));
                if (worst_ == ExitStatus::ok) worst_ = error.status();
            }
            progress_->done(++done_);
        }
        if (!options_.only.empty() || pages.empty()) return;
        image::writeWhole(options_.output / (deck.name() + ".html"), slides::htmlPage(deck, pages));
        image::writeWhole(options_.output / (deck.name() + ".md"), slides::markdown(deck, pages));
    }

    /// What is wrong with a slide, naming it; what the file's readers say names file and line already.
    static std::string place(const Deck& deck, std::size_t slide, const std::string& what) {
        const std::string file = scene::shownPath(deck.file());
        const std::string which = "slide '" + deck.slides()[slide] + "': ";
        if (what.starts_with(file + ":")) return what + " (slide '" + deck.slides()[slide] + "')";
        return file + ": " + which + what;
    }

    slides::PageSlide draw(Deck& deck, std::size_t number) {
        slides::PageSlide page{deck.read(number), {}, "", ""};
        const slides::DrawnSlide drawn = painter_->draw(page.slide, {deck.title(), number + 1, deck.slides().size()});
        const std::string name = fileName(deck, number) + ".png";
        std::vector<image::PngText> text{{"Title", page.slide.title}};
        if (!page.slide.alt.empty()) text.push_back({"Description", page.slide.alt});
        page.png = image::encodePng(drawn.slide, {.opaque = true, .text = text});
        image::writeWhole(options_.output / name, page.png);
        if (drawn.pictures.width > 0) {
            page.pictureFile = "pictures/" + name;
            image::writeWhole(options_.output / page.pictureFile,
                              image::encodePng(drawn.pictures, {.opaque = true, .text = text}));
        }
        if (slides::showsWordsAsPicture(page.slide)) {
            page.wordsFile = "pictures/" + fileName(deck, number) + "-with-words.png";
            image::writeWhole(options_.output / page.wordsFile,
                              image::encodePng(drawn.content, {.opaque = true, .text = text}));
        }
        return page;
    }

    const SlidesOptions& options_;
    std::unique_ptr<context::Context> context_;
    std::unique_ptr<slides::SlidePainter> painter_;
    std::optional<Progress> progress_;
    int done_ = 0;
    ExitStatus worst_ = ExitStatus::ok; ///< of the first slide that failed
};

} // namespace

int slides(const SlidesOptions& options) { return Slides(options).run(); }

} // namespace shadowlab::commands
