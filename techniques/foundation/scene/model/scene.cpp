// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/scene.h"

#include <algorithm>
#include <atomic>

namespace shadowlab::scene {

std::uint64_t newRevision() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

std::string_view toText(EmittingSides sides) { return sides == EmittingSides::both ? "both" : "front"; }

std::size_t partOf(const Mesh& mesh, std::uint32_t triangle) {
    // The parts are in order and cover all triangles.
    const auto after = std::ranges::upper_bound(mesh.parts, triangle, {}, &MeshPart::firstTriangle);
    return static_cast<std::size_t>(after - mesh.parts.begin() - 1);
}

dmat4 worldFromMesh(const Object& object) {
    dmat4 worldFromMesh = object.worldFromObject;
    worldFromMesh[3] = object.worldFromObject * dvec4(object.mesh->originObject, 1.0);
    return worldFromMesh;
}

Bounds boundsWorld(const Object& object) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    Bounds bounds;
    for (const vec3& positionMesh : object.mesh->positionsMesh)
        bounds.include(transformPoint(worldFromMesh, dvec3(positionMesh)));
    return bounds;
}

std::vector<Bounds> objectBounds(const Scene& scene) {
    std::vector<Bounds> bounds;
    bounds.reserve(scene.objects.size());
    for (const Object& object : scene.objects)
        bounds.push_back(boundsWorld(object));
    return bounds;
}

bool isMirrored(const Object& object) { return glm::determinant(dmat3(object.worldFromObject)) < 0; }

const Material& materialOfTriangle(const Scene& scene, const Object& object, std::uint32_t triangle) {
    return scene.materials[object.partMaterials[partOf(*object.mesh, triangle)]];
}

std::uint64_t triangleCount(const Scene& scene) {
    std::uint64_t count = 0;
    for (const Object& object : scene.objects)
        count += object.mesh->triangles.size();
    return count;
}

} // namespace shadowlab::scene
