// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/coincident/placed_triangle.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/query/mesh_rounding.h"

namespace shadowlab::scene {

namespace {

/// Do all corners of `a` lie in the plane of `b`, give or take the rounding of both?
bool liesInPlane(const PlacedTriangle& a, const PlacedTriangle& b, double roundingOfBoth) {
    const dvec3 slope = glm::abs(b.normal);
    const double slack = (slope.x + slope.y + slope.z) * roundingOfBoth; // both sides times the length of the normal
    return std::ranges::all_of(a.cornersWorld, [&](const dvec3& corner) {
        return std::abs(glm::dot(b.normal, corner - b.cornersWorld[0])) <= slack;
    });
}

/// Is there an edge of `first` that has all of `second` beyond it? Touching along it, or overlapping by rounding, is beyond.
bool isSeparated(const PlacedTriangle& first, const PlacedTriangle& second, int axis) {
    const auto flat = [axis](const dvec3& p) { return dvec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec2 from = flat(first.cornersWorld[i]), to = flat(first.cornersWorld[(i + 1) % 3]);
        const dvec2 across(to.y - from.y, from.x - to.x);
        const auto beyond = [&](const dvec3& corner) { return glm::dot(across, flat(corner) - from); };
        const double own = beyond(first.cornersWorld[(i + 2) % 3]);
        const double slack = (std::abs(across.x) + std::abs(across.y)) * (first.rounding + second.rounding);
        if (std::ranges::all_of(second.cornersWorld,
                                [&](const dvec3& c) { return own > 0 ? beyond(c) <= slack : beyond(c) >= -slack; }))
            return true;
    }
    return false;
}

} // namespace

TrianglePlacer::TrianglePlacer(const Object& object) : mesh_(*object.mesh), worldFromMesh_(scene::worldFromMesh(object)) {
    // Six decimals are what most programs write into a mesh file. Of a mesh smaller than a metre such numbers are worth no more than a
    // millionth of it: else all of a very small one would be rounding.
    constexpr double kDecimals = 0.5e-6, kShare = 0x1p-20;
    vec3 farthestMesh(0.0f);
    for (const vec3& position : mesh_.positionsMesh)
        farthestMesh = glm::max(farthestMesh, glm::abs(position));
    const double largestMesh = std::max({farthestMesh.x, farthestMesh.y, farthestMesh.z});
    double scale = 0, ofOrigin = 0;
    for (int axis = 0; axis < 3; ++axis) {
        scale = std::max(scale, glm::length(dvec3(worldFromMesh_[axis])));
        ofOrigin = std::max(ofOrigin, std::abs(worldFromMesh_[3][axis]));
    }
    // One number for all axes: who turned a plane before writing it has left the rounding of the others in an axis that should be nought.
    doubleRounding_ = kDoubleRounding * (ofOrigin + scale * largestMesh);
    rounding_ = scale * std::max(kFloatRounding * largestMesh, std::min(kDecimals, kShare * largestMesh)) + doubleRounding_;
}

PlacedTriangle TrianglePlacer::operator()(std::uint32_t triangle) const {
    PlacedTriangle placed{.rounding = rounding_, .doubleRounding = doubleRounding_};
    for (int i = 0; i < 3; ++i) {
        const dvec3 positionWorld = transformPoint(worldFromMesh_, dvec3(mesh_.positionsMesh[mesh_.triangles[triangle][i]]));
        placed.cornersWorld[static_cast<std::size_t>(i)] = positionWorld;
        placed.box.include(positionWorld);
    }
    placed.box.lowerWorld -= rounding_;
    placed.box.upperWorld += rounding_;
    placed.normal = glm::cross(placed.cornersWorld[1] - placed.cornersWorld[0], placed.cornersWorld[2] - placed.cornersWorld[0]);
    return placed;
}

vec3 roughNormal(const PlacedTriangle& triangle) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(triangle.cornersWorld[i], triangle.cornersWorld[(i + 1) % 3]));
    const double area = glm::length(triangle.normal);
    if (!(2 * triangle.rounding * longest < kTurned * area)) return vec3(0.0f);
    return vec3(triangle.normal / area);
}

int mainAxis(const dvec3& normal) {
    const dvec3 steep = glm::abs(normal);
    return steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
}

bool coincide(const PlacedTriangle& a, const PlacedTriangle& b) {
    const double rounding = a.rounding + b.rounding;
    if (!liesInPlane(a, b, rounding) && !liesInPlane(b, a, rounding)) return false;
    const int axis = mainAxis(a.normal);
    return !isSeparated(a, b, axis) && !isSeparated(b, a, axis);
}

double gapBetween(const PlacedTriangle& a, const PlacedTriangle& b) {
    const auto gap = [](const PlacedTriangle& from, const PlacedTriangle& plane) {
        double most = 0;
        for (const dvec3& corner : from.cornersWorld)
            most = std::max(most, std::abs(glm::dot(plane.normal, corner - plane.cornersWorld[0])));
        return most / glm::length(plane.normal);
    };
    const double least = std::min(gap(a, b), gap(b, a)); // a small triangle says little of where its plane is far away
    return least <= 2 * (a.doubleRounding + b.doubleRounding) ? 0 : least;
}

} // namespace shadowlab::scene
