// A light of the scene as patches see it: its irradiance at a point or a patch with nothing in between, and the lines along which
// it arrives.
//
// Such a light is not a patch: its surface, if it has one, neither blocks nor reflects light. Its irradiance is the first shot of
// the solution, and exact where a closed form is known:
//   point        a patch of area A receives I Omega / A on average, Omega being its solid angle (solid_angle.h)
//   spot         the same with the part of Omega within its cone (solid_angle.h)
//   directional  I cos
//   rect         pi L F by Lambert's formula (point_form_factor.h); for a patch, by the exchange of two polygons
//   sphere       pi L (r / d)^2 cos, as a point light of intensity pi r^2 L, as long as all of it lies above the horizon. For a sphere
//                that the horizon cuts: J. Snyder, "Area Light Sources for Real-Time Graphics", Microsoft Research, 1996, in the form
//                of S. Lagarde and C. de Rousiers, "Moving Frostbite to Physically Based Rendering", SIGGRAPH 2014 course; its mean
//                over a patch is estimated at many points
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/light.h"
#include "techniques/radiosity/form_factors/occlusion.h"
#include "techniques/radiosity/lights/solid_angle.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// A line along which light arrives at a point.
struct LightLine {
    dvec3 fromCentred; ///< on the light; for a directional light, outside the scene
    double weight;     ///< its contribution, up to a factor that is the same for all lines and points
};

class LightSource {
public:
    /// `originWorld`: the origin of centred space. `faces`: all faces of the scene.
    LightSource(const scene::Light& light, const dvec3& originWorld, const Faces& faces);

    /// Linear RGB. All other functions treat the light as white.
    [[nodiscard]] dvec3 color() const { return color_; }
    /// Has it a surface? Then a point may see a part of it.
    [[nodiscard]] bool hasArea() const { return scene::hasArea(light_); }

    /// Around its surface, in centred space; of one with an area.
    [[nodiscard]] trace::CentredBox box() const;
    /// The plane of a rect, whose front shines; none: it shines to all sides.
    [[nodiscard]] std::vector<Plane> fronts() const;

    /// The irradiance at a point of a surface with that unit normal, W/m^2, with nothing in between.
    [[nodiscard]] double irradiance(const dvec3& positionCentred, const dvec3& normal) const;
    /// The mean of that over a patch. Relative error 1e-7, mostly only rounding; about 1 % for a sphere that the plane of the
    /// patch cuts: then over what lies outside of it.
    [[nodiscard]] double meanIrradiance(const Patch& patch) const;

    /// A part of the patch that contains all that the light reaches; empty where it certainly reaches nothing.
    [[nodiscard]] Polygon reached(const Patch& patch) const;
    /// The line that arrives at that point for (s, t) in the unit square. Uniform (s, t) give uniformly distributed lines. Lights
    /// without an area have only one.
    [[nodiscard]] LightLine line(const dvec3& positionCentred, const dvec3& normal, double s, double t) const;

    /// The faces that may block light between the light and the polygon, or any piece of it.
    [[nodiscard]] Blockers blockers(const Polygon& polygon, const Occlusion& occlusion) const;
    /// Does a single one of them block all of the light from all of the polygon?
    [[nodiscard]] bool isHidden(const Polygon& polygon, const Occlusion& occlusion, const Blockers& blockers) const;

private:
    [[nodiscard]] double ofSphere(const dvec3& positionCentred, const dvec3& normal) const;
    [[nodiscard]] LightLine lineFromSphere(const dvec3& positionCentred, const dvec3& normal, double s, double t) const;
    [[nodiscard]] Polygon withinCone(Polygon polygon) const;
    [[nodiscard]] Polygon hull(const Polygon& polygon) const;
    /// The contact tolerance at that position: what is nearer to a plane lies in it.
    [[nodiscard]] double touching(const dvec3& positionCentred) const;

    scene::Light light_; ///< white, and in centred space
    dvec3 color_{1.0};
    LightCone cone_;    ///< for a spot
    Polygon rect_;      ///< for a rect; its front is the side that shines
    double beyond_ = 0; ///< a distance in metres that leads out of the scene from any of its points
};

} // namespace shadowlab::radiosity
