// A drawing of lines and text, written as SVG 1.1 or painted into a picture (paint.h). Lengths are in pixels of a sheet whose
// origin is its upper left corner.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::drawing {

/// "#0072b2", from a colour in linear light.
std::string colorText(const vec3& linear);

struct Stroke {
    std::string color = "#1a1a1a";
    double width = 3;
    bool isDashed = false;
};
constexpr double kDashLength = 9, kDashGap = 7; ///< of a dashed line

enum class Anchor { start, middle, end };

struct TextStyle {
    double size = 24; ///< em
    Anchor anchor = Anchor::start;
    bool isBold = false, isItalic = false;
    std::string color = "#1a1a1a";
    bool hasRim = true; ///< a white one, which keeps it legible on lines
};
constexpr double kRimWidth = 6; ///< half of it lies outside of the letters

// What a drawing is made of, in the order of drawing. An empty colour: not filled.
struct Line {
    std::vector<dvec2> points;
    bool isClosed = false;
    std::string fill;
    Stroke stroke;
};
struct Segments {
    std::vector<dvec2> points; ///< two for each
    Stroke stroke;
};
/// Triangles as one surface: where they overlap, it covers what is below no more than once.
struct Surface {
    std::vector<dvec2> points; ///< three for each, all turning the same way
    std::string fill;
    double opacity = 1;
};
struct Circle {
    dvec2 centre;
    double radius;
    std::string fill;
    Stroke stroke;
    std::string name; ///< what it marks ("eye"); empty: nothing of its own
};
struct Rectangle {
    dvec2 corner, size;
    std::string fill;
    Stroke stroke;
    double rounding = 0;
};
struct TextLine {
    dvec2 place;
    std::string text;
    TextStyle style;
};
struct ClipBegin {
    dvec2 corner, size;
};
struct ClipEnd {};
using Mark = std::variant<Line, Segments, Surface, Circle, Rectangle, TextLine, ClipBegin, ClipEnd>;

class Drawing {
public:
    explicit Drawing(dvec2 size) : size_(size) {}

    void line(dvec2 from, dvec2 to, const Stroke& stroke);
    /// A line with its head at `share` of the way: 1 is its end.
    void arrow(dvec2 from, dvec2 to, const Stroke& stroke, double share = 1);
    /// All in one path: two points for each segment.
    void segments(std::span<const dvec2> points, const Stroke& stroke);
    /// Triangles, three points for each, in any order, as one surface that lets through what is below it.
    void surface(std::span<const dvec2> points, const std::string& fill, double opacity);
    /// One line through all points. `fill`: empty for none.
    void path(std::span<const dvec2> points, bool isClosed, const std::string& fill, const Stroke& stroke);
    /// `name`: what it marks, as a class of the document ("eye"); empty: nothing of its own.
    void circle(dvec2 centre, double radius, const std::string& fill, const Stroke& stroke, std::string_view name = {});
    void rectangle(dvec2 corner, dvec2 size, const std::string& fill, const Stroke& stroke, double rounding = 0);
    /// One line, its foot at `place`.
    void text(dvec2 place, std::string_view text, const TextStyle& style);
    /// Two short strokes across a line: a part of it is left out there.
    void breakMark(dvec2 place, dvec2 direction, const Stroke& stroke);

    /// What is drawn until endClip() shows within that rectangle only.
    void beginClip(dvec2 corner, dvec2 size) { marks_.emplace_back(ClipBegin{corner, size}); }
    void endClip() { marks_.emplace_back(ClipEnd{}); }

    /// Makes the sheet higher: empty room below.
    void addRoomBelow(double height) { size_.y += height; }

    [[nodiscard]] dvec2 size() const { return size_; }
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }

    /// The SVG document. `title`: what the drawing is, for who cannot see it.
    [[nodiscard]] std::string document(std::string_view title) const;

private:
    dvec2 size_;
    std::vector<Mark> marks_;
};

} // namespace shadowlab::drawing
