// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/covering_spheres.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

namespace {

// Halves are covered apart if the discs that one sees of their spheres together have at most this share of the area of that of the whole: two halves of a
// long thing have half of it, those of a ball more than all.
constexpr double kWorthTwo = 0.7;

// At most 2^4 spheres: the density of each direction is a sum over all of them.
constexpr int kMostDivisions = 4;

/// The part of the sphere of all directions in which a sphere is seen, 1 - cos of half the angle: 2 pi times that is its solid angle, sr. From without.
double capHeight(double radius, double distance) {
    const double sine = radius / distance;
    return sine * sine / (1 + std::sqrt(1 - sine * sine)); // without cancellation, however small
}

} // namespace

CoveringSpheres::CoveringSpheres(const scene::Object& object) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    std::vector<Facet> facets;
    for (const uvec3& corners : object.mesh->triangles) {
        Facet facet{};
        for (int i = 0; i < 3; ++i)
            facet.cornersWorld[i] = dvec3(worldFromMesh * dvec4(object.mesh->positionsMesh[corners[i]], 1));
        facet.area = glm::length(areaVector({facet.cornersWorld[0], facet.cornersWorld[1], facet.cornersWorld[2]}));
        facets.push_back(facet);
    }
    if (facets.empty()) return;
    cover(facets, around(facets), kMostDivisions);
    double area = 0;
    for (const Sphere& sphere : spheres_)
        area += sphere.share;
    for (Sphere& sphere : spheres_)
        sphere.share /= area;
}

/// Around the middle of their box; `share` is their area, m^2.
CoveringSpheres::Sphere CoveringSpheres::around(std::span<const Facet> facets) {
    dvec3 lower(INFINITY), upper(-INFINITY);
    Sphere sphere;
    for (const Facet& facet : facets) {
        sphere.share += facet.area;
        for (const dvec3& corner : facet.cornersWorld)
            lower = glm::min(lower, corner), upper = glm::max(upper, corner);
    }
    sphere.centreWorld = 0.5 * (lower + upper);
    for (const Facet& facet : facets)
        for (const dvec3& corner : facet.cornersWorld)
            sphere.radius = std::max(sphere.radius, glm::distance(corner, sphere.centreWorld));
    return sphere;
}

void CoveringSpheres::cover(std::span<Facet> facets, const Sphere& sphere, int divisions) {
    if (divisions > 0 && facets.size() > 1) {
        dvec3 lower(INFINITY), upper(-INFINITY);
        for (const Facet& facet : facets)
            lower = glm::min(lower, facet.middle()), upper = glm::max(upper, facet.middle());
        const dvec3 size = upper - lower;
        const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const double middle = 0.5 * (lower[longest] + upper[longest]);
        const std::span<Facet> second = std::ranges::partition(facets, [&](const Facet& facet) { return facet.middle()[longest] < middle; });
        const std::span<Facet> first = facets.first(facets.size() - second.size());
        const Sphere a = around(first), b = around(second);
        if (a.radius * a.radius + b.radius * b.radius < kWorthTwo * sphere.radius * sphere.radius) {
            cover(first, a, divisions - 1);
            cover(second, b, divisions - 1);
            return;
        }
    }
    spheres_.push_back(sphere);
}

bool CoveringSpheres::hold(const dvec3& positionWorld) const {
    return std::ranges::any_of(spheres_, [&](const Sphere& sphere) { return glm::distance(positionWorld, sphere.centreWorld) <= sphere.radius; });
}

double CoveringSpheres::discs() const {
    double area = 0;
    for (const Sphere& sphere : spheres_)
        area += glm::pi<double>() * sphere.radius * sphere.radius;
    return area;
}

std::optional<dvec3> CoveringSpheres::direction(const dvec3& fromWorld, double which, const dvec2& where) const {
    const Sphere* chosen = &spheres_.back();
    for (const Sphere& sphere : spheres_) {
        chosen = &sphere;
        if ((which -= sphere.share) < 0) break;
    }
    const dvec3 way = chosen->centreWorld - fromWorld;
    const double distance = glm::length(way);
    if (distance <= chosen->radius) return std::nullopt;
    const dvec3 axis = way / distance, u = perpendicularTo(axis), v = glm::cross(axis, u);
    const double height = where.x * capHeight(chosen->radius, distance), turn = glm::two_pi<double>() * where.y;
    return (1 - height) * axis + std::sqrt(height * (2 - height)) * (std::cos(turn) * u + std::sin(turn) * v);
}

double CoveringSpheres::density(const dvec3& fromWorld, const dvec3& direction) const {
    double sum = 0;
    for (const Sphere& sphere : spheres_) {
        const dvec3 way = sphere.centreWorld - fromWorld, aside = glm::cross(way, direction);
        const double distance = glm::length(way);
        if (distance > sphere.radius && glm::dot(way, direction) > 0 && glm::dot(aside, aside) <= sphere.radius * sphere.radius)
            sum += sphere.share / (glm::two_pi<double>() * capHeight(sphere.radius, distance));
    }
    return sum;
}

} // namespace shadowlab::radiosity
