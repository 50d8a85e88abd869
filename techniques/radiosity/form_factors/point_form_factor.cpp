// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/point_form_factor.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::radiosity {

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
        // atan2, because the cosine of a small angle has no digits left.
        if (size > 0) sum += std::atan2(size, glm::dot(to, from)) * glm::dot(normal, across) / size;
        from = to;
    }
    return sum / (2 * glm::pi<double>());
}

} // namespace shadowlab::radiosity
