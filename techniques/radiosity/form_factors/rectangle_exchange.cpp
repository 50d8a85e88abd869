// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/rectangle_exchange.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

namespace {

// The tolerance for equal directions and places: scenes are written in decimal numbers and rotated by matrices.
constexpr double kSame = 1e-12;

// The sixteen terms are of the size of the squared distance, each rounded at 2^-53 of it, and their sum is A_1 A_2 / (pi
// distance^2). With the squared distance at most this many times the mean area, ten digits and more are left.
constexpr double kFarthest = 100;

struct Rectangle {
    dvec3 corner, u, v, normal; ///< u and v unit, along the edges; normal = u x v
    double length, width;
};

std::optional<Rectangle> rectangleOf(const Polygon& p) {
    if (p.count() != 4) return std::nullopt;
    Rectangle r;
    const dvec3 u = p[1] - p[0], v = p[3] - p[0];
    r.length = glm::length(u);
    r.width = glm::length(v);
    const double size = r.length + r.width;
    if (!(r.length > 0 && r.width > 0) || glm::length(p[2] - (p[0] + u + v)) > kSame * size) return std::nullopt;
    r.u = u / r.length;
    r.v = v / r.width;
    if (std::abs(glm::dot(r.u, r.v)) > kSame) return std::nullopt;
    r.corner = p[0];
    r.normal = glm::cross(r.u, r.v);
    return r;
}

bool areAlong(const dvec3& a, const dvec3& b) { return glm::length(glm::cross(a, b)) <= kSame; }

/// The interval that a rectangle covers along an axis, relative to `origin`.
std::array<double, 2> extent(const Rectangle& r, const dvec3& origin, const dvec3& axis) {
    const double from = glm::dot(r.corner - origin, axis);
    const double along = r.length * glm::dot(r.u, axis) + r.width * glm::dot(r.v, axis);
    return {std::min(from, from + along), std::max(from, from + along)};
}

/// The primitive for parallel planes, x and y apart along the planes, z across. Logarithms are taken relative to `scale`, which
/// does not change the sum but keeps more digits.
double parallelTerm(double x, double y, double z, double scale) {
    const double acrossX = std::sqrt(x * x + z * z), acrossY = std::sqrt(y * y + z * z);
    double term = 0;
    if (acrossX > 0) term += y * acrossX * std::atan(y / acrossX);
    if (acrossY > 0) term += x * acrossY * std::atan(x / acrossY);
    if (z > 0) term -= 0.5 * z * z * std::log((x * x + y * y + z * z) / scale);
    return term;
}

/// For perpendicular planes: y apart along their common line; x and z are distances from it, each in one plane.
double perpendicularTerm(double x, double y, double z, double scale) {
    const double across = std::sqrt(x * x + z * z), square = x * x + z * z + y * y;
    double term = 0;
    if (across > 0) term += y * across * std::atan(y / across);
    if (square > 0) term -= 0.25 * (x * x + z * z - y * y) * std::log(square / scale);
    return term;
}

template <typename Term>
double sumOverCorners(const Term& term) {
    double sum = 0;
    for (int i = 0; i < 16; ++i) {
        const int a = i & 1, b = i >> 1 & 1, c = i >> 2 & 1, d = i >> 3 & 1;
        sum += ((a + b + c + d) % 2 ? -1 : 1) * term(a, b, c, d);
    }
    return sum / (2 * glm::pi<double>());
}

} // namespace

std::optional<double> rectangleExchange(const Polygon& a, const Polygon& b) {
    const std::optional<Rectangle> one = rectangleOf(a), two = rectangleOf(b);
    if (!one || !two) return std::nullopt;
    const dvec3 middle = 0.5 * (a[0] + a[2]), apart = 0.5 * (b[0] + b[2]) - middle;
    const double areas = one->length * one->width * two->length * two->width;
    const double scale = glm::dot(apart, apart);
    if (!(scale <= kFarthest * std::sqrt(areas))) return std::nullopt;

    if (areAlong(one->normal, two->normal)) {
        if (!areAlong(one->u, two->u) && !areAlong(one->u, two->v)) return std::nullopt;
        const auto x1 = extent(*one, middle, one->u), y1 = extent(*one, middle, one->v);
        const auto x2 = extent(*two, middle, one->u), y2 = extent(*two, middle, one->v);
        const double z = std::abs(glm::dot(apart, one->normal));
        return sumOverCorners(
            [&](int i, int j, int k, int l) { return parallelTerm(x1[i] - x2[k], y1[j] - y2[l], z, scale); });
    }
    if (std::abs(glm::dot(one->normal, two->normal)) > kSame) return std::nullopt;
    // y along the common line; x in the plane of the first, z in that of the second, away from the line.
    const dvec3 y = glm::normalize(glm::cross(one->normal, two->normal));
    if (!(areAlong(y, one->u) || areAlong(y, one->v)) || !(areAlong(y, two->u) || areAlong(y, two->v)))
        return std::nullopt;
    const dvec3 onLine = b[0] - glm::dot(b[0] - a[0], one->normal) * one->normal; // a point of the common line
    const auto x1 = extent(*one, onLine, two->normal), z2 = extent(*two, onLine, one->normal);
    const auto y1 = extent(*one, onLine, y), y2 = extent(*two, onLine, y);
    // A distance below the tolerance is 0: the corner lies in the other plane.
    const auto away = [&](double height) { return height <= kSame * std::sqrt(scale) ? 0.0 : height; };
    return sumOverCorners(
        [&](int i, int j, int k, int l) { return perpendicularTerm(away(x1[i]), y1[j] - y2[k], away(z2[l]), scale); });
}

} // namespace shadowlab::radiosity
