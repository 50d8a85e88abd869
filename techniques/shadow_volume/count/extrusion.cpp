// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/extrusion.h"

#include "techniques/foundation/scene/query/facing.h"

namespace shadowlab::shadow_volume {

Extrusion extrusionOf(const scene::Object& object, const scene::Light& light, const VolumeEnd& end) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    Extrusion extrusion;
    extrusion.lightMesh = vec4(scene::lightMesh(object, light));
    // A plane is transformed by the transposed inverse of the points' matrix: mesh from world by that of world from mesh.
    if (end.planeWorld)
        extrusion.endMesh = vec4(glm::transpose(worldFromMesh) * *end.planeWorld);
    else
        extrusion.distance = static_cast<float>(end.distance.value_or(0.0));
    extrusion.worldFromMeshAxes = mat3(dmat3(worldFromMesh));
    return extrusion;
}

void setExtrusion(const gl::Program& program, const Extrusion& extrusion) {
    program.set("lightMesh", extrusion.lightMesh);
    program.set("endMesh", extrusion.endMesh);
    program.set("distance", extrusion.distance);
    program.set("worldFromMeshAxes", extrusion.worldFromMeshAxes);
}

std::vector<vec4> extrudedMesh(const scene::Mesh& mesh, const Extrusion& extrusion) {
    const auto& [lightMesh, endMesh, distance, worldFromMeshAxes] = extrusion;
    std::vector<vec4> vertices;
    vertices.reserve(2 * mesh.positionsMesh.size());
    for (const vec3& positionMesh : mesh.positionsMesh)
        vertices.emplace_back(positionMesh, 1.0f);
    for (const vec3& positionMesh : mesh.positionsMesh) {
        const vec3 awayMesh = positionMesh * lightMesh.w - vec3(lightMesh);
        vec4 farMesh(awayMesh, 0.0f);
        if (vec3(endMesh) != vec3(0.0f)) {
            const float toEnd =
                -(glm::dot(vec3(endMesh), positionMesh) + endMesh.w) / glm::dot(vec3(endMesh), awayMesh);
            farMesh = vec4(positionMesh + toEnd * awayMesh, 1.0f);
        } else if (distance > 0.0f) {
            const float stretch = distance / glm::length(worldFromMeshAxes * awayMesh);
            farMesh = vec4(positionMesh + stretch * awayMesh, 1.0f);
        }
        vertices.push_back(farMesh);
    }
    return vertices;
}

} // namespace shadowlab::shadow_volume
