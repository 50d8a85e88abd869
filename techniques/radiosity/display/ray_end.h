// What the surface at the end of a gather ray sends back along it.
//
// Its patch knows what that is on average, which is right where the ray is long: the next one ends elsewhere on the patch, or on another. So much is asked
// for at the point itself as shows beyond that: what lights bring there, since that has edges, by shadow rays; and where the ray is shorter than
// the patch is large, as under a ball or in a corner, what other surfaces send there. There the ray goes on by one more reflection, as that of a path does (J. T. Kajiya,
// "The Rendering Equation", SIGGRAPH 1986); everywhere else the path is cut off, and the patch has the rest.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/radiosity/display/gather_rays.h"

namespace shadowlab::radiosity {

/// The golden ratio less one: its multiples fill the unit interval evenly.
inline constexpr double kGolden = 0.6180339887498949;

/// A ray goes on so many times at most. Where it would go on then, as in a narrow gap, so much has been reflected that the patch's mean does for the rest.
inline constexpr int kMostReflections = 4;

/// What a ray chooses by, in the unit interval and square.
struct RayNumbers {
    double which = 0;    ///< which emitter or opening
    dvec2 where{0.0};    ///< the place on it
    dvec2 onLight{0.0};  ///< the place on a light with an area, seen from where the ray ends
    std::array<dvec2, kMostReflections> onward{}; ///< the directions in which it goes on from there, one after the other
};

/// What the surface sends, W/m^2.
struct Sent {
    dvec3 emitted{0.0}, reflected{0.0};
    double density = 0; ///< with which the point is chosen among those of emitters, 1/m^2
};

/// `distance`: the ray's length, metres.
Sent sentFrom(const trace::SurfacePoint& point, double distance, const GatherSolution& solution, const trace::SceneTracer& tracer, const RayNumbers& numbers);

/// The triangle's own unit normal, on the side from which the point was found.
dvec3 geometricNormal(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

} // namespace shadowlab::radiosity
