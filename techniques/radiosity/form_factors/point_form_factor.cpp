// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/point_form_factor.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

namespace {

/// Terms of the continued fraction below. The next one would change it by less than ((sqrt(1 + z) - 1) / (sqrt(1 + z) + 1))^kTerms,
/// which is 2e-16 at kLargestTangent: less than a double can tell.
constexpr std::size_t kTerms = 11;
constexpr double kLargestTangent = 0.4;

/// Coefficients of z^0, z^1 ...
using Coefficients = std::array<double, kTerms / 2 + 1>;
struct Quotient {
    Coefficients above{}, below{};
};

/// atan(t) / t of z = t^2, as Gauss's continued fraction 1 / (1 + z / (3 + 4 z / (5 + 9 z / (7 + ...)))) made one fraction (C. F. Gauss,
/// Disquisitiones generales circa seriem infinitam, 1813): each convergent is made of the two before.
consteval Quotient arcTangentByTangent() {
    const auto next = [](double b, const Coefficients& last, double a, const Coefficients& before) { // b last + a z before
        Coefficients sum{};
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] = b * last[i] + (i > 0 ? a * before[i - 1] : 0);
        return sum;
    };
    Quotient before{{0}, {1}}, last{{1}, {1}};
    for (std::size_t n = 1; n < kTerms; ++n) {
        const auto b = static_cast<double>(2 * n + 1), a = static_cast<double>(n * n);
        const Quotient found{next(b, last.above, a, before.above), next(b, last.below, a, before.below)};
        before = last;
        last = found;
    }
    return last;
}

double valueAt(const Coefficients& coefficients, double z) {
    double value = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;)
        value = value * z + coefficients[i];
    return value;
}

/// The angle of the direction (x, y) against the x-axis, divided by y > 0. Most edges are seen under small angles, and the library's
/// atan2, which is right to the last digit for all, had been a third of the time of a picture.
double angleBySine(double y, double x) {
    static constexpr Quotient kQuotient = arcTangentByTangent();
    if (y > kLargestTangent * x) return std::atan2(y, x) / y;
    const double z = (y / x) * (y / x);
    return valueAt(kQuotient.above, z) / (valueAt(kQuotient.below, z) * x);
}

} // namespace

// [anchor: form-factor-of-a-point]
double pointFormFactor(const dvec3& position, const dvec3& normal, const Polygon& polygon) {
    if (polygon.isEmpty()) return 0;
    double sum = 0;
    dvec3 from = polygon[polygon.count() - 1] - position;
    for (const dvec3& corner : polygon.corners()) {
        const dvec3 to = corner - position;
        // Seen from its front the polygon runs counter-clockwise, so `to` x `from` is the inward normal of the plane through an
        // edge and the point.
        const dvec3 across = glm::cross(to, from);
        const double size = glm::length(across); // |to| |from| sin of the angle
        // By the tangent, because the cosine of a small angle has no digits left.
        if (size > 0) sum += angleBySine(size, glm::dot(to, from)) * glm::dot(normal, across);
        from = to;
    }
    return sum / (2 * glm::pi<double>());
}

} // namespace shadowlab::radiosity
