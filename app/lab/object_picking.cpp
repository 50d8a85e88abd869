// SPDX-License-Identifier: MIT
#include "app/lab/object_picking.h"

#include <algorithm>
#include <limits>

#include "techniques/foundation/scene/model/object_pieces.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::lab {

namespace {

/// Does the ray, of unit direction, meet the box? By its three pairs of planes (Kay and Kajiya 1986).
bool meets(const scene::Bounds& box, const dvec3& originWorld, const dvec3& directionWorld) {
    double nearest = 0, farthest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (directionWorld[axis] == 0) {
            if (originWorld[axis] < box.lowerWorld[axis] || originWorld[axis] > box.upperWorld[axis]) return false;
            continue;
        }
        const double toLower = (box.lowerWorld[axis] - originWorld[axis]) / directionWorld[axis],
                     toUpper = (box.upperWorld[axis] - originWorld[axis]) / directionWorld[axis];
        nearest = std::max(nearest, std::min(toLower, toUpper));
        farthest = std::min(farthest, std::max(toLower, toUpper));
    }
    return nearest <= farthest;
}

double extent(const scene::Bounds& box) {
    const dvec3 size = box.upperWorld - box.lowerWorld;
    return std::max(size.x, std::max(size.y, size.z));
}

} // namespace

std::optional<ObjectHit> objectAt(const scene::Scene& scene, const std::vector<scene::Bounds>& bounds,
                                  const scene::Camera& camera, ivec2 size, dvec2 pixel) {
    const dvec3 directionWorld = scene::rayDirectionWorld(camera, pixel, size);
    double nearest = std::numeric_limits<double>::infinity(); // along the ray, in metres
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (object.emitterOfLight >= 0 || bounds[i].isEmpty() || !meets(bounds[i], camera.positionWorld, directionWorld))
            continue;
        // In mesh space, where no vertex has to be transformed; the ray's parameter is the same there.
        const dmat4 meshFromWorld = glm::inverse(scene::worldFromMesh(object));
        const trace::ShearedRay ray({.originCentred = transformPoint(meshFromWorld, camera.positionWorld),
                                     .directionCentred = dvec3(meshFromWorld * dvec4(directionWorld, 0.0))});
        const std::vector<vec3>& corners = object.mesh->positionsMesh;
        for (const uvec3& triangle : object.mesh->triangles) {
            const trace::Triangle cornersMesh{dvec3(corners[triangle.x]), dvec3(corners[triangle.y]),
                                              dvec3(corners[triangle.z])};
            if (const auto hit = trace::intersect(ray, cornersMesh, nearest * ray.reachPerT)) {
                nearest = hit->reach / ray.reachPerT;
                found = i;
            }
        }
    }
    if (!found) return {};
    return ObjectHit{scene::piecesOf(scene, *found).first, camera.positionWorld + nearest * directionWorld};
}

bool isBackdrop(const std::vector<scene::Bounds>& bounds, std::size_t object) {
    constexpr double kShare = 0.5;
    scene::Bounds whole;
    for (const scene::Bounds& box : bounds)
        if (!box.isEmpty()) whole.include(box);
    return extent(bounds[object]) > kShare * extent(whole);
}

} // namespace shadowlab::lab
