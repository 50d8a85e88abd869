// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/planar/probe/probe.h"
#include "techniques/probed/plane_probe.h"

namespace shadowlab::planar {

namespace {

// Directions of the infinitesimal shift where the line passes an edge or a corner (simulation of simplicity): any that are
// parallel to nothing in a typical scene.
constexpr dvec3 kAside{0.5413, 0.3117, 0.7809}, kFurtherAside{-0.2903, 0.8747, 0.3881};

bool isLeftOf(const dvec3& way, const dvec3& p, const dvec3& q) {
    const dvec3 normal = glm::cross(p, q);
    for (const dvec3& direction : {way, kAside, kFurtherAside})
        if (const double side = glm::dot(direction, normal); side != 0) return side > 0;
    return false;
}

/// Where the line from the origin along `way` meets a triangle: the corners' weights. None where it passes by.
std::optional<dvec3> weightsOf(const dvec3& way, const std::array<dvec3, 3>& p) {
    const bool left = isLeftOf(way, p[0], p[1]);
    if (isLeftOf(way, p[1], p[2]) != left || isLeftOf(way, p[2], p[0]) != left) return std::nullopt;
    const dvec3 weights(glm::dot(way, glm::cross(p[1], p[2])), glm::dot(way, glm::cross(p[2], p[0])),
                        glm::dot(way, glm::cross(p[0], p[1])));
    const double sum = weights.x + weights.y + weights.z;
    if (sum == 0) return std::nullopt; // the line lies in the triangle's plane
    return weights / sum;
}

} // namespace

PlaneProbe probePlane(const scene::Scene& scene, const Casters& casters, const ChosenReceiver& receiver,
                      const gl::EyeMatrices& eye, const dvec4& lightWorld, const dvec3& pointWorld) {
    PlaneProbe probe;
    probe.lightWorld = lightWorld;
    const scene::Object& object = scene.objects[receiver.receiver.object];
    probe.planeWorld = planeOf(*receiver.receiver.face, scene::worldFromMesh(object));
    probe.lightHeight = glm::dot(probe.planeWorld, lightWorld);
    if (probe.lightHeight < 0) {
        probe.planeWorld = -probe.planeWorld;
        probe.lightHeight = -probe.lightHeight;
    }
    const dvec4 lightView = eye.viewFromWorld * lightWorld;
    const auto projection = projectOnto(receiver.planeView, lightView, reachOf(lightView, receiver.frameView));
    const dvec3 way = dvec3(lightWorld) - pointWorld * lightWorld.w;
    for (const Caster& caster : casters.all()) {
        const scene::Object& casting = scene.objects[caster.object];
        const double contact = projection ? contactHeight(*projection, eye, eye.viewFromWorld * caster.worldFromMesh,
                                                          caster.farthestMesh, receiver.unevenness)
                                          : receiver.unevenness;
        probe.contact = std::max(probe.contact, contact);
        for (std::uint32_t t = 0; t < casting.mesh->triangles.size(); ++t) {
            PlaneProbe::Cover cover;
            std::array<dvec3, 3> fromPoint{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = casting.mesh->triangles[t][static_cast<int>(i)];
                cover.cornersWorld[i] =
                    transformPoint(caster.worldFromMesh, dvec3(casting.mesh->positionsMesh[vertex]));
                fromPoint[i] = cover.cornersWorld[i] - pointWorld;
            }
            const auto weights = weightsOf(way, fromPoint);
            if (!weights) continue;
            const bool isHole = caster.hasHoles && scene::isInHole(scene, casting, t, *weights);
            for (std::size_t i = 0; i < 3; ++i)
                cover.placeWorld += (*weights)[static_cast<int>(i)] * cover.cornersWorld[i];
            cover.object = casting.name;
            cover.triangle = t;
            cover.height = glm::dot(probe.planeWorld, dvec4(cover.placeWorld, 1.0));
            cover.weight = probe.lightHeight - lightWorld.w * cover.height;
            if (isHole)
                cover.why = "it is a hole there";
            else if (cover.weight <= 0)
                cover.why = "it is beyond the light: w' is not positive, its image would be an anti-shadow";
            else if (cover.height < -contact)
                cover.why = "it is below the plane: N.P + D is negative, its image would be an anti-shadow";
            else if (cover.height <= contact)
                cover.why = "it lies in the plane";
            cover.casts = cover.why.empty();
            probe.covers.push_back(std::move(cover));
        }
    }
    std::ranges::stable_sort(probe.covers, {}, &PlaneProbe::Cover::height);
    return probe;
}

} // namespace shadowlab::planar
