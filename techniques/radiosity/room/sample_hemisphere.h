// What does a patch see where it sees none of the others' fronts, and where does it lie?
//
// Form factors between patches of a closed room sum to 1. In an open scene the rest goes to the surroundings. Under a box that
// stands on a floor there is nothing but the inside of the box, and where two boxes pierce one another, a side of the one is in the
// other. To find out, rays are sent from the patch, as many in each direction as light goes there: by the cosine law.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/patches/winding_number.h"

namespace shadowlab::radiosity {

/// Shares of what leaves a patch.
struct HemisphereShares {
    double nothing = 0;  ///< goes away and meets no surface
    double inBodies = 0; ///< begins inside of a closed body
    double folds = 0;    ///< meets its own object, nearer than asked for
};

/// The rays are the same for the same patch. Exactly 0 and 1 where all rays agree, else within some hundredths.
/// `object`: the patch's own. `foldMetres`: how near its own object is where a coarser mesh has folded onto itself; 0: nowhere.
HemisphereShares sampleHemisphere(const trace::SceneTracer& tracer, const ClosedBodies& bodies, const Patch& patch,
                                  std::uint32_t object, double foldMetres);

} // namespace shadowlab::radiosity
