// What a patch sees besides the fronts of other patches, and whether it lies inside a body.
//
// Form factors between the patches of a closed room sum to 1. In an open scene the rest goes to the surroundings. Under a box
// that stands on a floor there is only the inside of the box, and where two boxes intersect, a side of one lies in the other.
// Cosine-distributed rays from the patch estimate these shares.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/patches/winding_number.h"

namespace shadowlab::radiosity {

/// Shares of the light that leaves a patch.
struct HemisphereShares {
    double nothing = 0;  ///< hits no surface
    double inBodies = 0; ///< starts inside a closed body
    double folds = 0;    ///< hits the patch's own object nearer than `foldMetres`
};

/// The rays are always the same for the same patch. Exactly 0 or 1 where all rays agree, else right to some hundredths; a small share of
/// nothing, as in a room with a window, to a few thousandths. `object`:
/// the patch's own. `foldMetres`: how near its own object must be for a fold of a simplified mesh; 0: none is looked for.
HemisphereShares sampleHemisphere(const trace::SceneTracer& tracer, const ClosedBodies& bodies, const Patch& patch,
                                  std::uint32_t object, double foldMetres);

/// The share of nothing for a patch of which no ray went out: that of more rays. Where a window is a thousandth of the view, most patches need them, and
/// without them only those that see much of it would be found.
double smallView(const trace::SceneTracer& tracer, const Patch& patch);

/// A direction about the normal, those near it more likely, by the cosine: `unit` lies in the unit square; the tangents and the normal are a right-handed frame.
dvec3 cosineDirection(const std::array<dvec3, 2>& tangents, const dvec3& normal, const dvec2& unit);

/// One of the rays.
struct HemisphereRay {
    dvec3 fromCentred{0.0}, direction{0.0};
};

/// Those of so many rays that hit no surface.
std::vector<HemisphereRay> outwardRays(const trace::SceneTracer& tracer, const Patch& patch, std::size_t count);

} // namespace shadowlab::radiosity
