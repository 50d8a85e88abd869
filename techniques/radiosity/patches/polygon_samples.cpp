// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/polygon_samples.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/math/radical_inverse.h"

namespace shadowlab::radiosity {

namespace {

dvec3 inTriangle(const dvec3& a, const dvec3& b, const dvec3& c, double s, double t) {
    return s + t > 1 ? a + (1 - s) * (b - a) + (1 - t) * (c - a)
                     : a + s * (b - a) + t * (c - a); // the square, folded along its diagonal
}

} // namespace

std::array<double, 4> hammersley4(int i, int count) {
    return {(i + 0.5) / count, radicalInverse(i + 1, 2), radicalInverse(i + 1, 3),
            radicalInverse(i + 1, 5)}; // starts with 1, so that no coordinate is 0
}

Place placeIn(const Polygon& p, double s, double t) {
    if (p.count() == 3) return {inTriangle(p[0], p[1], p[2], s, t), 1};
    if (p.count() == 4) {
        const dvec3 alongS = glm::mix(p[1] - p[0], p[2] - p[3], t), alongT = glm::mix(p[3] - p[0], p[2] - p[1], s);
        return {glm::mix(glm::mix(p[0], p[1], s), glm::mix(p[3], p[2], s), t), glm::length(glm::cross(alongS, alongT))};
    }
    // The square is cut into as many strips as the fan has triangles, and each point is weighted by its triangle's area.
    const auto triangles = static_cast<double>(p.count() - 2);
    const std::size_t i = std::min(p.count() - 3, static_cast<std::size_t>(s * triangles));
    return {inTriangle(p[0], p[i + 1], p[i + 2], s * triangles - static_cast<double>(i), t),
            triangles * glm::length(glm::cross(p[i + 1] - p[0], p[i + 2] - p[0]))};
}

dvec3 evenPlaceIn(const Polygon& p, double s, double t) {
    // Opposite edges of parallelograms are equal, but for the rounding of corners that are floats.
    const bool isEven = p.count() == 4 && glm::distance(p[1] - p[0], p[2] - p[3]) <= kTouching * glm::distance(p[0], p[2]);
    if (isEven || p.count() == 3) return placeIn(p, s, t).point;
    // Strips of the square for the triangles of the fan, each as wide as its triangle is large.
    const auto twice = [&](std::size_t i) { return glm::length(glm::cross(p[i + 1] - p[0], p[i + 2] - p[0])); };
    double all = 0;
    for (std::size_t i = 0; i + 2 < p.count(); ++i)
        all += twice(i);
    double left = s * all;
    std::size_t i = 0;
    for (; i + 3 < p.count() && left >= twice(i); ++i)
        left -= twice(i);
    return inTriangle(p[0], p[i + 1], p[i + 2], std::min(1.0, left / twice(i)), t);
}

} // namespace shadowlab::radiosity
