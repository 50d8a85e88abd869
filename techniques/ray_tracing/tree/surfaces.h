// What shading and optics need at a hit: the material, normals, reflected light, and whether the surface encloses a solid.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/foundation/trace/shading_normals.h"
#include "techniques/ray_tracing/tree/dielectric_stack.h"

namespace shadowlab::ray_tracing {

class Surfaces {
public:
    /// The tracer must outlive this object, and keep its scene.
    explicit Surfaces(const trace::SceneTracer& tracer);

    [[nodiscard]] const trace::SceneTracer& tracer() const { return *tracer_; }
    [[nodiscard]] const scene::Scene& scene() const { return tracer_->scene(); }

    [[nodiscard]] const scene::Material& materialOf(const trace::SurfacePoint& point) const {
        return scene().materials[materials_[point.primitive]];
    }
    /// Diffuse reflectance at the point: the material's, or that of an image or of the vertices there.
    [[nodiscard]] vec3 diffuseOf(const trace::SurfacePoint& point) const;
    /// Has the surface not the same colour all over?
    [[nodiscard]] bool hasOwnColors(const trace::SurfacePoint& point) const { return ownColors_[objectOf(point)]; }
    /// Does the surface shine toward the viewer? Most emitters are dark on their back.
    [[nodiscard]] bool emitsHere(const trace::SurfacePoint& point) const;
    /// Emitted radiance toward the viewer.
    [[nodiscard]] vec3 emitted(const trace::SurfacePoint& point) const {
        return emitsHere(point) ? materialOf(point).emission : vec3(0.0f);
    }
    /// Radiance toward the viewer with all lights off.
    [[nodiscard]] vec3 lightsOff(const trace::SurfacePoint& point) const;
    /// The shading normal: interpolated between the vertices, turned to the viewer's side.
    [[nodiscard]] dvec3 normalWorld(const trace::SurfacePoint& point, const dvec3& toViewerWorld) const {
        return normals_.towardWorld(toViewerWorld, point);
    }
    [[nodiscard]] const trace::ShadingNormals& normals() const { return normals_; }
    /// The triangle's own normal, on the side that the ray came from.
    [[nodiscard]] dvec3 geometricNormalWorld(const trace::SurfacePoint& point) const;
    /// Reflected radiance toward the viewer of an unblocked light; `normalWorld` is normalWorld() there.
    [[nodiscard]] dvec3 lit(const trace::SurfacePoint& point, int light, const dvec3& positionWorld,
                            const dvec3& normalWorld, const dvec3& toViewerWorld) const;

    /// The same for a light with an area, from its irradiance (trace::AreaIrradiance, in units of pi times the light's radiance).
    /// Exact for diffuse reflection. Simplified: the highlight is that of the light's centre.
    [[nodiscard]] dvec3 litByArea(const trace::SurfacePoint& point, int light, double irradiance,
                                  const dvec3& positionWorld, const dvec3& normalWorld,
                                  const dvec3& toViewerWorld) const;

    /// Does a ray split here: is light reflected or transmitted?
    [[nodiscard]] bool splits(const trace::SurfacePoint& point) const {
        const scene::Material& material = materialOf(point);
        return material.reflectivity > 0 || material.transparency > 0;
    }
    /// Does a ray split anywhere in the scene?
    [[nodiscard]] bool anySplits() const { return anySplits_; }

    /// Does the surface enclose a transparent solid? Only a closed, consistently wound surface has an inside. Any other is a
    /// sheet: light passes straight through.
    [[nodiscard]] bool isSolid(const trace::SurfacePoint& point) const {
        return materialOf(point).transparency > 0 && outsides_[objectOf(point)] != Outside::unknown;
    }
    [[nodiscard]] Medium mediumOf(const trace::SurfacePoint& point) const {
        const scene::Material& material = materialOf(point);
        return {objectOf(point), material.priority, material.ior};
    }
    /// Does the ray enter the solid at this hit?
    [[nodiscard]] bool isEntered(const trace::SurfacePoint& point) const {
        return point.eyeOnFront == (outsides_[objectOf(point)] == Outside::front);
    }
    /// The solids that contain a point: those that a ray out of the scene leaves without having entered them.
    [[nodiscard]] DielectricStack mediaAround(const dvec3& positionCentred) const;

private:
    /// The side of an object's triangles, as they lie in the world, that is outside.
    enum class Outside : std::uint8_t { unknown, front, back };
    [[nodiscard]] Outside outsideOf(const scene::Object& object) const;
    [[nodiscard]] std::uint32_t objectOf(const trace::SurfacePoint& point) const {
        return tracer_->world().objects[point.primitive];
    }

    const trace::SceneTracer* tracer_;
    trace::ShadingNormals normals_;
    std::vector<std::uint32_t> materials_; ///< per triangle of the scene
    std::vector<bool> ownColors_;          ///< per object
    std::vector<Outside> outsides_;        ///< per object; determined only for transparent ones
    bool anySplits_ = false, anySolid_ = false;
};

} // namespace shadowlab::ray_tracing
