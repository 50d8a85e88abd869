// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/shading_normals.h"

#include "techniques/foundation/scene/query/normal_transform.h"

namespace shadowlab::trace {

ShadingNormals::ShadingNormals(const SceneTracer& tracer) : tracer_(&tracer) {
    for (const scene::Object& object : tracer.scene().objects) {
        const dmat3 worldFromObject(object.worldFromObject);
        normalWorldFromMesh_.push_back(glm::transpose(glm::inverse(worldFromObject)));
        stretchesNormals_.push_back(scene::stretchesNormals(worldFromObject));
        isMirrored_.push_back(scene::isMirrored(object));
    }
}

dvec3 ShadingNormals::towardWorld(const dvec3& toViewerWorld, const SurfacePoint& point) const {
    const scene::Mesh& mesh = *tracer_->objectOf(point).mesh;
    const uvec3 corners = mesh.triangles[tracer_->world().triangleInMesh(point.primitive)];
    const dvec3 weights = point.barycentric();
    if (stretchesNormals_[objectOf(point)]) {
        const std::array<dvec3, 3> ofCorners = stretchedWorld(point);
        const dvec3 normalWorld =
            glm::normalize(weights.x * ofCorners[0] + weights.y * ofCorners[1] + weights.z * ofCorners[2]);
        return turned(normalWorld, toViewerWorld, point);
    }
    const dvec3 normalMesh = weights.x * dvec3(mesh.normalsMesh[corners.x]) +
                             weights.y * dvec3(mesh.normalsMesh[corners.y]) +
                             weights.z * dvec3(mesh.normalsMesh[corners.z]);
    const dvec3 normalWorld = glm::normalize(normalWorldFromMesh_[objectOf(point)] * normalMesh);
    return turned(normalWorld, toViewerWorld, point);
}

dvec3 ShadingNormals::turned(const dvec3& normalWorld, const dvec3& toViewerWorld, const SurfacePoint& point) const {
    const bool isBehind = areOnFront(point) ? !isFrontSeen(point) : glm::dot(normalWorld, toViewerWorld) < 0;
    return isBehind ? -normalWorld : normalWorld;
}

std::array<dvec3, 3> ShadingNormals::stretchedWorld(const SurfacePoint& point) const {
    const scene::Mesh& mesh = *tracer_->objectOf(point).mesh;
    const uvec3 corners = mesh.triangles[tracer_->world().triangleInMesh(point.primitive)];
    std::array<dvec3, 3> normals;
    for (int i = 0; i < 3; ++i)
        normals[static_cast<std::size_t>(i)] =
            glm::normalize(normalWorldFromMesh_[objectOf(point)] * dvec3(mesh.normalsMesh[corners[i]]));
    return normals;
}

std::array<vec3, 3> ShadingNormals::ofCornersWorld(const SurfacePoint& point) const {
    if (stretchesNormals_[objectOf(point)]) {
        const std::array<dvec3, 3> normals = stretchedWorld(point);
        return {vec3(normals[0]), vec3(normals[1]), vec3(normals[2])};
    }
    const scene::Mesh& mesh = *tracer_->objectOf(point).mesh;
    const uvec3 corners = mesh.triangles[tracer_->world().triangleInMesh(point.primitive)];
    const mat3 normalWorldFromMesh(normalWorldFromMesh_[objectOf(point)]);
    return {normalWorldFromMesh * mesh.normalsMesh[corners.x], normalWorldFromMesh * mesh.normalsMesh[corners.y],
            normalWorldFromMesh * mesh.normalsMesh[corners.z]};
}

} // namespace shadowlab::trace
