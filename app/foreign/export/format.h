// What a format for other programs is: a name, how it is written, and what is said about it.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/foreign/export/plain_scene.h"

namespace shadowlab::foreign {

/// One scene and where it is written.
struct ExportJob {
    const PlainScene& scene;
    std::filesystem::path folder;
    std::string stem; ///< "scene" or "calibration": what the names of its files begin with
    ivec2 size{640, 360}; ///< pixels of a picture where the one who draws says nothing
    std::filesystem::path threeModule; ///< three.module.js, to be put into the page; empty: the page looks for it beside itself
};

struct Format {
    std::string_view name;    ///< as --to takes it
    std::string_view program; ///< who reads it
    std::string_view files;   ///< "scene.py": what stands in the folder, for the README
    std::string_view images;  ///< where the images of materials are: a clause that follows
    bool drawsUnshadowed; ///< can it draw the picture of a light without shadows, beside that with them?
    void (*write)(const ExportJob& job);
    /// What of this scene the format does not say, a sentence without full stop each.
    std::vector<std::string> (*leftOut)(const PlainScene& scene);
    /// How a picture comes about: Markdown, with commands that can be copied.
    std::string (*howTo)(const PlainScene& scene, ivec2 size);
};

extern const Format kGltf, kThree, kMitsuba, kPov, kBlender;

/// All of them.
std::span<const Format* const> formats();
/// Throws Error (usage) for a name that there is not.
const Format& formatNamed(const std::string& name);

/// The text of assets/foreign/NAME. Throws Error (badInput).
std::string templateText(const std::string& name);
/// `text` with each `@KEY@` replaced; a key occurs at least once.
std::string filledIn(std::string text, std::string_view key, std::string_view value);

/// A word of a command line as a shell takes it: as it is, or in quotes.
std::string shellWord(const std::string& word);

/// Writes the images of the materials, if it has any, to the folder textures.
void writeImages(const ExportJob& job);

} // namespace shadowlab::foreign
