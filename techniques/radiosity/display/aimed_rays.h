// Rays to chosen points, or in chosen directions, and how much of what two kinds of rays may find counts for each of them.
//
// Directions about a normal that are chosen by the cosine have the density cosine / pi, 1/sr. Points of a surface that are chosen with a density, 1/m^2,
// have that times distance^2 / cosine there, 1/sr, as directions. What both may find is weighed by these (the balance heuristic, gather_guide.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/display/gather_guide.h"

namespace shadowlab::radiosity {

/// The share of what is found in a direction that counts where two kinds of rays may find it, one with this density and another.
inline double balanced(double density, double densityOfOther) { return density > 0 ? density / (density + densityOfOther) : 0; }

/// The triangle's own unit normal, on the side from which the point was found.
dvec3 geometricNormal(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

/// The diffuse reflectance of that place itself. A patch's is a mean, with what an image lays on it and with what lamps cover; and where the patch is one of a
/// simplified mesh it may be that of another part, as of the next square of a chessboard.
dvec3 reflectanceAt(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

/// A place on the same side of the same triangle, all places alike: `unit` lies in the unit square.
trace::SurfacePoint placeOn(const trace::SurfacePoint& side, dvec2 unit);

/// The direction in which light leaves that point: about the geometricNormal(), by the cosine.
dvec3 diffuseDirection(const trace::SceneTracer& tracer, const trace::SurfacePoint& from, const dvec2& unit);

/// What that place itself emits, W/m^2. A patch of a simplified mesh that is nearest to it may be the back of another part, and dark.
dvec3 emittedAt(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

/// From where rays are sent.
struct RayOrigin {
    const trace::SurfacePoint& point;
    dvec3 normal{0.0}; ///< unit, of shading
    dvec3 flat{0.0};   ///< the geometricNormal()
    std::optional<std::uint32_t> patch{}; ///< where isUneven(): on which it lies
};

/// A ray to a point.
struct Aim {
    dvec3 direction{0.0};
    double distance = 0, cosineHere = 0, cosineThere = 0;
};
/// `facing`: of the surface there, toward those who see it. Nothing: they do not face each other.
std::optional<Aim> aimAt(const dvec3& positionWorld, const dvec3& facing, const trace::SceneTracer& tracer, const RayOrigin& from);

/// What a ray that was chosen has met.
struct Met {
    trace::SurfacePoint point;
    double distance = 0; ///< metres
    double share = 0;    ///< of the radiosity there, that counts as irradiance here
};
/// Nothing: what was chosen is not seen. `from` has a patch.
std::optional<Met> chosenPoint(const GatherGuide& guide, const trace::SceneTracer& tracer, const RayOrigin& from, double which, const dvec2& where);

/// The share that counts of what a ray in any direction meets on that patch, if rays are also chosen from there.
double shareByChance(const GatherGuide& guide, const trace::SceneTracer& tracer, const RayOrigin& from, const dvec3& direction, const trace::SurfacePoint& met,
                     const std::optional<std::uint32_t>& patchThere, double distance);

} // namespace shadowlab::radiosity
