// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/eye_line.h"

#include <algorithm>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::shadow_volume {

namespace {

// The box is enlarged by this share of its size: far more than the rounding of its corners.
constexpr double kAround = 1e-6;

// Of the product of the three lengths. Vertex positions reach the rasteriser as floats (2^-24) after a product of matrices;
// sixteen times that is a safe bound on their error.
constexpr double kGrazing = 0x1p-20;

// Directions of the infinitesimal shift (simulation of simplicity): any that are parallel to nothing in a typical mesh.
constexpr dvec3 kAside{0.5413, 0.3117, 0.7809}, kFurtherAside{-0.2903, 0.8747, 0.3881};

/// The line in a caster's mesh space, with the eye as the origin: it runs along `way`, for a point light until 1.
struct Line {
    dvec3 eyeMesh, way;
    const scene::Mesh& mesh;

    Line(const scene::Object& object, const scene::Light& light, const dvec3& eyeWorld)
        : eyeMesh(transformPoint(glm::inverse(scene::worldFromMesh(object)), eyeWorld)), mesh(*object.mesh) {
        const dvec4 lightMesh = scene::lightMesh(object, light);
        way = dvec3(lightMesh) - eyeMesh * lightMesh.w;
    }
    [[nodiscard]] dvec3 corner(std::uint32_t v) const { return dvec3(mesh.positionsMesh[v]) - eyeMesh; }
    /// On which side the line passes the edge from p to q; exactly the opposite for the edge from q to p.
    [[nodiscard]] bool isLeftOf(const dvec3& p, const dvec3& q) const {
        const dvec3 normal = glm::cross(p, q);
        for (const dvec3& direction : {way, kAside, kFurtherAside})
            if (const double side = glm::dot(direction, normal); side != 0) return side > 0;
        return false;
    }
    /// Counts the triangles that the line crosses. The light is on their front (`clockwise`: on their back), so the eye has
    /// to be on the other side.
    [[nodiscard]] int crossings(std::span<const std::uint32_t> cap, bool clockwise) const {
        int count = 0;
        for (std::size_t i = 0; i + 2 < cap.size(); i += 3) {
            const dvec3 a = corner(cap[i]), b = corner(cap[i + 1]), c = corner(cap[i + 2]);
            const bool left = isLeftOf(a, b);
            if (isLeftOf(b, c) != left || isLeftOf(c, a) != left) continue;
            const double eyeSide = -glm::dot(glm::cross(b - a, c - a), a);
            count += clockwise ? eyeSide > 0 : eyeSide < 0;
        }
        return count;
    }
};

} // namespace

bool eyeLineMayTouch(const scene::Bounds& box, const dvec3& eyeWorld, const dvec4& lightWorld) {
    const dvec3 way = dvec3(lightWorld) - eyeWorld * lightWorld.w;
    const dvec3 around(kAround * glm::length(box.upperWorld - box.lowerWorld));
    double enters = 0, leaves = lightWorld.w == 0 ? std::numeric_limits<double>::infinity() : 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double lower = box.lowerWorld[axis] - around[axis] - eyeWorld[axis];
        const double upper = box.upperWorld[axis] + around[axis] - eyeWorld[axis];
        if (way[axis] == 0) {
            if (lower > 0 || upper < 0) return false;
            continue;
        }
        const double first = lower / way[axis], second = upper / way[axis];
        enters = std::max(enters, std::min(first, second));
        leaves = std::min(leaves, std::max(first, second));
    }
    return enters <= leaves;
}

bool eyeMaySeeThrough(const scene::Scene& scene, const CasterVolume& caster) {
    return scene::hasHoles(scene, scene.objects[caster.object]);
}

int eyeCount(const scene::Scene& scene, const CasterVolume& caster, const VolumeEnd& end, const scene::Light& light,
             const dvec3& eyeWorld) {
    if (end.planeWorld && glm::dot(*end.planeWorld, dvec4(eyeWorld, 1.0)) > 0) return 0;
    if (!eyeLineMayTouch(caster.bounds, eyeWorld, scene::homogeneousPositionWorld(light))) return 0;
    const Line line(scene.objects[caster.object], light, eyeWorld);
    return line.crossings(caster.volume.topCap, false) + line.crossings(caster.volume.topCapReversed, true);
}

bool eyeLineGrazes(const scene::Scene& scene, const CasterVolume& caster, const scene::Light& light,
                   const dvec3& eyeWorld) {
    if (!eyeLineMayTouch(caster.bounds, eyeWorld, scene::homogeneousPositionWorld(light))) return false;
    const Line line(scene.objects[caster.object], light, eyeWorld);
    return std::ranges::any_of(caster.silhouette, [&](const SilhouetteEdge& edge) {
        const dvec3 a = line.corner(edge.a), b = line.corner(edge.b);
        return std::abs(glm::dot(line.way, glm::cross(a, b))) <=
               kGrazing * glm::length(line.way) * glm::length(a) * glm::length(b);
    });
}

} // namespace shadowlab::shadow_volume
