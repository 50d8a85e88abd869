// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/solid_angle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

double solidAngle(const Polygon& polygon, const dvec3& point) {
    double sum = 0;
    for (std::size_t i = 2; i < polygon.count(); ++i) {
        const dvec3 a = polygon[0] - point, b = polygon[i - 1] - point, c = polygon[i] - point;
        const double lengthA = glm::length(a), lengthB = glm::length(b), lengthC = glm::length(c);
        // The triple product of the three vectors, computed with edges in place of b and c: no cancellation for small triangles
        // far away.
        const double product = -glm::dot(a, glm::cross(b - a, c - a));
        const double rest = lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC + glm::dot(a, c) * lengthB +
                            glm::dot(b, c) * lengthA;
        sum += 2 * std::atan2(product, rest);
    }
    return sum;
}

namespace {

// Pieces of the smooth edge for quadrature, shorter toward its inner end: where the edge begins at the axis, phi changes by
// nearly a right angle close to that end.
constexpr int kParts = 16;

/// Gauss quadrature with four points: exact for polynomials of degree 7.
template <typename Function>
double integralOf(double from, double to, const Function& function) {
    constexpr std::array<double, 2> kPlaces = {0.33998104358485626, 0.86113631159405258},
                                    kWeights = {0.65214515486254614, 0.34785484513745386};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
        sum += kWeights[i] * (function(middle - half * kPlaces[i]) + function(middle + half * kPlaces[i]));
    return half * sum;
}

/// 1 - cos, without cancellation.
double versine(double angle) { return 2 * std::pow(std::sin(0.5 * angle), 2); }

/// G of the header.
double withinCone(const LightCone& cone, double theta) {
    const double inner = cone.half - cone.edge, outer = std::min(theta, cone.half);
    if (outer <= inner) return versine(outer);
    const auto arriving = [&](double angle) {
        const double t = (cone.half - angle) / cone.edge;
        return t * t * (3 - 2 * t) * std::sin(angle);
    };
    const double middle = 0.5 * (inner + outer); // with twice four points, 1e-7 even for a band of a right angle
    return versine(inner) + integralOf(inner, middle, arriving) + integralOf(middle, outer, arriving);
}

/// A great circle, by the unit normal of its plane: the components along the axis and perpendicular to it.
struct GreatCircle {
    double sine, cosine; ///< of delta
    [[nodiscard]] double phiAt(double theta) const {
        const double ratio = sine * std::cos(theta), all = cosine * std::sin(theta); // tan delta / tan theta
        return ratio < all ? std::acos(ratio / all) : 0;
    }
    [[nodiscard]] double thetaAt(double phi) const { return std::atan2(sine, cosine * std::cos(phi)); }
};

/// The integral of G from 0 to phi.
double upTo(const LightCone& cone, const GreatCircle& circle, double phi) {
    const double end = std::abs(phi), inner = cone.half - cone.edge, inside = std::min(end, circle.phiAt(inner));
    double sum = inside - std::asin(std::min(1.0, circle.cosine * std::sin(inside)));
    double from = inside;
    for (int i = 1; i <= kParts && cone.edge > 0 && from < end; ++i) {
        const double to = std::min(end, circle.phiAt(inner + cone.edge * i * i / (kParts * kParts)));
        if (to > from) sum += integralOf(from, to, [&](double p) { return withinCone(cone, circle.thetaAt(p)); });
        from = std::max(from, to);
    }
    sum += std::max(0.0, end - std::max(from, circle.phiAt(cone.half))) * withinCone(cone, cone.half);
    return std::copysign(sum, phi);
}

} // namespace

double coneSolidAngle(const LightCone& cone, const Polygon& polygon) {
    // Nothing behind the apex is lit, and all before it is less than a right angle from the axis.
    const Polygon before = partBefore({cone.apex, cone.axis}, polygon, 0);
    double sum = 0;
    for (std::size_t i = 0; i < before.count(); ++i) {
        const dvec3 from = before[i] - cone.apex, to = before[(i + 1) % before.count()] - cone.apex;
        const dvec3 normal = glm::cross(from, to);
        const double size = glm::length(normal);
        if (!(size > 0)) continue; // the edge points away from the apex
        const double along = glm::dot(normal, cone.axis) / size;
        const dvec3 aside = normal / size - along * cone.axis;
        const GreatCircle circle{std::abs(along), glm::length(aside)};
        // The direction in which the great circle is nearest to the axis. For a circle all around the axis, which the cut above
        // may produce, any direction will do.
        const dvec3 nearest = circle.cosine > 1e-12 ? aside * ((along > 0 ? -1.0 : 1.0) / circle.cosine)
                                                    : glm::normalize(from - glm::dot(from, cone.axis) * cone.axis);
        const dvec3 turned = glm::cross(cone.axis, nearest);
        const auto phi = [&](const dvec3& way) { return std::atan2(glm::dot(way, turned), glm::dot(way, nearest)); };
        // Counter-clockwise seen from the apex is clockwise about the axis.
        sum -= upTo(cone, circle, phi(to)) - upTo(cone, circle, phi(from));
    }
    return std::max(0.0, sum);
}

} // namespace shadowlab::radiosity
