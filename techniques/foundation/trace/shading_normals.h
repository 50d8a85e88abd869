// The shading normals of traced points: interpolated between those of the triangle's corners.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

class ShadingNormals {
public:
    /// The tracer must outlive this object, and keep its scene.
    explicit ShadingNormals(const SceneTracer& tracer);

    /// The unit normal there, on the side that is seen (shaders/shading_normal.glsl). Near the rim of a round body it may lean away from the viewer.
    [[nodiscard]] dvec3 towardWorld(const dvec3& toViewerWorld, const SurfacePoint& point) const;
    /// Does the side that is seen say which way the normal is turned? Else its own sign toward the viewer does.
    [[nodiscard]] bool areOnFront(const SurfacePoint& point) const { return tracer_->objectOf(point).mesh->normalsOnFront; }
    /// Is that side the front of the mesh?
    [[nodiscard]] bool isFrontSeen(const SurfacePoint& point) const { return point.eyeOnFront != isMirrored_[objectOf(point)]; }
    /// Of a triangle's corners a, b and c: the normals that are interpolated, as long as they come out.
    [[nodiscard]] std::array<vec3, 3> ofCornersWorld(const SurfacePoint& point) const;

private:
    [[nodiscard]] dvec3 turned(const dvec3& normalWorld, const dvec3& toViewerWorld, const SurfacePoint& point) const;
    /// Unit normals of a triangle's corners, of an object whose scale stretches them.
    [[nodiscard]] std::array<dvec3, 3> stretchedWorld(const SurfacePoint& point) const;
    [[nodiscard]] std::uint32_t objectOf(const SurfacePoint& point) const { return tracer_->world().objects[point.primitive]; }

    const SceneTracer* tracer_;
    std::vector<dmat3> normalWorldFromMesh_; ///< per object
    std::vector<bool> stretchesNormals_;     ///< per object (scene/query/normal_transform.h)
    std::vector<bool> isMirrored_;           ///< per object
};

} // namespace shadowlab::trace
