// SPDX-License-Identifier: MIT
#include "app/figures/drawing_plane.h"

#include <cmath>

namespace shadowlab::figures {

namespace {

// Below this sine two directions are one, for a drawing: some three degrees.
constexpr double kAligned = 0.05;

dvec3 acrossOf(const dvec3& direction) {
    return glm::normalize(glm::cross(direction, std::abs(direction.y) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
}

struct Arrival {
    dvec3 u, normalWorld, atWorld;
};
Arrival arrivalOf(const Probe& probe) {
    const Probe::Segment& eye = probe.geometry[static_cast<std::size_t>(probe.tree.front().segment)];
    return {glm::normalize(eye.toWorld - eye.fromWorld), probe.tree.front().normalWorld, eye.toWorld};
}

/// Unit, at right angles to the plane of incidence; where the ray comes along the normal, of an upright plane.
dvec3 planeNormal(const Arrival& arrival) {
    const dvec3 across = glm::cross(arrival.u, arrival.normalWorld);
    return glm::length(across) > kAligned ? glm::normalize(across) : acrossOf(arrival.u);
}

/// `upward`, as far as it lies in the plane, and the axis that has the eye on the left.
DrawingPlane planeWith(const Arrival& arrival, const dvec3& normal, const dvec3& upward) {
    DrawingPlane plane;
    plane.originWorld = arrival.atWorld;
    plane.upWorld = glm::normalize(upward - glm::dot(upward, normal) * normal);
    plane.rightWorld = glm::cross(plane.upWorld, normal);
    if (glm::dot(arrival.u, plane.rightWorld) < 0) plane.rightWorld = -plane.rightWorld;
    return plane;
}

} // namespace

DrawingPlane planeOfIncidence(const Probe& probe) {
    const Arrival arrival = arrivalOf(probe);
    const dvec3 normal = planeNormal(arrival);
    const dvec3 up(0, 1, 0);
    const bool upright = glm::length(glm::cross(up, normal)) > 4 * kAligned;
    return planeWith(arrival, normal, upright ? up : -arrival.u + acrossOf(arrival.u) * 1e-3);
}

DrawingPlane planeWithNormalUp(const Probe& probe) {
    const Arrival arrival = arrivalOf(probe);
    return planeWith(arrival, planeNormal(arrival), arrival.normalWorld);
}

std::vector<dvec2> cut(const scene::Scene& scene, const DrawingPlane& plane) {
    const dvec3 normal = plane.normalWorld();
    std::vector<dvec2> segments;
    for (const scene::Object& object : scene.objects) {
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        std::vector<dvec3> positionsWorld;
        std::vector<double> heights; // above the plane
        for (const vec3& position : object.mesh->positionsMesh) {
            positionsWorld.push_back(transformPoint(worldFromMesh, dvec3(position)));
            heights.push_back(glm::dot(positionsWorld.back() - plane.originWorld, normal));
        }
        for (const uvec3& triangle : object.mesh->triangles) {
            std::vector<dvec2> crossings;
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
                if ((heights[a] < 0) == (heights[b] < 0)) continue; // a corner in the plane counts as above it
                const double share = heights[a] / (heights[a] - heights[b]);
                crossings.push_back(plane.of(glm::mix(positionsWorld[a], positionsWorld[b], share)));
            }
            if (crossings.size() == 2) segments.insert(segments.end(), crossings.begin(), crossings.end());
        }
    }
    return segments;
}

} // namespace shadowlab::figures
