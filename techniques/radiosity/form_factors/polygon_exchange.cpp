// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/polygon_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "techniques/radiosity/form_factors/outline_exchange.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/form_factors/rectangle_exchange.h"

namespace shadowlab::radiosity {

namespace {

// Points and weights of Gauss quadrature on 0..1, for two, three and four points.
constexpr int kFewest = 2, kMost = 4;
struct GaussPoint {
    double place, weight;
};
constexpr std::array<std::array<GaussPoint, kMost>, kMost + 1> kGauss = {{
    {},
    {},
    {{{0.21132486540518712, 0.5}, {0.78867513459481288, 0.5}}},
    {{{0.11270166537925831, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074169, 5.0 / 18}}},
    {{{0.069431844202973712, 0.17392742256872693},
      {0.33000947820757187, 0.32607257743127307},
      {0.66999052179242813, 0.32607257743127307},
      {0.93056815579702629, 0.17392742256872693}}},
}};

// The form factor from a point is a sum of angles, each rounded at 2^-53 of a turn or less: changes below this share of a piece's
// area are noise, and subdividing does not reduce them.
constexpr double kNoise = 4e-15;

// Near the end of a common edge a halving gains about two bits; twenty halvings leave 1e-12.
constexpr int kMostHalvings = 20;

// Plates that nearly lie on each other would need a piece for every point of their rims. After so many pieces the rest is taken
// as it is, and the error reports it.
constexpr int kMostPieces = 1 << 14;
// So many cost about as much as the way along the outlines.
constexpr int kFewPieces = 16;

/// A piece of a polygon: four corners; those of a triangle have the last one twice.
using Quad = std::array<dvec3, 4>;

/// The integral of the form factor to `target` over a quad, by n x n points: exact for polynomials of degree 2 n - 1 in each of
/// the quad's own coordinates.
double integral(const Quad& q, const dvec3& normal, const Polygon& target, int n) {
    const auto& points = kGauss[static_cast<std::size_t>(n)];
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const auto [s, weightS] = points[static_cast<std::size_t>(i)];
            const auto [t, weightT] = points[static_cast<std::size_t>(j)];
            const dvec3 alongS = glm::mix(q[1] - q[0], q[2] - q[3], t), alongT = glm::mix(q[3] - q[0], q[2] - q[1], s);
            const dvec3 point = glm::mix(glm::mix(q[0], q[1], s), glm::mix(q[3], q[2], s), t);
            sum += weightS * weightT * glm::dot(normal, glm::cross(alongS, alongT)) *
                   pointFormFactor(point, normal, target);
        }
    return sum;
}

/// How many points in each direction are certainly enough; nothing where the polygons are too near for that. The form factor is
/// an analytic function of the point up to the other polygon, so the error of n points falls as the 2 n-th power of the radius of
/// the piece over twice its distance; the unknown constant before that is covered by a tenth of the tolerance.
std::optional<int> pointsAtDistance(const Polygon& a, const Polygon& b, double tolerance) {
    const auto middle = [](const Polygon& p) {
        dvec3 sum(0.0);
        for (const dvec3& corner : p.corners())
            sum += corner;
        return sum / static_cast<double>(p.count());
    };
    const auto radius = [](const Polygon& p, const dvec3& from) {
        double most = 0;
        for (const dvec3& corner : p.corners())
            most = std::max(most, glm::distance(corner, from));
        return most;
    };
    const dvec3 middleA = middle(a), middleB = middle(b);
    const double radiusA = radius(a, middleA);
    const double apart = glm::distance(middleA, middleB) - radius(b, middleB);
    if (!(apart > radiusA)) return std::nullopt;
    const double ratio = 0.5 * radiusA / apart;
    for (int n = kFewest; n <= kMost; ++n)
        if (std::pow(ratio * ratio, n) <= 0.1 * tolerance) return n;
    return std::nullopt;
}

std::array<Quad, 4> quarters(const Quad& q) {
    const dvec3 below = 0.5 * (q[0] + q[1]), right = 0.5 * (q[1] + q[2]), above = 0.5 * (q[2] + q[3]),
                left = 0.5 * (q[3] + q[0]), middle = 0.25 * (q[0] + q[1] + q[2] + q[3]);
    return {Quad{q[0], below, middle, left}, Quad{below, q[1], right, middle}, Quad{middle, right, q[2], above},
            Quad{left, middle, above, q[3]}};
}

/// Quarters a piece as long as that changes the sum by more than the piece's share of the tolerance.
void refine(const Quad& q, const dvec3& normal, const Polygon& target, double whole, double allowed, int halvings,
            int& pieces, Exchange& sum) {
    const std::array<Quad, 4> parts = quarters(q);
    std::array<double, 4> values{};
    double together = 0;
    for (std::size_t i = 0; i < 4; ++i)
        together += values[i] = integral(parts[i], normal, target, kMost);
    const double change = std::abs(together - whole);
    const double area = glm::length(glm::cross(q[2] - q[0], q[3] - q[1])) / 2;
    if (change <= std::max(allowed, kNoise * area) || halvings == 0 || pieces <= 0) {
        sum.area += together;
        sum.error += change;
        return;
    }
    pieces -= 4;
    // The change is the error of the coarser sum, some hundred times the error that remains, and most pieces end far below the
    // tolerance; so a half of it, not a quarter, is passed on.
    for (std::size_t i = 0; i < 4; ++i)
        refine(parts[i], normal, target, values[i], 0.5 * allowed, halvings - 1, pieces, sum);
}

Polygon relativeTo(const dvec3& origin, const Polygon& polygon) {
    Polygon moved;
    for (const dvec3& corner : polygon.corners())
        moved.add(corner - origin);
    return moved;
}

/// The part of each polygon before the other's plane; empty where nothing is. Positions are relative to a corner of the first:
/// far from the origin the points of a small piece would be rounded so much that subdivision never converges.
struct Facing {
    Polygon a, b;
    dvec3 normalA{0.0};
    Facing(const Polygon& farA, const Polygon& farB) {
        const Polygon wholeA = relativeTo(farA[0], farA), wholeB = relativeTo(farA[0], farB);
        const Plane planeA = planeOf(wholeA), planeB = planeOf(wholeB);
        const double touching = kTouching * (sizeOf(wholeA) + sizeOf(wholeB));
        a = partBefore(planeB, wholeA, touching);
        b = partBefore(planeA, wholeB, touching);
        normalA = planeA.normal;
    }
    [[nodiscard]] bool isEmpty() const { return a.isEmpty() || b.isEmpty(); }
};

/// By at most so many pieces: none are left where they did not suffice.
Exchange integrate(const Facing& facing, double tolerance, int& pieces) {
    const Polygon &a = facing.a, &b = facing.b;
    const double least = std::min(glm::length(areaVector(a)), glm::length(areaVector(b)));
    std::array<Quad, Polygon::kMostCorners> quads{};
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < a.count(); i += 2)
        quads[count++] = {a[0], a[i], a[i + 1], i + 2 < a.count() ? a[i + 2] : a[i + 1]};
    std::array<double, Polygon::kMostCorners> values{};
    double together = 0;
    const std::optional<int> enough = pointsAtDistance(a, b, tolerance);
    for (std::size_t i = 0; i < count; ++i)
        together += values[i] = integral(quads[i], facing.normalA, b, enough.value_or(kMost));
    if (enough) return {together, tolerance * together};
    const double allowed = tolerance * together + kNoise * least;
    Exchange sum;
    for (std::size_t i = 0; i < count; ++i)
        refine(quads[i], facing.normalA, b, values[i], allowed, kMostHalvings, pieces, sum);
    return sum;
}

Exchange byManyPieces(const Facing& facing, double tolerance) {
    int pieces = kMostPieces;
    return integrate(facing, tolerance, pieces);
}

} // namespace

Exchange exchangeByQuadrature(const Polygon& a, const Polygon& b, double tolerance) {
    const Facing facing(a, b);
    return facing.isEmpty() ? Exchange() : byManyPieces(facing, tolerance);
}

Exchange unoccludedExchange(const Polygon& a, const Polygon& b, double tolerance) {
    // It is the same both ways. Over a wide ground what a box receives is nearly all from beside its foot, and sums over all of the ground would
    // be rounded more than that; over the box it is smooth.
    const bool isLarger = glm::length(areaVector(a)) > glm::length(areaVector(b));
    const Facing facing(isLarger ? b : a, isLarger ? a : b);
    if (facing.isEmpty()) return {};
    if (const auto closed = rectangleExchange(facing.a, facing.b)) return {*closed, 1e-12 * *closed};
    // Where a few pieces do, they are quicker; where polygons touch, outlines are, a hundred times.
    int pieces = kFewPieces;
    const Exchange byFew = integrate(facing, tolerance, pieces);
    if (pieces > 0) return byFew;
    if (const auto found = exchangeByOutlines(facing.a, facing.b, tolerance)) return *found;
    return byManyPieces(facing, tolerance);
}

} // namespace shadowlab::radiosity
