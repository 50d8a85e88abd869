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

    /// The unit normal there, turned to the viewer's side.
    [[nodiscard]] dvec3 towardWorld(const dvec3& toViewerWorld, const SurfacePoint& point) const;
    /// Of a triangle's corners a, b and c: the normals that are interpolated, as long as they come out.
    [[nodiscard]] std::array<vec3, 3> ofCornersWorld(const SurfacePoint& point) const;

private:
    /// Unit normals of a triangle's corners, of an object whose scale stretches them.
    [[nodiscard]] std::array<dvec3, 3> stretchedWorld(const SurfacePoint& point) const;
    [[nodiscard]] std::uint32_t objectOf(const SurfacePoint& point) const { return tracer_->world().objects[point.primitive]; }

    const SceneTracer* tracer_;
    std::vector<dmat3> normalWorldFromMesh_; ///< per object
    std::vector<bool> stretchesNormals_;     ///< per object (scene/query/normal_transform.h)
};

} // namespace shadowlab::trace
