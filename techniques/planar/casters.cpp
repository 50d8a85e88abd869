// SPDX-License-Identifier: MIT
#include "techniques/planar/casters.h"

#include <algorithm>

#include "techniques/foundation/scene/casters.h"
#include "techniques/foundation/scene/facing.h"
#include "techniques/foundation/scene/holes.h"

namespace shadowlab::planar {

bool isWithin(const dvec4& lightWorld, const Caster& caster) {
    if (lightWorld.w <= 0) return false;
    const dvec3 lower = caster.boundsWorld.lowerWorld, upper = caster.boundsWorld.upperWorld;
    // Far more than double rounding, and than that of vertices, which are floats.
    const dvec3 margin = 1e-6 * (upper - lower + glm::max(glm::abs(lower), glm::abs(upper)));
    return glm::all(glm::lessThanEqual(lower - margin, dvec3(lightWorld))) &&
           glm::all(glm::lessThanEqual(dvec3(lightWorld), upper + margin));
}

bool Casters::buildNext(const scene::Snapshot& snapshot) {
    const scene::Revisions& now = snapshot->revisions;
    const bool same = made_.geometry == now.geometry && made_.transforms == now.transforms;
    if (!same || made_.materials != now.materials) list(*snapshot);
    if (!same || made_.materials != now.materials || made_.lights != now.lights) edgeOn_.clear();
    made_ = now;
    if (edgeOn_.size() == snapshot->lights.size()) return true;

    const scene::Light& light = snapshot->lights[edgeOn_.size()];
    std::vector<std::uint32_t> edgeOn;
    for (const Caster& caster : casters_) {
        if (caster.hasHoles || !isWithin(scene::homogeneousPositionWorld(light), caster)) continue;
        const std::vector<std::int8_t> facing = scene::facingSigns(snapshot->objects[caster.object], light);
        for (std::uint32_t t = 0; t < facing.size(); ++t)
            if (facing[t] == 0) edgeOn.push_back(caster.firstTriangle + t);
    }
    edgeOn_.push_back(std::move(edgeOn));
    return edgeOn_.size() == snapshot->lights.size();
}

const std::vector<std::uint32_t>& Casters::edgeOn(int light) const { return edgeOn_[static_cast<std::size_t>(light)]; }

void Casters::list(const scene::Scene& scene) {
    casters_.clear();
    positionsCaster_.clear();
    triangles_.clear();
    listRevision_ = scene::newRevision();
    scene::Bounds all;
    for (const std::size_t o : scene::allCasters(scene)) {
        const scene::Object& object = scene.objects[o];
        Caster caster;
        caster.object = o;
        caster.hasHoles = scene::hasHoles(scene, object);
        caster.outward = object.mesh->outward && !caster.hasHoles;
        caster.boundsWorld = scene::boundsWorld(object);
        all.include(caster.boundsWorld);
        casters_.push_back(caster);
    }
    std::ranges::stable_partition(casters_, [](const Caster& caster) { return caster.outward; });
    worldFromCaster_ = dmat4(1.0);
    if (!all.isEmpty()) worldFromCaster_[3] = dvec4(0.5 * (all.lowerWorld + all.upperWorld), 1.0);
    for (Caster& caster : casters_)
        add(scene.objects[caster.object], caster);
}

void Casters::add(const scene::Object& object, Caster& caster) {
    const scene::Mesh& mesh = *object.mesh;
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    caster.triangleCount = static_cast<std::uint32_t>(mesh.triangles.size());
    if (caster.hasHoles) {
        caster.worldFromCaster = worldFromMesh;
        for (const vec3& position : mesh.positionsMesh)
            caster.farthest = glm::max(caster.farthest, dvec3(glm::abs(position)));
        return;
    }
    caster.worldFromCaster = worldFromCaster_;
    caster.firstTriangle = static_cast<std::uint32_t>(triangles_.size());
    const auto firstVertex = static_cast<std::uint32_t>(positionsCaster_.size());
    for (const vec3& position : mesh.positionsMesh) {
        const dvec3 positionCaster = transformPoint(worldFromMesh, dvec3(position)) - dvec3(worldFromCaster_[3]);
        caster.farthest = glm::max(caster.farthest, glm::abs(positionCaster));
        positionsCaster_.emplace_back(positionCaster);
    }
    const bool mirrored = scene::isMirrored(object);
    for (const uvec3& t : mesh.triangles)
        triangles_.push_back(firstVertex + (mirrored ? uvec3(t.x, t.z, t.y) : t));
}

} // namespace shadowlab::planar
