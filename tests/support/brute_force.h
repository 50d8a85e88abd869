// All triangles of a scene in world space, and lines through them: plain loops in double, by which what the program says can be
// checked without any of its own geometry.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

struct WorldTriangle {
    std::uint32_t object = 0, triangle = 0;
    std::array<dvec3, 3> cornersWorld{};
    [[nodiscard]] dvec3 normal() const {
        return glm::cross(cornersWorld[1] - cornersWorld[0], cornersWorld[2] - cornersWorld[0]);
    }
};

inline std::vector<WorldTriangle> allTriangles(const scene::Scene& scene) {
    std::vector<WorldTriangle> all;
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
            WorldTriangle one{o, t, {}};
            for (std::size_t i = 0; i < 3; ++i)
                one.cornersWorld[i] = dvec3(
                    worldFromMesh *
                    dvec4(dvec3(object.mesh->positionsMesh[object.mesh->triangles[t][static_cast<int>(i)]]), 1.0));
            all.push_back(one);
        }
    }
    return all;
}

/// Where a line meets a triangle's plane, and how far inside of the triangle: the least of the three weights, negative outside.
struct LineHit {
    double along = 0; ///< from + along * way
    double inside = -1;
};

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997. None where the line is parallel to the plane.
inline std::optional<LineHit> meets(const WorldTriangle& triangle, const dvec3& from, const dvec3& way) {
    const dvec3 edge1 = triangle.cornersWorld[1] - triangle.cornersWorld[0],
                edge2 = triangle.cornersWorld[2] - triangle.cornersWorld[0], p = glm::cross(way, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0) return std::nullopt;
    const dvec3 toFrom = from - triangle.cornersWorld[0], q = glm::cross(toFrom, edge1);
    const double u = glm::dot(toFrom, p) / determinant, v = glm::dot(way, q) / determinant;
    return LineHit{glm::dot(edge2, q) / determinant, std::min(std::min(u, v), 1 - u - v)};
}

/// The first triangle on a line beyond `least` (in units of `way`), of those that `wanted` says yes to. `clear`: no other
/// triangle's edge is so near that rounding could have chosen otherwise.
struct FirstHit {
    std::size_t index = 0;
    double along = 0;
    bool isClear = true;
};
template <typename Wanted>
std::optional<FirstHit> firstOn(const std::vector<WorldTriangle>& all, const dvec3& from, const dvec3& way,
                                double least, const Wanted& wanted) {
    constexpr double kNearEdge = 1e-9; // of a weight: double leaves 1e-15, times the ratio of a scene's sizes
    std::optional<FirstHit> first;
    double nearestDoubt = 1e300;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!wanted(all[i])) continue;
        const auto hit = meets(all[i], from, way);
        if (!hit || hit->along <= least) continue;
        if (std::abs(hit->inside) < kNearEdge) nearestDoubt = std::min(nearestDoubt, hit->along);
        if (hit->inside < 0) continue;
        if (!first || hit->along < first->along) first = FirstHit{i, hit->along, true};
    }
    if (first) first->isClear = nearestDoubt > first->along;
    if (!first && nearestDoubt < 1e300) return FirstHit{all.size(), nearestDoubt, false};
    return first;
}

/// The unit direction of the eye's ray through a point of the picture, rows from the top.
inline dvec3 eyeWay(const scene::Camera& camera, dvec2 pixel, ivec2 size) {
    const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.upWorld)), up = glm::cross(right, forward);
    const double halfHeight = std::tan(glm::radians(camera.fovYDegrees) / 2);
    const dvec2 across = (2.0 * pixel / dvec2(size) - 1.0) * dvec2(halfHeight * size.x / size.y, -halfHeight);
    return glm::normalize(forward + across.x * right + across.y * up);
}

} // namespace shadowlab::testing
