// SPDX-License-Identifier: MIT
#include "techniques/planar/flattening.h"

#include <algorithm>
#include <map>

namespace shadowlab::planar {

namespace {

/// The part of the picture in which the shadow of a box can fall; the whole picture if the shadow reaches infinity or
/// behind the eye.
scene::PicturePart partOfShadow(const scene::Bounds& box, const gl::EyeMatrices& eye, const Projection& projection) {
    scene::PicturePart part = scene::kNowhere;
    for (int i = 0; i < 8; ++i) {
        const dvec4 flattened = projection.flattenedFromView * (eye.viewFromWorld * dvec4(box.corner(i), 1.0));
        const dvec4 clip = eye.clipFromView * flattened;
        // A weight of less than a thousandth of the terms it is computed from: treated as infinitely far away.
        if (flattened.w < 1e-3 || clip.w < 1e-3 * std::abs(clip.z)) return {};
        part.lower = glm::min(part.lower, dvec2(clip) / clip.w);
        part.upper = glm::max(part.upper, dvec2(clip) / clip.w);
    }
    return part;
}

scene::PicturePart common(const scene::PicturePart& a, const scene::PicturePart& b) {
    return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

/// True if light and receiver lie on one side of a face of the box and the box on the other, so that nothing in it is
/// between them. So a floor casts no shadow on what stands on it, and rounding cannot draw one where they touch.
bool isApart(const scene::Bounds& box, const std::array<dvec3, 4>& frameWorld, const dvec4& lightWorld,
             double contact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const double face = sign < 0 ? -box.lowerWorld[axis] : box.upperWorld[axis];
            const bool lightBeyond = sign * lightWorld[axis] >= lightWorld.w * face;
            if (lightBeyond && std::ranges::all_of(frameWorld, [&](const dvec3& corner) {
                    return sign * corner[axis] >= face - contact;
                }))
                return true;
        }
    return false;
}

/// The triangles that pass by the light, of all casters in whose boxes it is: their numbers are indices of Casters::all().
using NearTriangles = std::map<std::size_t, std::vector<NearTriangle>>;

NearTriangles allNear(const scene::Scene& scene, const std::vector<Caster>& casters, const dvec4& lightWorld,
                      const scene::Light& light) {
    NearTriangles near;
    for (std::size_t i = 0; i < casters.size(); ++i)
        if (isWithin(lightWorld, casters[i])) {
            auto triangles = trianglesNear(lightWorld, casters[i], scene.objects[casters[i].object], light);
            if (!triangles.empty()) near[i] = std::move(triangles);
        }
    return near;
}

/// All triangles of a mesh but these.
std::vector<TriangleRun> without(const std::vector<NearTriangle>& left, std::size_t count) {
    std::vector<TriangleRun> runs;
    std::uint32_t first = 0;
    for (const NearTriangle& near : left) {
        if (near.triangle > first) runs.push_back({first, near.triangle - first});
        first = near.triangle + 1;
    }
    if (first < count) runs.push_back({first, static_cast<std::uint32_t>(count) - first});
    return runs;
}

/// Adds the half spaces behind the triangles that the light lies on, as far as the receiver reaches into them: they are in
/// shadow.
void addHiddenBehind(LitPlane& plane, const std::vector<NearTriangle>& near) {
    for (const NearTriangle& triangle : near)
        if (triangle.holdsLight && std::ranges::any_of(plane.receiver->frameWorld, [&](const dvec3& corner) {
                return glm::dot(triangle.planeWorld, dvec4(corner, 1.0)) < 0;
            }))
            plane.hiddenBehind.push_back(triangle.planeWorld);
}

struct FlattenedScene {
    const scene::Scene& scene;
    const Casters& casters;
    const gl::EyeMatrices& eye;
    dvec4 lightWorld;
    const PlanarParams& params;
    NearTriangles near;
};

void addCasters(LitPlane& plane, const FlattenedScene& all) {
    const auto& [scene, casters, eye, lightWorld, params, nearTriangles] = all;
    // The precision of a caster in the list depends on its distance from the middle. If that is not enough for its
    // vertices, or for the height at which it is clipped, it is drawn from its own mesh.
    constexpr double kExactEnough = 1.0 / (1 << 13);
    const bool cull = params.cull && !params.mayBeAnywhere();
    plane.contact = contactHeight(plane.projection, eye, eye.viewFromWorld * casters.worldFromCaster(),
                                  casters.farthestInList(), plane.receiver->unevenness);
    scene::PicturePart part = scene::kNowhere;
    for (std::size_t i = 0; i < casters.all().size(); ++i) {
        const Caster& caster = casters.all()[i];
        // Most of the plane's own object lies in the plane or behind it; without clipping its shadow would cover the plane.
        if (!params.clip && caster.object == plane.receiver->receiver.object) continue;
        const double contact = contactHeight(plane.projection, eye, eye.viewFromWorld * caster.worldFromMesh,
                                             caster.farthestMesh, plane.receiver->unevenness);
        if (params.clip && isApart(caster.boundsWorld, plane.receiver->frameWorld, lightWorld, contact)) continue;
        const auto near = nearTriangles.find(i);
        if (near != nearTriangles.end() && params.clip) addHiddenBehind(plane, near->second);
        if (cull && !mayShadow(caster.boundsWorld, eye, plane.projection, contact, plane.receiver->frameView)) continue;
        const bool frontsSuffice = cull && params.once && caster.outward && !isWithin(lightWorld, caster);
        const double size = glm::length(caster.boundsWorld.upperWorld - caster.boundsWorld.lowerWorld);
        ++plane.casters;
        part = around(part, partOfShadow(caster.boundsWorld, eye, plane.projection));
        if (caster.inList && near == nearTriangles.end() && plane.contact <= kExactEnough * size &&
            glm::length(caster.farthestCaster) <= kFarthestInSizes * size) {
            (frontsSuffice ? plane.frontsSuffice : plane.bothSides).add(caster);
            continue;
        }
        const std::size_t count = scene.objects[caster.object].mesh->triangles.size();
        plane.singles.push_back({i, contact, frontsSuffice,
                                 near == nearTriangles.end() ? without({}, count) : without(near->second, count)});
    }
    // With the stencil no face is drawn beyond the receiver, where another plane may have its number.
    if (!params.stencil)
        plane.part = {};
    else if (params.mayBeAnywhere() || !plane.hiddenBehind.empty())
        plane.part = plane.receiver->part;
    else
        plane.part = common(part, plane.receiver->part);
}

} // namespace

std::vector<LitPlane> litPlanes(const scene::Scene& scene, const std::vector<ChosenReceiver>& receivers,
                                const Casters& casters, const gl::EyeMatrices& eye, const dvec4& lightWorld,
                                const scene::Light& light, const PlanarParams& params, bool countTurnedAway) {
    const FlattenedScene all{scene, casters, eye, lightWorld, params, allNear(scene, casters.all(), lightWorld, light)};
    std::vector<LitPlane> planes;
    for (const ChosenReceiver& receiver : receivers) {
        LitPlane plane;
        plane.receiver = &receiver;
        const dvec4 lightView = eye.viewFromWorld * lightWorld;
        const auto projection =
            projectOnto(receiver.planeView, lightView, params.clip ? reachOf(lightView, receiver.frameView) : 0);
        // The eye is the origin of view space. Where it sees the side that the light does not, nothing is lit.
        plane.turnedAway = !projection || projection->planeView.w <= 0;
        if (plane.turnedAway && countTurnedAway) {
            plane.part = receiver.part;
            planes.push_back(std::move(plane));
            continue;
        }
        if (!projection || (plane.turnedAway && !params.mayBeAnywhere())) continue;
        plane.turnedAway = false;
        plane.projection = *projection;
        addCasters(plane, all);
        if (plane.casters > 0 || !plane.hiddenBehind.empty()) planes.push_back(std::move(plane));
    }
    return planes;
}

} // namespace shadowlab::planar
