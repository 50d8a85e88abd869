// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/depth_fit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::scene {

namespace {

// For meshes with few triangles (floors, walls, boxes) the triangles are tested, for larger ones their box.
constexpr std::size_t kFitsEachTriangle = 64;

// The near plane stays this much before the nearest surface: far more than rounding, with no visible loss of precision.
constexpr double kClearance = 0.99;

/// View depth of the nearest point of a polygon within the sides and the near plane of the view; infinite if outside.
double nearestDepth(std::vector<dvec4> polygonClip) {
    // Left, right, bottom, top, near. In clip coordinates of a perspective projection w is the view depth.
    static constexpr std::array planes = {std::array{1.0, 0.0, 0.0}, std::array{-1.0, 0.0, 0.0},
                                          std::array{0.0, 1.0, 0.0}, std::array{0.0, -1.0, 0.0},
                                          std::array{0.0, 0.0, 1.0}};
    for (const auto& p : planes)
        polygonClip = clippedPolygon(polygonClip, dvec4(p[0], p[1], p[2], 1.0));
    double nearest = std::numeric_limits<double>::infinity();
    for (const dvec4& corner : polygonClip)
        nearest = std::min(nearest, corner.w);
    return nearest;
}

double nearestOfBox(const Bounds& box, const dmat4& clipFromWorld, const dvec3& eyeWorld) {
    if (glm::all(glm::greaterThanEqual(eyeWorld, box.lowerWorld)) &&
        glm::all(glm::lessThanEqual(eyeWorld, box.upperWorld)))
        return 0;
    static constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& face : faces) {
        std::vector<dvec4> polygon;
        for (const int corner : face)
            polygon.push_back(clipFromWorld * dvec4(box.corner(corner), 1.0));
        nearest = std::min(nearest, nearestDepth(std::move(polygon)));
    }
    return nearest;
}

double nearestOfTriangles(const Object& object, const dmat4& clipFromWorld) {
    const dmat4 clipFromMesh = clipFromWorld * worldFromMesh(object);
    double nearest = std::numeric_limits<double>::infinity();
    for (const uvec3& t : object.mesh->triangles) {
        std::vector<dvec4> polygon;
        for (const std::uint32_t v : {t.x, t.y, t.z})
            polygon.push_back(clipFromMesh * dvec4(dvec3(object.mesh->positionsMesh[v]), 1.0));
        nearest = std::min(nearest, nearestDepth(std::move(polygon)));
    }
    return nearest;
}

/// View depth of the nearest corner of a box, in view or not.
double leastDepth(const Bounds& box, const dmat4& clipFromWorld) {
    const dvec4 row(clipFromWorld[0].w, clipFromWorld[1].w, clipFromWorld[2].w, clipFromWorld[3].w);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i)
        least = std::min(least, glm::dot(row, dvec4(box.corner(i), 1.0)));
    return least;
}

} // namespace

Camera withTightNear(const Camera& camera, const Scene& scene, std::span<const Bounds> bounds, double aspect) {
    const dmat4 clipFromWorld = clipFromView(camera, aspect) * viewFromWorld(camera);
    // Boxes are sorted from near to far: once a box begins behind the nearest point found, no later box has a nearer one.
    // Rounding is far less than the clearance.
    std::vector<std::pair<double, std::size_t>> beginning(bounds.size());
    for (std::size_t o = 0; o < bounds.size(); ++o)
        beginning[o] = {leastDepth(bounds[o], clipFromWorld), o};
    std::ranges::sort(beginning);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [depth, o] : beginning) {
        if (depth > nearest) break;
        nearest = std::min(nearest, scene.objects[o].mesh->triangles.size() <= kFitsEachTriangle
                                        ? nearestOfTriangles(scene.objects[o], clipFromWorld)
                                        : nearestOfBox(bounds[o], clipFromWorld, camera.positionWorld));
    }
    Camera tight = camera;
    if (nearest < std::numeric_limits<double>::infinity()) tight.near = std::max(camera.near, kClearance * nearest);
    return tight;
}

double nearestInView(const Camera& camera, const Scene& scene, double aspect, double most) {
    const dmat4 clipFromWorld = clipFromView(camera, aspect) * viewFromWorld(camera);
    for (const Object& object : scene.objects) {
        const dmat4 clipFromMesh = clipFromWorld * worldFromMesh(object);
        const dvec4 depthRow(clipFromMesh[0].w, clipFromMesh[1].w, clipFromMesh[2].w, clipFromMesh[3].w);
        std::vector<double> depths(object.mesh->positionsMesh.size());
        std::ranges::transform(object.mesh->positionsMesh, depths.begin(),
                               [&](const vec3& position) { return glm::dot(depthRow, dvec4(dvec3(position), 1.0)); });
        for (const uvec3& t : object.mesh->triangles) {
            const auto [least, largest] = std::minmax({depths[t.x], depths[t.y], depths[t.z]});
            if (least >= most || largest <= 0) continue;
            std::vector<dvec4> polygon;
            for (const std::uint32_t v : {t.x, t.y, t.z})
                polygon.push_back(clipFromMesh * dvec4(dvec3(object.mesh->positionsMesh[v]), 1.0));
            most = std::min(most, nearestDepth(std::move(polygon)));
        }
    }
    return most;
}

double farDepth(std::span<const Bounds> bounds, const dmat4& viewFromWorld, double near) {
    constexpr double kBeyond = 1.001;
    double far = 2 * near;
    for (const Bounds& box : bounds)
        for (int i = 0; i < 8; ++i)
            far = std::max(far, -kBeyond * transformPoint(viewFromWorld, box.corner(i)).z);
    return far;
}

} // namespace shadowlab::scene
