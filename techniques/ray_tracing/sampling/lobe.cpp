// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/lobe.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::ray_tracing {

namespace {

/// Two unit vectors perpendicular to the axis and to each other. T. Duff and others, "Building an Orthonormal Basis, Revisited",
/// Journal of Computer Graphics Techniques 2017.
void basisAround(const dvec3& axis, dvec3& first, dvec3& second) {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1.0 / (sign + axis.z), b = axis.x * axis.y * a;
    first = {1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    second = {b, sign + axis.y * axis.y * a, -axis.y};
}

} // namespace

double lobePower(double halfDegrees) {
    if (halfDegrees >= 90) return 0; // the cosine there is 6e-17, not 0
    return std::log(0.5) / std::log(std::cos(glm::radians(halfDegrees)));
}

dvec2 onDisc(dvec2 numbers) {
    const dvec2 p = 2.0 * numbers - 1.0;
    if (p == dvec2(0.0)) return p;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double radius = wide ? p.x : p.y;
    const double angle = wide ? glm::quarter_pi<double>() * (p.y / p.x)
                              : glm::half_pi<double>() - glm::quarter_pi<double>() * (p.x / p.y);
    return radius * dvec2(std::cos(angle), std::sin(angle));
}

dvec3 lobeDirection(const dvec3& axis, double power, dvec2 numbers) {
    // Uniform points of the disc have the density 2 r dr; so 1 - r^2 is uniform, and cos = (1 - r^2)^(1 / (n + 1)).
    const dvec2 disc = onDisc(numbers);
    const double r2 = std::min(1.0, glm::dot(disc, disc));
    const double cosine = std::pow(1.0 - r2, 1.0 / (power + 1.0));
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    dvec3 first, second;
    basisAround(axis, first, second);
    if (r2 == 0) return axis;
    const dvec2 around = disc / std::sqrt(r2);
    return glm::normalize(sine * around.x * first + sine * around.y * second + cosine * axis);
}

} // namespace shadowlab::ray_tracing
