// A light of the scene as patches see it: what it sends to a point or a patch with nothing in between, and along which lines.
//
// Such a light is no patch: its surface, if it has one, neither blocks nor reflects. What it sends is the first shot of the solution,
// and exact where a closed form is known:
//   point        a patch of area A gets I Omega / A on average, Omega being its solid angle (solid_angle.h)
//   spot         the same with what of Omega lies within its cone (cone_solid_angle.h)
//   directional  I cos
//   rect         pi L F by Lambert's formula (point_form_factor.h), of a patch by the exchange of two polygons
//   sphere       pi L (r / d)^2 cos, as a point light of intensity pi r^2 L, as long as all of it lies above the horizon. Of a sphere
//                that the horizon cuts: J. Snyder, "Area Light Sources for Real-Time Graphics", Microsoft Research, 1996, in the form
//                of S. Lagarde and C. de Rousiers, "Moving Frostbite to Physically Based Rendering", SIGGRAPH 2014 course; its mean
//                over a patch is that of many points
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/light.h"
#include "techniques/radiosity/form_factors/occlusion.h"
#include "techniques/radiosity/lights/solid_angle.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A line on which light comes to a point.
struct LightLine {
    dvec3 fromCentred; ///< on the light; of a directional one, outside of the scene
    double weight;     ///< what it brings, up to a factor that is the same for all lines and points
};

class LightSource {
public:
    /// Centred space has its origin at `originWorld`; the faces are those of the scene.
    LightSource(const scene::Light& light, const dvec3& originWorld, const Faces& faces);

    /// Linear RGB; all else here is for a white light.
    [[nodiscard]] dvec3 color() const { return color_; }
    /// Has it a surface, so that a point may see it in part?
    [[nodiscard]] bool hasArea() const { return scene::hasArea(light_); }

    /// At a point of a surface with that unit normal, W/m^2, with nothing in between.
    [[nodiscard]] double irradiance(const dvec3& positionCentred, const dvec3& normal) const;
    /// The mean of that over a patch. Right to 1e-7, mostly to rounding; but of a sphere that the plane of the patch cuts, to about 1 %.
    [[nodiscard]] double meanIrradiance(const Patch& patch) const;

    /// All of the patch that may get light from it, or a bit more; nothing where that is certain.
    [[nodiscard]] Polygon reached(const Patch& patch) const;
    /// A line that reaches that point; evenly for (s, t) in the unit square. Lights without an area have only one.
    [[nodiscard]] LightLine line(const dvec3& positionCentred, const dvec3& normal, double s, double t) const;

    /// The faces that may stand between the light and the polygon, or any piece of it.
    [[nodiscard]] Blockers blockers(const Polygon& polygon, const Occlusion& occlusion) const;
    /// Does one of them alone hide all of the light from all of the polygon?
    [[nodiscard]] bool isHidden(const Polygon& polygon, const Occlusion& occlusion, const Blockers& blockers) const;

private:
    [[nodiscard]] double ofSphere(const dvec3& positionCentred, const dvec3& normal) const;
    [[nodiscard]] LightLine lineFromSphere(const dvec3& positionCentred, const dvec3& normal, double s, double t) const;
    [[nodiscard]] Polygon withinCone(Polygon polygon) const;
    [[nodiscard]] Polygon hull(const Polygon& polygon) const;
    /// What is nearer to a plane, or to the light's own, lies in it.
    [[nodiscard]] double touching(const dvec3& positionCentred) const;

    scene::Light light_; ///< white, and in centred space
    dvec3 color_{1.0};
    LightCone cone_;    ///< of a spot
    Polygon rect_;      ///< of a rect, its front toward where it shines
    double beyond_ = 0; ///< metres: from every point of the scene so far lies outside of it
};

} // namespace shadowlab::radiosity
