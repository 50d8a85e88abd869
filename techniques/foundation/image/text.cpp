// Text layout and rendering with FreeType. Left to right, one glyph per code point, pair kerning: enough for captions
// in European languages and mathematical signs; no ligatures and no right-to-left scripts.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/utf8.h"

namespace shadowlab::image {
namespace {

// FreeType counts in 1/64 pixel.
constexpr FT_Pos kUnit = 64;
FT_Pos floorPixels(FT_Pos position) { return position >= 0 ? position / kUnit : -((-position + kUnit - 1) / kUnit); }
FT_Pos ceilPixels(FT_Pos position) { return -floorPixels(-position); }

struct PlacedGlyph {
    FT_UInt index;
    FT_Pos x;
    int line;
};

/// Glyphs at positions relative to the box's left edge.
struct Layout {
    std::vector<PlacedGlyph> glyphs;
    TextSize size;
    FT_Pos lineHeight = 0; ///< pixels
};

} // namespace

struct Font::Face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit Face(const std::filesystem::path& file) {
        if (FT_Init_FreeType(&library) != 0) throw Error(ExitStatus::bug, "FreeType does not start; report it");
        if (FT_New_Face(library, file.c_str(), 0, &face) == 0 && FT_IS_SCALABLE(face)) return;
        FT_Done_FreeType(library); // also frees the face
        std::error_code ignored;
        const bool exists = std::filesystem::exists(file, ignored);
        throw Error(ExitStatus::badInput,
                    file.string() + (exists ? ": is not a font that can be scaled" : ": the font is missing") +
                        "; restore the project's assets/fonts (package fonts-dejavu-core has the same files)");
    }
    ~Face() { FT_Done_FreeType(library); }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    void setSize(double pixelHeight) const {
        // At 72 dots per inch a point is a pixel. FreeType takes sizes of 1 to 65535 units.
        const double units = std::clamp(pixelHeight * kUnit, 1.0, 65535.0);
        FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(std::lround(units)), 72, 72);
    }
    bool load(FT_UInt index) const { return FT_Load_Glyph(face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) == 0; }

    Layout layOut(std::string_view text, double pixelHeight) const;
};

Layout Font::Face::layOut(std::string_view text, double pixelHeight) const {
    setSize(pixelHeight);
    // With hinting off the scaled design values are exact; size->metrics is rounded for hinted text.
    const auto scaled = [&](FT_Short design) { return FT_MulFix(design, face->size->metrics.y_scale); };
    const FT_Pos ascent = ceilPixels(scaled(face->ascender)), descent = ceilPixels(-scaled(face->descender));

    Layout layout;
    layout.lineHeight = std::max(ceilPixels(scaled(face->height)), ascent + descent);
    FT_Pos pen = 0, left = 0, right = 0, above = ascent * kUnit;
    FT_UInt previous = 0;
    int line = 0;
    for (const char32_t point : decodeUtf8(text)) {
        if (point == U'\n') {
            right = std::max(right, pen);
            pen = 0, previous = 0, ++line;
            continue;
        }
        const FT_UInt index = FT_Get_Char_Index(face, point);
        FT_Vector kerning{};
        if (previous && FT_HAS_KERNING(face)) FT_Get_Kerning(face, previous, index, FT_KERNING_UNFITTED, &kerning);
        pen += kerning.x;
        if (!load(index)) continue;
        FT_BBox ink{};
        FT_Outline_Get_CBox(&face->glyph->outline, &ink);
        left = std::min(left, pen + ink.xMin); // a j reaches left of where it starts
        right = std::max(right, pen + ink.xMax);
        if (line == 0) above = std::max(above, ink.yMax);
        layout.glyphs.push_back({index, pen, line});
        pen += face->glyph->advance.x;
        previous = index;
    }
    right = std::max(right, pen);
    const FT_Pos shift = -floorPixels(left) * kUnit;
    for (PlacedGlyph& glyph : layout.glyphs)
        glyph.x += shift;
    layout.size.baseline = static_cast<int>(ceilPixels(above));
    layout.size.width = static_cast<int>(ceilPixels(right + shift));
    layout.size.height = static_cast<int>(layout.size.baseline + descent + line * layout.lineHeight);
    return layout;
}

Font::Font(const std::filesystem::path& file) : face_(std::make_unique<Face>(file)) {}
Font::~Font() = default;

TextSize Font::measure(std::string_view text, double pixelHeight) const {
    return face_->layOut(text, pixelHeight).size;
}

TextSize Font::draw(Image& image, int x, int y, std::string_view text, double pixelHeight, Color8 color) const {
    const Layout layout = face_->layOut(text, pixelHeight);
    const FT_GlyphSlot slot = face_->face->glyph;
    for (const PlacedGlyph& glyph : layout.glyphs) {
        if (!face_->load(glyph.index)) continue;
        // Whole pixels move the bitmap, the rest moves the outline under the pixel grid: even spacing at small sizes.
        const FT_Pos wholeX = floorPixels(glyph.x);
        FT_Outline_Translate(&slot->outline, glyph.x - wholeX * kUnit, 0);
        if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) continue;
        const FT_Bitmap& bitmap = slot->bitmap;
        const int left = x + static_cast<int>(wholeX) + slot->bitmap_left;
        const int top = y + layout.size.baseline + glyph.line * static_cast<int>(layout.lineHeight) - slot->bitmap_top;
        for (unsigned row = 0; row < bitmap.rows; ++row) {
            const unsigned char* coverage = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
            for (unsigned column = 0; column < bitmap.width; ++column)
                blendPixel(image, left + static_cast<int>(column), top + static_cast<int>(row), color,
                           static_cast<float>(coverage[column]) / 255.0f);
        }
    }
    return layout.size;
}

std::vector<std::string> Font::wrap(std::string_view text, double pixelHeight, int maxWidth) const {
    const auto fits = [&](const std::u32string& line) {
        return measure(encodeUtf8(line), pixelHeight).width <= maxWidth;
    };
    std::vector<std::string> lines;
    std::u32string line, word;
    const auto endLine = [&] {
        lines.push_back(encodeUtf8(line));
        line.clear();
    };
    const auto placeWord = [&] {
        if (word.empty()) return;
        if (!line.empty() && !fits(line + U' ' + word)) endLine();
        if (!line.empty()) line += U' ';
        for (const char32_t letter : word) {
            if (!line.empty() && !fits(line + letter)) endLine(); // only in a word wider than a whole line
            line += letter;
        }
        word.clear();
    };
    for (const char32_t letter : decodeUtf8(text)) {
        if (letter != U' ' && letter != U'\n') {
            word += letter;
            continue;
        }
        placeWord();
        if (letter == U'\n') endLine();
    }
    placeWord();
    if (!line.empty() || lines.empty()) endLine();
    return lines;
}

} // namespace shadowlab::image
