// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/holes.h"

#include <algorithm>

#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::trace {

Holes::Holes(const scene::Scene& scene, const WorldTriangles& world) : scene_(&scene), world_(&world) {
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Object& object = scene.objects[o];
        for (std::size_t p = 0; p < object.mesh->parts.size(); ++p) {
            if (!scene::maskOfPart(scene, object, p)) continue;
            perforated_.resize(world.triangles.size(), 0); // all zero, the first time; then as it is
            const scene::MeshPart& part = object.mesh->parts[p];
            std::fill_n(perforated_.begin() + world.firstOfObject[o] + part.firstTriangle, part.triangleCount, 1);
        }
    }
}

bool Holes::isInHole(std::uint32_t primitive, const dvec3& barycentric) const {
    const std::uint32_t object = world_->objects[primitive];
    return scene::isInHole(*scene_, scene_->objects[object], primitive - world_->firstOfObject[object], barycentric);
}

} // namespace shadowlab::trace
