// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/seen_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::shadow_map {

namespace {

double largestOf(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Of the largest coordinate: a corner that is less deep has no place that could be relied on.
constexpr double kShallow = 0x1p-20;
// What a place is wrong by, as a share of itself and of one (parallel: of the largest coordinate): with the depth above,
// 12 e M / (kShallow M) is less than 2^-28. The rest covers places that are kept as floats.
constexpr double kPlaceError = 0x1p-22;
// Of the largest coordinate: a corner is certainly outside a plane through the light that it is farther away from.
constexpr double kCertainlyOutside = 0x1p-40;

PlaneRect widened(PlaneRect rect, double unit) {
    rect.lower -= kPlaceError * (unit + glm::abs(rect.lower));
    rect.upper += kPlaceError * (unit + glm::abs(rect.upper));
    return rect;
}

std::optional<PlaneRect> common(const PlaneRect& a, const PlaneRect& b) {
    const PlaneRect both{glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
    return both.isEmpty() ? std::nullopt : std::optional(both);
}

/// The part of a triangle within the pyramid that has its tip in the light and goes through the rectangle.
std::optional<PlaneRect> clippedRect(const std::array<dvec3, 3>& corners, const PlaneRect& asked, double shallow) {
    // A little wider, or cutting there could lose what lies on the border.
    const dvec2 margin = glm::max(0x1p-10 * (asked.upper - asked.lower), dvec2(0x1p-16));
    const PlaneRect wide{asked.lower - margin, asked.upper + margin};
    std::vector<dvec4> polygon;
    for (const dvec3& corner : corners)
        polygon.emplace_back(corner, 1.0);
    for (const dvec4& inside : {dvec4(1, 0, -wide.lower.x, 0), dvec4(-1, 0, wide.upper.x, 0),
                                dvec4(0, 1, -wide.lower.y, 0), dvec4(0, -1, wide.upper.y, 0)})
        polygon = scene::clippedPolygon(polygon, inside);
    PlaneRect rect;
    for (const dvec4& corner : polygon) {
        if (corner.z < shallow * corner.w) return asked; // it touches the light, or nearly
        rect.include(dvec2(corner) / corner.z);
    }
    return rect.isEmpty() ? std::nullopt : common(widened(rect, 1), asked);
}

} // namespace

SeenTriangle seenFrom(const LightPlane& plane, const trace::Triangle& triangle, std::uint32_t primitive,
                      const Asked& asked) {
    const dvec3 a = plane.alongAxes(triangle.a), b = plane.alongAxes(triangle.b), c = plane.alongAxes(triangle.c);
    const dvec3 toB = plane.planeFromCentred * (triangle.b - triangle.a),
                toC = plane.planeFromCentred * (triangle.c - triangle.a);
    SeenTriangle seen;
    seen.primitive = primitive;
    seen.largest = std::max({largestOf(a), largestOf(b), largestOf(c)});
    seen.longest = std::max({largestOf(toB), largestOf(toC), largestOf(toC - toB)});
    // Homogeneous coordinates of the plane: the depth is the weight, and parallel light has none.
    const auto point = [&](const dvec3& v) { return plane.parallel ? dvec3(v.x, v.y, 1) : v; };
    const auto edge = [&](const dvec3& v) { return plane.parallel ? dvec3(v.x, v.y, 0) : v; };
    seen.sides[0] = glm::cross(point(b), edge(toC - toB)); // opposite to a: b x c, b being crossed with itself nothing
    seen.sides[1] = glm::cross(edge(toC), point(a));
    seen.sides[2] = glm::cross(point(a), edge(toB));
    const dvec3 sum = glm::cross(edge(toB), edge(toC)); // of the three sides, and more exact
    const double determinant = glm::dot(point(a), sum);
    seen.determinant = std::abs(determinant);
    seen.nearness = plane.parallel ? (seen.sides[1] * toB.z + seen.sides[2] * toC.z) / determinant + dvec3(0, 0, a.z)
                                   : sum / determinant;
    if (determinant < 0)
        for (dvec3& side : seen.sides)
            side = -side;
    const double m = asked.sizes(seen.largest).m;
    const double least = std::min({a.z, b.z, c.z}), most = std::max({a.z, b.z, c.z});
    if (plane.parallel) {
        seen.nearest = most + kCertainlyOutside * m;
        seen.farthest = least - kCertainlyOutside * m;
    } else {
        const bool before = least >= kShallow * m;
        seen.nearest = before ? (1 + kPlaceError) / least : std::numeric_limits<double>::infinity();
        seen.farthest = before ? (1 - kPlaceError) / most : -std::numeric_limits<double>::infinity();
    }
    return seen;
}

std::optional<PlaneRect> coveredRect(const LightPlane& plane, const trace::Triangle& triangle, const Asked& asked) {
    const std::array<dvec3, 3> corners{plane.alongAxes(triangle.a), plane.alongAxes(triangle.b),
                                       plane.alongAxes(triangle.c)};
    const Sizes sizes = asked.sizes(std::max({largestOf(corners[0]), largestOf(corners[1]), largestOf(corners[2])}));
    PlaneRect rect;
    if (plane.parallel) {
        for (const dvec3& corner : corners)
            rect.include(dvec2(corner));
        return common(widened(rect, sizes.m), asked.rect);
    }
    const auto allBeyond = [&](const dvec3& outside) {
        return std::ranges::all_of(
            corners, [&](const dvec3& corner) { return glm::dot(corner, outside) > kCertainlyOutside * sizes.m; });
    };
    const double least = std::min({corners[0].z, corners[1].z, corners[2].z}),
                 most = std::max({corners[0].z, corners[1].z, corners[2].z}), shallow = kShallow * sizes.m;
    if (least < shallow) {
        const double determinant = glm::dot(corners[0], glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const bool certain = isCertain(determinant, sizes, plane.parallel);
        if (certain && allBeyond({0, 0, -1})) return std::nullopt;
        if (!certain && most > -shallow) return asked.rect;
        if (certain) {
            const PlaneRect wide = widened(asked.rect, 1);
            if (allBeyond({1, 0, -wide.upper.x}) || allBeyond({-1, 0, wide.lower.x}) ||
                allBeyond({0, 1, -wide.upper.y}) || allBeyond({0, -1, wide.lower.y}))
                return std::nullopt;
            return clippedRect(corners, asked.rect, shallow);
        }
    }
    for (const dvec3& corner : corners)
        rect.include(dvec2(corner) / corner.z); // right behind the light as well
    return common(widened(rect, 1), asked.rect);
}

} // namespace shadowlab::shadow_map
