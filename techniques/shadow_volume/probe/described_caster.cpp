// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/probe/described_caster.h"

#include <algorithm>

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/probe.h"

namespace shadowlab::shadow_volume {

VolumeProbe::Caster describedCaster(const scene::Scene& scene, const scene::Light& light, const CasterVolume& caster,
                                    const ShownVolume& shown, const VolumeEnd& end) {
    const scene::Object& object = scene.objects[caster.object];
    VolumeProbe::Caster described;
    described.object = caster.object;
    described.facing = scene::facingSigns(object, light);
    std::vector<SilhouetteEdge> silhouette;
    Volume volume = buildShown(object, light, caster, shown, silhouette);
    for (const SilhouetteEdge& edge : silhouette)
        described.outline.push_back({edge.a, edge.b, edge.triangles});
    described.topCap = std::move(volume.topCap);
    described.topCap.insert(described.topCap.end(), volume.topCapReversed.begin(), volume.topCapReversed.end());
    described.sides = std::move(volume.sides);
    described.bottomCap = std::move(volume.bottomCap);
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    described.extrudedWorld.reserve(object.mesh->positionsMesh.size());
    for (const vec3& position : object.mesh->positionsMesh)
        described.extrudedWorld.push_back(pushedWorld(transformPoint(worldFromMesh, dvec3(position)), light, end));
    described.distance = end.planeWorld ? std::nullopt : end.distance;
    described.endWorld = end.planeWorld;
    return described;
}

std::string casterText(const scene::Scene& scene, const VolumeProbe::Caster& caster) {
    const auto towardLight = std::ranges::count_if(caster.facing, [](std::int8_t sign) { return sign > 0; });
    return scene.objects[caster.object].name + ": " + std::to_string(towardLight) + " of " +
           std::to_string(caster.facing.size()) + " triangles face the light, " +
           std::to_string(caster.outline.size()) + " outline edges, extruded " +
           (caster.endWorld   ? "to a plane beyond all that receives its shadow"
            : caster.distance ? "by " + probeText(*caster.distance) + " m"
                              : "to infinity");
}

} // namespace shadowlab::shadow_volume
