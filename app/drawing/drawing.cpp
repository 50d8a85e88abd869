// SPDX-License-Identifier: MIT
#include "app/drawing/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "techniques/foundation/image/image.h"

namespace shadowlab::drawing {

namespace {

constexpr double kHead = 16, kHalfHead = 6.5; ///< length and half the width of an arrow's head

} // namespace

std::string colorText(const vec3& linear) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", image::srgbFromLinear(linear.r),
                  image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b));
    return text.data();
}

void Drawing::line(dvec2 from, dvec2 to, const Stroke& stroke) {
    marks_.emplace_back(Line{{from, to}, false, "", stroke});
}

void Drawing::arrow(dvec2 from, dvec2 to, const Stroke& stroke, double share) {
    const double length = glm::length(to - from);
    if (length == 0) return;
    const dvec2 along = (to - from) / length, across(-along.y, along.x);
    const double grow = std::max(1.0, stroke.width / 3);
    dvec2 tip = glm::mix(from, to, share);
    if (share < 1) tip += 0.5 * kHead * grow * along; // the head's middle is meant
    const dvec2 foot = tip - kHead * grow * along;
    line(from, share < 1 ? to : foot + 0.5 * along, stroke);
    marks_.emplace_back(Line{{tip, foot + kHalfHead * grow * across, foot - kHalfHead * grow * across},
                             true,
                             stroke.color,
                             {stroke.color, 0, false}});
}

void Drawing::segments(std::span<const dvec2> points, const Stroke& stroke) {
    if (points.size() < 2) return;
    marks_.emplace_back(Segments{{points.begin(), points.end()}, stroke});
}

void Drawing::surface(std::span<const dvec2> points, const std::string& fill, double opacity) {
    Surface surface{{}, fill, opacity};
    for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
        const dvec2 &a = points[i], b = points[i + 1] - a, c = points[i + 2] - a;
        const double turn = b.x * c.y - b.y * c.x;
        if (turn == 0) continue; // seen from its edge
        const std::size_t second = turn > 0 ? i + 1 : i + 2, third = turn > 0 ? i + 2 : i + 1;
        surface.points.insert(surface.points.end(), {a, points[second], points[third]});
    }
    if (!surface.points.empty()) marks_.emplace_back(std::move(surface));
}

void Drawing::path(std::span<const dvec2> points, bool isClosed, const std::string& fill, const Stroke& stroke) {
    if (points.size() < 2) return;
    marks_.emplace_back(Line{{points.begin(), points.end()}, isClosed, fill, stroke});
}

void Drawing::circle(dvec2 centre, double radius, const std::string& fill, const Stroke& stroke,
                     std::string_view name) {
    marks_.emplace_back(Circle{centre, radius, fill, stroke, std::string(name)});
}

void Drawing::rectangle(dvec2 corner, dvec2 size, const std::string& fill, const Stroke& stroke, double rounding) {
    marks_.emplace_back(Rectangle{corner, size, fill, stroke, rounding});
}

void Drawing::text(dvec2 place, std::string_view text, const TextStyle& style) {
    marks_.emplace_back(TextLine{place, std::string(text), style});
}

void Drawing::breakMark(dvec2 place, dvec2 direction, const Stroke& stroke) {
    const dvec2 along = glm::normalize(direction), across(-along.y, along.x);
    for (const double side : {-5.0, 5.0})
        line(place + side * along - 11.0 * (across + 0.4 * along), place + side * along + 11.0 * (across + 0.4 * along),
             {stroke.color, 3, false});
}

} // namespace shadowlab::drawing
