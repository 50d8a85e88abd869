// What shading and optics want to know about the place where a ray ended: its material, its normals, what it sends back of
// each light, and whether there is a solid behind it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/ray_tracing/tree/dielectric_stack.h"

namespace shadowlab::ray_tracing {

class Surfaces {
public:
    /// The tracer must outlive it, and stay at the same scene.
    explicit Surfaces(const trace::SceneTracer& tracer);

    [[nodiscard]] const trace::SceneTracer& tracer() const { return *tracer_; }
    [[nodiscard]] const scene::Scene& scene() const { return tracer_->scene(); }

    [[nodiscard]] const scene::Material& materialOf(const trace::SurfacePoint& point) const {
        return scene().materials[materials_[point.primitive]];
    }
    /// A rect light's surface is dark on its back.
    [[nodiscard]] bool emitsHere(const trace::SurfacePoint& point) const;
    /// What it sends toward the viewer of its own.
    [[nodiscard]] vec3 emitted(const trace::SurfacePoint& point) const {
        return emitsHere(point) ? materialOf(point).emission : vec3(0.0f);
    }
    /// What it sends toward the viewer with all lights off.
    [[nodiscard]] vec3 lightsOff(const trace::SurfacePoint& point) const;
    /// The shading normal: interpolated between the corners, turned to the viewer's side.
    [[nodiscard]] dvec3 normalWorld(const trace::SurfacePoint& point, const dvec3& toViewerWorld) const;
    /// Of the triangle itself, on the side that the ray came from.
    [[nodiscard]] dvec3 geometricNormalWorld(const trace::SurfacePoint& point) const;
    /// What it sends toward the viewer of a light that it sees; `normalWorld` is normalWorld() there.
    [[nodiscard]] dvec3 lit(const trace::SurfacePoint& point, int light, const dvec3& positionWorld,
                            const dvec3& normalWorld, const dvec3& toViewerWorld) const;

    /// The same for a light with an area that brings the point that irradiance (trace::AreaIrradiance, in parts of pi times the
    /// light's radiance). Exact for what is diffuse. Simplified: a highlight is that of the light's centre.
    [[nodiscard]] dvec3 litByArea(const trace::SurfacePoint& point, int light, double irradiance,
                                  const dvec3& positionWorld, const dvec3& normalWorld,
                                  const dvec3& toViewerWorld) const;

    /// Does a ray split here: is any light mirrored, or let through?
    [[nodiscard]] bool splits(const trace::SurfacePoint& point) const {
        const scene::Material& material = materialOf(point);
        return material.reflectivity > 0 || material.transparency > 0;
    }
    /// Does it anywhere in the scene?
    [[nodiscard]] bool anySplits() const { return anySplits_; }

    /// Does the surface enclose a solid that light passes through? Only a closed surface, wound alike all over, tells what
    /// is inside. Any other is a sheet: light passes straight through.
    [[nodiscard]] bool isSolid(const trace::SurfacePoint& point) const {
        return materialOf(point).transparency > 0 && outsides_[objectOf(point)] != Outside::unknown;
    }
    [[nodiscard]] Medium mediumOf(const trace::SurfacePoint& point) const {
        const scene::Material& material = materialOf(point);
        return {objectOf(point), material.priority, material.ior};
    }
    /// Does a ray that ends there come from outside the solid?
    [[nodiscard]] bool isEntered(const trace::SurfacePoint& point) const {
        return point.eyeOnFront == (outsides_[objectOf(point)] == Outside::front);
    }
    /// The solids around a place. A ray is sent from it out of the scene: what it leaves and never entered is around it.
    [[nodiscard]] DielectricStack mediaAround(const dvec3& positionCentred) const;

private:
    /// On which side of an object's triangles (as they lie in the world) is the outside?
    enum class Outside : std::uint8_t { unknown, front, back };
    [[nodiscard]] Outside outsideOf(const scene::Object& object) const;
    [[nodiscard]] std::uint32_t objectOf(const trace::SurfacePoint& point) const {
        return tracer_->world().objects[point.primitive];
    }
    [[nodiscard]] std::uint32_t triangleOf(const trace::SurfacePoint& point) const {
        return point.primitive - tracer_->world().firstOfObject[objectOf(point)];
    }

    const trace::SceneTracer* tracer_;
    std::vector<std::uint32_t> materials_;   ///< per triangle of the scene
    std::vector<dmat3> normalWorldFromMesh_; ///< per object
    std::vector<Outside> outsides_;          ///< per object; looked for only where something is transparent
    bool anySplits_ = false, anySolid_ = false;
};

} // namespace shadowlab::ray_tracing
