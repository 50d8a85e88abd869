// Draws UTF-8 text into pictures: labels, captions, legends.
//
// FreeType without hinting: glyphs keep their true shapes and positions at every size, and the same font file gives the
// same pixels. Edges are blended in linear light (see blendPixel).
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::image {

struct TextSize {
    int width = 0, height = 0; ///< pixels; the ink lies within, accents above capitals included
    int baseline = 0;          ///< from the top of the first line to the foot of its letters
};

/// One font file at any size. Not to be used from two threads at once.
class Font {
public:
    /// Throws Error (badInput) when the file is missing or no font.
    explicit Font(const std::filesystem::path& file);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// `pixelHeight` is the size of the font as typesetters count (em): capitals are about 0.73 of it, lines 1.17
    /// apart. A line feed starts a new line. Characters that the font lacks show as its empty box.
    [[nodiscard]] TextSize measure(std::string_view text, double pixelHeight) const;

    /// Draws with the top left corner of the measured box at (x, y). Returns what measure() returns.
    TextSize draw(Image& image, int x, int y, std::string_view text, double pixelHeight, Color8 color) const;

    /// Breaks at blanks so that no line is wider than `maxWidth`; a single word that is too wide is broken inside.
    [[nodiscard]] std::vector<std::string> wrap(std::string_view text, double pixelHeight, int maxWidth) const;

private:
    struct Face;
    std::unique_ptr<Face> face_;
};

} // namespace shadowlab::image
