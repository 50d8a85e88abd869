// A deck: slides for a lecture, each with a title, pictures computed from scenes, words, formulas and a caption. What its file
// says (docs/decks.md), checked and made complete.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/course/explore/explore.h"
#include "app/course/shown_state.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::course {

/// A frame or an arrow on a picture, in shares of its width and height from the upper left corner, with its words.
struct Callout {
    bool isArrow = false;
    dvec2 from{0.0}, to{0.0}; ///< two corners, or the arrow's tail and tip
    std::string label;        ///< may be empty
};

/// One picture of a slide: what techniques show of a scene, or the drawing that a probe makes of one of its pixels.
struct SlidePicture {
    ShownState state;
    std::optional<dvec2> pixel, partner; ///< in shares of the picture: what stages are about, or the drawing
    std::string
        figure; ///< the name of a drawing of that pixel (figures/figures.h); empty: the scene as techniques show it
    std::optional<scene::Camera> outside; ///< of the stage `outside`; none: as the program chooses it
    picture::OutsideChoice outsideChoice; ///< likewise: whose shadow volumes it shows
    std::string label;                    ///< above it, in plain words; may be empty
    std::string writtenLabel;             ///< the same as the file has it, with formulas between $
    std::vector<Callout> callouts;
};

/// A slide's words as its file has them: with formulas between $ (drawing/prose.h).
struct WrittenWords {
    std::string title, caption;
    std::vector<std::string> text, notes;
};

/// Title, caption, text and notes are in plain words, for what reads no formulas.
struct Slide {
    std::string name; ///< its files are called so
    std::string title;
    std::vector<SlidePicture> pictures;  ///< none: words alone
    std::vector<std::string> text;       ///< paragraphs beside the pictures
    std::vector<std::string> pseudocode; ///< the lines of a technique's
    std::vector<int> marked;             ///< which of them on a bright ground, counted from 1
    std::vector<std::string> formulas;   ///< each in the part of TeX that drawing/formula.h knows
    std::optional<int> supersample;      ///< N x N samples for a pixel; none: as many as for the other slides
    std::string caption;
    std::string alt; ///< the picture in words, for readers who cannot see it
    std::vector<std::string> notes{}; ///< for who speaks: what to say, what to ask; never drawn on the slide
    WrittenWords written;
    std::optional<Explore> explore{}; ///< none: it stays a picture
};

/// A deck's file, open. Slides are read one by one: an error in one does not affect the others.
class Deck {
public:
    /// A path to a .json, else the name of a built-in deck. Throws Error (badInput, overLimit) with FILE:LINE:COLUMN for what
    /// concerns all slides.
    Deck(const std::string& nameOrPath, const scene::LoadOptions& options);
    ~Deck();
    Deck(Deck&&) noexcept;

    [[nodiscard]] const std::string& name() const; ///< of the file, without folder and ending
    [[nodiscard]] const std::filesystem::path& file() const;
    [[nodiscard]] const std::string& text() const; ///< all of it, as it was read
    [[nodiscard]] const std::string& title() const;
    [[nodiscard]] const std::string& subtitle() const; ///< may be empty
    /// The slides' names, in order; no two are alike.
    [[nodiscard]] const std::vector<std::string>& slides() const;
    /// Throws Error (badInput) with FILE:LINE:COLUMN for what a slide may not say, and all that loading a scene throws.
    Slide read(std::size_t slide);

private:
    struct File;
    std::unique_ptr<File> opened_;
};

/// The built-in decks by their names.
std::vector<std::string> builtInDecks(const std::filesystem::path& assets);

} // namespace shadowlab::course
