// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/outline_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

namespace {

// Gauss quadrature by six points on 0..1.
struct OutlinePoint {
    double place, weight;
};
constexpr std::array<OutlinePoint, 6> kPointsOfPiece = {{{0.033765242898423987, 0.085662246189585173},
                                               {0.16939530676686774, 0.18038078652406930},
                                               {0.38069040695840155, 0.23395696728634552},
                                               {0.61930959304159845, 0.23395696728634552},
                                               {0.83060469323313226, 0.18038078652406930},
                                               {0.96623475710157601, 0.085662246189585173}}};

// Toward a pole the error of a piece falls with the square of its length: twenty-five halvings leave 1e-15 of it.
constexpr int kMostHalvingsOfEdge = 25;

// Each term is rounded a few times, a logarithm's argument too: changes below this share of the terms are noise, and halving does not reduce
// them.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

// Poles are at the ends of edges: quads have thirty-two on both sides of theirs, which may each change the sum by so much of what is tolerated.
constexpr double kShareOfPiece = 1.0 / 64;

struct Edge {
    dvec3 from{0.0}, along{0.0}; ///< a unit vector
    double length = 0;
};

class Outline {
public:
    explicit Outline(const Polygon& polygon) {
        for (std::size_t i = 0; i < polygon.count(); ++i) {
            const dvec3 from = polygon[i], to = polygon[(i + 1) % polygon.count()];
            const double length = glm::distance(from, to);
            if (length > 0) edges_[count_++] = {from, (to - from) / length, length};
        }
    }
    [[nodiscard]] std::span<const Edge> edges() const { return {edges_.data(), count_}; }

private:
    std::array<Edge, Polygon::kMostCorners> edges_{};
    std::size_t count_ = 0;
};

double logarithm(double x) { return x > 0 ? std::log(x) : 0; } // where it is multiplied by zero

/// The integral of ln r along the edge, r being the distance from the point, plus the edge's length: around an outline these add up to nothing.
double logarithmAlong(const Edge& edge, const dvec3& point) {
    const dvec3 toPoint = point - edge.from;
    const double before = -glm::dot(toPoint, edge.along), after = edge.length + before; // of the ends, from the foot of the point
    const dvec3 across = glm::cross(toPoint, edge.along);
    const double heightSquared = glm::dot(across, across), height = std::sqrt(heightSquared);
    return 0.5 * (after * logarithm(after * after + heightSquared) - before * logarithm(before * before + heightSquared)) +
           height * std::atan2(height * edge.length, heightSquared + before * after);
}

struct Sum {
    double value = 0;
    double terms = 0; ///< the sum of their sizes: what they are rounded by grows with it
};

/// Over a piece of an edge of the one outline, and all of the other.
Sum alongPiece(const Edge& edge, double begin, double end, const Outline& other) {
    Sum sum;
    for (const auto [place, weight] : kPointsOfPiece) {
        const dvec3 point = edge.from + glm::mix(begin, end, place) * edge.along;
        for (const Edge& opposite : other.edges()) {
            const double cosine = glm::dot(edge.along, opposite.along);
            if (cosine == 0) continue;
            const double term = (end - begin) * weight * cosine * logarithmAlong(opposite, point);
            sum.value += term;
            sum.terms += std::abs(term);
        }
    }
    return sum;
}

/// Halves a piece as long as that changes the sum by more than is allowed. Toward a pole each halving divides the error by four, and elsewhere
/// by thousands: a third of the change is left at most.
void halve(const Edge& edge, double begin, double end, double whole, const Outline& other, double allowed, int halvings, Exchange& found) {
    const double middle = 0.5 * (begin + end);
    const Sum left = alongPiece(edge, begin, middle, other), right = alongPiece(edge, middle, end, other);
    const double change = std::abs(left.value + right.value - whole);
    if (change <= std::max(allowed, kRounding * (left.terms + right.terms)) || halvings == 0) {
        found.area += left.value + right.value;
        found.error += change / 3;
        return;
    }
    halve(edge, begin, middle, left.value, other, allowed, halvings - 1, found);
    halve(edge, middle, end, right.value, other, allowed, halvings - 1, found);
}

} // namespace

std::optional<Exchange> exchangeByOutlines(const Polygon& a, const Polygon& b, double tolerance) {
    constexpr double kWhole = 2 * glm::pi<double>();
    const Outline outline(a), other(b);
    std::array<double, Polygon::kMostCorners> coarse{};
    Sum all;
    for (std::size_t i = 0; i < outline.edges().size(); ++i) {
        const Sum ofEdge = alongPiece(outline.edges()[i], 0, outline.edges()[i].length, other);
        coarse[i] = ofEdge.value;
        all.value += ofEdge.value;
        all.terms += ofEdge.terms;
    }
    const double rounding = kRounding * all.terms;
    double expected = std::abs(all.value);
    // The coarse sum may be much too large; once more, then, with what has been found.
    for (int round = 0; round < 3; ++round) {
        if (rounding > 0.1 * tolerance * expected) return std::nullopt;
        Exchange found;
        for (std::size_t i = 0; i < outline.edges().size(); ++i)
            halve(outline.edges()[i], 0, outline.edges()[i].length, coarse[i], other, kShareOfPiece * tolerance * expected, kMostHalvingsOfEdge, found);
        if (found.area >= 0.5 * expected && found.error <= tolerance * found.area) return Exchange{found.area / kWhole, (found.error + rounding) / kWhole};
        expected = std::abs(found.area) / 2;
    }
    return std::nullopt;
}

} // namespace shadowlab::radiosity
