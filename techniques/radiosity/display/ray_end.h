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

/// What the surface sends.
struct Sent {
    dvec3 radiosity{0.0};                ///< W/m^2
    std::optional<std::uint32_t> patch; ///< nothing: the surface of a light, or the inside of a closed body
};

/// `distance`: the ray's length, metres.
Sent sentFrom(const trace::SurfacePoint& point, double distance, const GatherSolution& solution, const trace::SceneTracer& tracer, const RayNumbers& numbers);

} // namespace shadowlab::radiosity
