// Decks: every slide read, its pictures' states completed, its formulas set.
// SPDX-License-Identifier: MIT
#include "app/course/deck.h"
#include "app/drawing/formula.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_scene.h"

namespace shadowlab::fuzz {

Outcome feed(std::string_view bytes) {
    const scene::LoadOptions options{.assetsRoot = kOwnAssets, .allowed = {}, .limits = {}};
    const std::filesystem::path file = written("made-up.json", bytes);
    return outcomeOf([&] {
        course::Deck deck(file.string(), options);
        require(deck.name() == "made-up", "a deck is called as its file");
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            const course::Slide slide = deck.read(i);
            require(slide.name == deck.slides()[i], "slides come in the order of their names");
            for (const int line : slide.marked)
                require(line >= 1 && line <= static_cast<int>(slide.pseudocode.size()), "marked lines are there");
            for (const course::SlidePicture& picture : slide.pictures) {
                require(picture.state.scene != nullptr && !picture.state.slots.empty(), "a picture shows something");
                require(scene::hasView(picture.state.camera), "a picture is seen from somewhere");
            }
            for (const std::string& formula : slide.formulas)
                static_cast<void>(drawing::Formula(formula).spoken());
        }
    });
}

} // namespace shadowlab::fuzz
