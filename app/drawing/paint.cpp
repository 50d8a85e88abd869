// SPDX-License-Identifier: MIT
#include "app/drawing/paint.h"

#include <cairo-ft.h>
#include <cairo.h>
#include FT_ADVANCES_H

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/utf8.h"

namespace shadowlab::drawing {

namespace {

[[noreturn]] void failed(cairo_status_t status) {
    throw Error(ExitStatus::bug, std::string("Cairo: ") + cairo_status_to_string(status) + "; report it");
}

void setColor(cairo_t* cairo, const std::string& color, double opacity = 1) {
    std::array<int, 3> channels{};
    for (std::size_t i = 0; i < 3; ++i)
        std::from_chars(color.data() + 1 + 2 * i, color.data() + 3 + 2 * i, channels[i], 16); // "#0072b2"
    cairo_set_source_rgba(cairo, channels[0] / 255.0, channels[1] / 255.0, channels[2] / 255.0, opacity);
}

/// Fills and strokes the current path, and clears it.
void fillAndStroke(cairo_t* cairo, const std::string& fill, const Stroke& stroke) {
    if (!fill.empty() && fill != "none") {
        setColor(cairo, fill);
        cairo_fill_preserve(cairo);
    }
    if (stroke.width > 0) {
        setColor(cairo, stroke.color);
        cairo_set_line_width(cairo, stroke.width);
        constexpr std::array dashes{kDashLength, kDashGap};
        cairo_set_dash(cairo, dashes.data(), stroke.isDashed ? dashes.size() : 0, 0);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER); // as SVG has it
        cairo_stroke_preserve(cairo);
    }
    cairo_new_path(cairo);
}

constexpr double kRightAngle = 1.57079632679489662;

/// The lines of a rectangle with round corners: quarters of circles, clockwise from the upper right.
void addRoundRectangle(cairo_t* cairo, dvec2 corner, dvec2 size, double radius) {
    const dvec2 low = corner + radius, high = corner + size - radius;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, high.x, low.y, radius, -kRightAngle, 0);
    cairo_arc(cairo, high.x, high.y, radius, 0, kRightAngle);
    cairo_arc(cairo, low.x, high.y, radius, kRightAngle, 2 * kRightAngle);
    cairo_arc(cairo, low.x, low.y, radius, 2 * kRightAngle, 3 * kRightAngle);
    cairo_close_path(cairo);
}

/// A line of text, its foot at (0, 0), in em.
struct PlacedText {
    std::vector<cairo_glyph_t> glyphs;
    double width = 0;
};

/// With the design widths and the kerning that image::Font measures by: what was measured is what is drawn. Cairo itself would
/// round each width to whole pixels.
PlacedText placed(FT_Face face, std::string_view text) {
    PlacedText line;
    const double em = face->units_per_EM;
    FT_UInt previous = 0;
    for (const char32_t letter : image::decodeUtf8(text)) {
        const FT_UInt index = FT_Get_Char_Index(face, letter);
        FT_Vector kerning{};
        if (previous && FT_HAS_KERNING(face)) FT_Get_Kerning(face, previous, index, FT_KERNING_UNSCALED, &kerning);
        line.width += static_cast<double>(kerning.x) / em;
        line.glyphs.push_back({index, line.width, 0});
        FT_Fixed advance = 0;
        FT_Get_Advance(face, index, FT_LOAD_NO_SCALE, &advance);
        line.width += static_cast<double>(advance) / em;
        previous = index;
    }
    return line;
}

} // namespace

/// The two faces, as Cairo knows them and as FreeType does.
struct Painter::Fonts {
    std::array<cairo_font_face_t*, 2> fonts{}; ///< upright, bold
    std::array<FT_Face, 2> faces{};            ///< the same, which Cairo owns

    explicit Fonts(const std::filesystem::path& folder) {
        constexpr std::array names{"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::filesystem::path file = folder / names[i];
            FT_Face face = nullptr;
            if (FT_New_Face(library(), file.c_str(), 0, &face) != 0) {
                release();
                throw Error(ExitStatus::badInput,
                            file.string() + ": the font is missing, or is none; restore the project's assets/fonts "
                                            "(package fonts-dejavu-core has the same files)");
            }
            fonts[i] = cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
            faces[i] = face;
            // Cairo may keep a font in its caches after the last user has gone; the face goes when Cairo lets it go.
            static const cairo_user_data_key_t kFace{};
            cairo_font_face_set_user_data(fonts[i], &kFace, face,
                                          [](void* kept) { FT_Done_Face(static_cast<FT_Face>(kept)); });
        }
    }
    ~Fonts() { release(); }
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

private:
    /// Lives as long as the program, as Cairo's caches do.
    static FT_Library library() {
        static const FT_Library started = [] {
            FT_Library made = nullptr;
            if (FT_Init_FreeType(&made) != 0) throw Error(ExitStatus::bug, "FreeType does not start; report it");
            return made;
        }();
        return started;
    }
    void release() {
        for (cairo_font_face_t* font : fonts)
            if (font) cairo_font_face_destroy(font);
    }
};

namespace {

/// Paints one mark after another.
struct Brush {
    cairo_t* cairo;
    const std::array<cairo_font_face_t*, 2>& fonts;
    const std::array<FT_Face, 2>& faces;

    void operator()(const Line& line) const {
        for (const dvec2& point : line.points)
            cairo_line_to(cairo, point.x, point.y);
        if (line.isClosed) cairo_close_path(cairo);
        fillAndStroke(cairo, line.fill, line.stroke);
    }
    void operator()(const Segments& segments) const {
        for (std::size_t i = 0; i + 1 < segments.points.size(); i += 2) {
            cairo_move_to(cairo, segments.points[i].x, segments.points[i].y);
            cairo_line_to(cairo, segments.points[i + 1].x, segments.points[i + 1].y);
        }
        fillAndStroke(cairo, "", segments.stroke);
    }
    void operator()(const Surface& surface) const {
        for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3) {
            cairo_move_to(cairo, surface.points[i].x, surface.points[i].y);
            cairo_line_to(cairo, surface.points[i + 1].x, surface.points[i + 1].y);
            cairo_line_to(cairo, surface.points[i + 2].x, surface.points[i + 2].y);
            cairo_close_path(cairo);
        }
        setColor(cairo, surface.fill, surface.opacity);
        cairo_fill(cairo);
    }
    void operator()(const Circle& circle) const {
        cairo_arc(cairo, circle.centre.x, circle.centre.y, circle.radius, 0, 4 * kRightAngle);
        cairo_close_path(cairo);
        fillAndStroke(cairo, circle.fill, circle.stroke);
    }
    void operator()(const Rectangle& rectangle) const {
        if (rectangle.rounding > 0)
            addRoundRectangle(cairo, rectangle.corner, rectangle.size, rectangle.rounding);
        else
            cairo_rectangle(cairo, rectangle.corner.x, rectangle.corner.y, rectangle.size.x, rectangle.size.y);
        fillAndStroke(cairo, rectangle.fill, rectangle.stroke);
    }
    void operator()(const TextLine& text) const {
        const TextStyle& style = text.style;
        const std::size_t font = style.isBold ? 1 : 0;
        cairo_set_font_face(cairo, fonts[font]);
        cairo_matrix_t matrix;
        cairo_matrix_init_scale(&matrix, style.size, style.size);
        constexpr double kSlant = 0.2; // DejaVu Sans Oblique leans by 11 degrees
        if (style.isItalic) matrix.xy = -kSlant * style.size;
        cairo_set_font_matrix(cairo, &matrix);
        PlacedText line = placed(faces[font], image::withoutNoncharacters(text.text));
        const double share = style.anchor == Anchor::start ? 0 : style.anchor == Anchor::middle ? 0.5 : 1;
        for (cairo_glyph_t& glyph : line.glyphs) {
            glyph.x = text.place.x + style.size * (glyph.x - share * line.width);
            glyph.y = text.place.y;
        }
        cairo_glyph_path(cairo, line.glyphs.data(), static_cast<int>(line.glyphs.size()));
        if (style.hasRim) {
            cairo_set_source_rgb(cairo, 1, 1, 1);
            cairo_set_line_width(cairo, kRimWidth);
            cairo_set_dash(cairo, nullptr, 0, 0);
            cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
            cairo_stroke_preserve(cairo);
        }
        fillAndStroke(cairo, style.color, {style.color, 0, false});
    }
    void operator()(const ClipBegin& clip) const {
        cairo_save(cairo);
        cairo_rectangle(cairo, clip.corner.x, clip.corner.y, clip.size.x, clip.size.y);
        cairo_clip(cairo);
    }
    void operator()(const ClipEnd&) const { cairo_restore(cairo); }
};

// Cairo keeps a pixel as one number of 32 bits: blue in the lowest 8, then green, red, and how much it covers.
constexpr std::uint32_t kCovered = 0xff000000u;

} // namespace

Painter::Painter(const std::filesystem::path& fonts) : fonts_(std::make_unique<Fonts>(fonts)) {}
Painter::~Painter() = default;

void Painter::paint(const Drawing& drawing, image::Image& picture, ivec2 corner, double scale) const {
    const std::size_t pixels = picture.rgba.size() / image::kChannels;
    std::vector<std::uint32_t> packed(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* p = picture.rgba.data() + i * image::kChannels;
        packed[i] = kCovered | std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
    }
    cairo_surface_t* surface =
        cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(packed.data()), CAIRO_FORMAT_RGB24,
                                            picture.width, picture.height, 4 * picture.width);
    cairo_t* cairo = cairo_create(surface);
    cairo_translate(cairo, corner.x, corner.y);
    cairo_scale(cairo, scale, scale);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_BEST);
    for (const Mark& mark : drawing.marks())
        std::visit(Brush{cairo, fonts_->fonts, fonts_->faces}, mark);
    const cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS) failed(status);
    for (std::size_t i = 0; i < pixels; ++i) {
        std::uint8_t* p = picture.rgba.data() + i * image::kChannels;
        p[0] = static_cast<std::uint8_t>(packed[i] >> 16), p[1] = static_cast<std::uint8_t>(packed[i] >> 8),
        p[2] = static_cast<std::uint8_t>(packed[i]), p[3] = 255;
    }
}

} // namespace shadowlab::drawing
