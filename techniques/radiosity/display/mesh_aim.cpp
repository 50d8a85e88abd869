// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/mesh_aim.h"

#include <algorithm>
#include <cmath>

#include "techniques/radiosity/display/gather_guide.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// A convex body is seen, in the mean over all directions, as a quarter of its surface (A. Cauchy). If that is less than this share of the discs of its spheres, points
// leave less noise: for a point of a ball the squared cosine there has 1 / 0.375 times the mean that its own mean has squared, and as much noise as directions of which
// so many meet something.
constexpr double kFull = 0.375;

} // namespace

MeshAim::MeshAim(const scene::Object& object) : spheres_(object) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    double area = 0;
    for (const uvec3& corners : object.mesh->triangles) {
        const auto corner = [&](int i) { return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[corners[i]])); };
        const Triangle triangle{corner(0), corner(1), corner(2)};
        area += glm::length(areaVector({triangle[0], triangle[1], triangle[2]}));
        triangles_.push_back(triangle);
        upTo_.push_back(area);
    }
    if (0.25 * area >= kFull * spheres_.discs()) {
        triangles_.clear();
        upTo_.clear();
    }
}

std::optional<MeshAim::Way> MeshAim::choose(const dvec3& fromWorld, double which, const dvec2& where) const {
    if (usesSpheres()) {
        const auto direction = spheres_.direction(fromWorld, which, where);
        if (!direction) return std::nullopt;
        return Way{*direction, 0, spheres_.density(fromWorld, *direction)};
    }
    const auto above = std::ranges::upper_bound(upTo_, which * upTo_.back());
    const Triangle& corners = triangles_[std::min(static_cast<std::size_t>(above - upTo_.begin()), triangles_.size() - 1)];
    const Polygon triangle{corners[0], corners[1], corners[2]};
    const dvec3 way = evenPlaceIn(triangle, where.x, where.y) - fromWorld, across = areaVector(triangle);
    const double distance = glm::length(way), cosine = std::abs(glm::dot(way, across)) / (distance * glm::length(across));
    if (!(distance > kContactDistance) || !(cosine > 0)) return std::nullopt;
    return Way{way / distance, distance, density(fromWorld, way / distance, distance, cosine)};
}

double MeshAim::density(const dvec3& fromWorld, const dvec3& direction, double distance, double cosineThere) const {
    return usesSpheres() ? spheres_.density(fromWorld, direction) : densityOfDirection(1 / upTo_.back(), distance, cosineThere);
}

} // namespace shadowlab::radiosity
