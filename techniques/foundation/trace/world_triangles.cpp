// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/world_triangles.h"

#include <algorithm>

#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::trace {

WorldTriangles worldTriangles(const scene::Scene& scene) {
    WorldTriangles all;
    scene::Bounds bounds;
    for (const scene::Object& object : scene.objects)
        bounds.include(scene::boundsWorld(object));
    if (!bounds.isEmpty()) all.originWorld = 0.5 * (bounds.lowerWorld + bounds.upperWorld);

    for (std::uint32_t index = 0; index < scene.objects.size(); ++index) {
        const scene::Object& object = scene.objects[index];
        all.firstOfObject.push_back(static_cast<std::uint32_t>(all.triangles.size()));
        dmat4 centredFromMesh = object.worldFromObject;
        const dvec3 originOfMesh = dmat3(object.worldFromObject) * object.mesh->originObject;
        centredFromMesh[3] = dvec4((dvec3(object.worldFromObject[3]) - all.originWorld) + originOfMesh, 1.0);
        std::vector<dvec3> positionsCentred;
        positionsCentred.reserve(object.mesh->positionsMesh.size());
        for (const vec3& positionMesh : object.mesh->positionsMesh)
            positionsCentred.push_back(transformPoint(centredFromMesh, dvec3(positionMesh)));
        for (const uvec3& t : object.mesh->triangles)
            all.triangles.push_back({positionsCentred[t.x], positionsCentred[t.y], positionsCentred[t.z]});
        all.objects.resize(all.triangles.size(), index);
    }
    return all;
}

Holes::Holes(const scene::Scene& scene, const WorldTriangles& world) : scene_(&scene), world_(&world) {
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        for (std::size_t p = 0; p < object.mesh->parts.size(); ++p) {
            if (!scene::maskOfPart(scene, object, p)) continue;
            perforated_.resize(world.triangles.size(), 0); // zeros at the first call, no effect later
            const scene::MeshPart& part = object.mesh->parts[p];
            std::fill_n(perforated_.begin() + world.firstOfObject[o] + part.firstTriangle, part.triangleCount, 1);
        }
    }
}

bool Holes::isInHole(std::uint32_t primitive, const dvec3& barycentric) const {
    return scene::isInHole(*scene_, scene_->objects[world_->objects[primitive]], world_->triangleInMesh(primitive), barycentric);
}

} // namespace shadowlab::trace
