// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/polygon.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

dvec3 areaVector(const Polygon& polygon) {
    dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.count(); ++i)
        sum += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * sum;
}

bool hasNoArea(const Polygon& polygon) { return !(glm::length(areaVector(polygon)) > 0); }

dvec3 centroid(const Polygon& polygon) {
    const dvec3 unit = glm::normalize(areaVector(polygon));
    dvec3 sum(0.0);
    double area = 0;
    for (std::size_t i = 2; i < polygon.count(); ++i) {
        const double twice = glm::dot(unit, glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]));
        sum += twice / 3 * (polygon[i - 1] - polygon[0] + (polygon[i] - polygon[0]));
        area += twice;
    }
    return polygon[0] + sum / area;
}

Plane planeOf(const Polygon& polygon) { return {centroid(polygon), glm::normalize(areaVector(polygon))}; }

FaceFrame frameOf(const Polygon& polygon) {
    const dvec3 normal = areaVector(polygon), along = polygon[1] - polygon[0];
    if (!(glm::length(normal) > 0) || !(glm::length(along) > 0)) return {polygon[0], {}, {}};
    const dvec3 u = glm::normalize(along);
    return {polygon[0], u, glm::normalize(glm::cross(normal, u))};
}

bool holds(const Polygon& polygon, const dvec3& point, const dvec3& normal) {
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.count()];
        if (glm::dot(glm::cross(b - a, point - a), normal) < 0) return false;
    }
    return true;
}

trace::CentredBox boxOf(const Polygon& polygon) {
    trace::CentredBox box;
    for (const dvec3& corner : polygon.corners())
        box.include(corner);
    return box;
}

trace::CentredBox around(trace::CentredBox box, const trace::CentredBox& other) {
    box.include(other.lower);
    box.include(other.upper);
    return box;
}

double distanceBetween(const trace::CentredBox& a, const trace::CentredBox& b) {
    return glm::length(glm::max(dvec3(0), glm::max(a.lower - b.upper, b.lower - a.upper)));
}

double sizeOf(const Polygon& polygon) {
    const trace::CentredBox box = boxOf(polygon);
    return glm::length(box.upper - box.lower);
}

bool isBehind(const Plane& plane, const Polygon& polygon, double tolerance) {
    return std::ranges::all_of(polygon.corners(), [&](const dvec3& p) { return plane.height(p) <= tolerance; });
}

Polygon partBefore(const Plane& plane, const Polygon& polygon, double tolerance) {
    const auto height = [&](const dvec3& p) {
        const double h = plane.height(p);
        return std::abs(h) <= tolerance ? 0.0 : h;
    };
    Polygon kept;
    bool anyBefore = false;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.count()];
        const double heightA = height(a), heightB = height(b);
        anyBefore = anyBefore || heightA > 0;
        if (heightA >= 0) kept.add(a);
        if ((heightA > 0 && heightB < 0) || (heightA < 0 && heightB > 0))
            kept.add(a + heightA / (heightA - heightB) * (b - a));
    }
    return anyBefore ? kept : Polygon();
}

Polygon partWithin(const Polygon& outline, const dvec3& normal, Polygon part, double tolerance) {
    for (std::size_t i = 0; i < outline.count() && !part.isEmpty(); ++i) {
        const dvec3 inward = glm::normalize(glm::cross(normal, outline[(i + 1) % outline.count()] - outline[i]));
        part = partBefore({outline[i], inward}, part, tolerance);
    }
    return part;
}

/// The sum over edges of the area between an edge and the middle: of a triangle where the edge is within the circle, of a sector where it is not. Edges that
/// go clockwise around the middle count as negative.
double areaWithinCircle(const Polygon& polygon, const dvec3& middle, double radius) {
    const dvec3 normal = planeOf(polygon).normal;
    const double squared = radius * radius;
    double area = 0;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 from = polygon[i] - middle, way = polygon[(i + 1) % polygon.count()] - polygon[i];
        const double a = glm::dot(way, way), b = glm::dot(way, from), c = glm::dot(from, from) - squared;
        if (!(a > 0)) continue;
        const double root = std::sqrt(std::max(0.0, b * b - a * c)); // 0: the edge's line does not cross the circle
        std::array<double, 4> ends{0, std::clamp((-b - root) / a, 0.0, 1.0), std::clamp((-b + root) / a, 0.0, 1.0), 1};
        for (std::size_t part = 0; part < 3; ++part) {
            const dvec3 p = from + ends[part] * way, q = from + ends[part + 1] * way;
            const double across = glm::dot(normal, glm::cross(p, q));
            area += 0.5 * (part == 1 ? across : squared * std::atan2(across, glm::dot(p, q)));
        }
    }
    return std::max(0.0, area); // of a circle beside it, sectors cancel but for rounding
}

} // namespace shadowlab::radiosity
