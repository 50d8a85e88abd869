// What is on show, written down as a slide of a deck (docs/decks.md): `slides` draws from it the picture that was seen.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/lab/document.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::course {

/// The deck of a folder that slides are added to.
constexpr const char* kSavedDeck = "slides.json";

/// One slide as JSON: the document's state, with title, caption and alt text made from it, to be changed by hand.
/// `scene`: its reference as the deck has it, a built-in name or a file beside the deck.
std::string slideText(const lab::Document& document, const std::string& scene, const std::string& name);

/// The text of a deck with one more slide at its end; all else stays as it is, comments too. `file` is named in errors.
std::string withSlide(const std::string& deck, const std::filesystem::path& file, const std::string& slide);

struct SavedSlide {
    std::filesystem::path deck;
    std::string name;
    std::filesystem::path
        sceneFile; ///< written beside it, where the scene is no built-in one, or is changed; else empty
};

/// Adds what is on show to the deck of that folder, which begins with its first slide. `shown` is the scene as it is
/// now. Throws Error: badInput where the deck there cannot be read, cannotWrite. No file is left half-written.
SavedSlide saveSlide(const lab::Document& document, const scene::Scene& shown, const std::filesystem::path& folder,
                     const scene::LoadOptions& loading);

/// Where slides, scenes and pictures of the window go. Throws Error (cannotWrite) when it has been deleted.
std::filesystem::path currentFolder();

} // namespace shadowlab::course
