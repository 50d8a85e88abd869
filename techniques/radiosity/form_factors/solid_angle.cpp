// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/solid_angle.h"

#include <cmath>

namespace shadowlab::radiosity {

double solidAngle(const Polygon& polygon, const dvec3& point) {
    double sum = 0;
    for (std::size_t i = 2; i < polygon.count(); ++i) {
        const dvec3 a = polygon[0] - point, b = polygon[i - 1] - point, c = polygon[i] - point;
        const double lengthA = glm::length(a), lengthB = glm::length(b), lengthC = glm::length(c);
        // The product of all three; with edges in place of b and c nothing is lost for a small triangle far away.
        const double product = -glm::dot(a, glm::cross(b - a, c - a));
        const double rest = lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC + glm::dot(a, c) * lengthB +
                            glm::dot(b, c) * lengthA;
        sum += 2 * std::atan2(product, rest);
    }
    return sum;
}

} // namespace shadowlab::radiosity
