// What the surface at the end of a gather ray sends back along it.
//
// Its patch knows what that is on average, which is right where the ray is long: the next one ends elsewhere on the patch, or on another. So much is asked
// for at the point itself as shows beyond that: what lights bring there, since that has edges, by shadow rays; and where the ray is shorter than
// the patch is large, as under a ball or in a corner, what other surfaces send there. There the ray goes on by one more reflection, as that of a path does (J. T. Kajiya,
// "The Rendering Equation", SIGGRAPH 1986); everywhere else the path is cut off, and the patch has the rest.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/display/gather_rays.h"
#include "techniques/radiosity/display/ray_numbers.h"

namespace shadowlab::radiosity {

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
