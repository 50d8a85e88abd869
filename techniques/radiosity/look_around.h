// What does a patch see where it sees none of the others' fronts?
//
// Form factors between patches of a closed room sum to 1. In an open scene the rest goes to the surroundings; under a box that
// stands on a floor there is nothing but the inside of the box. To tell these apart, rays are sent from the patch, as many in each
// direction as light goes there: by the cosine law.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches.h"
#include "techniques/radiosity/sides.h"

namespace shadowlab::radiosity {

/// Shares of what leaves a patch; the rest goes to fronts of surfaces.
struct Seen {
    double nothing = 0; ///< goes away and meets no surface
    double insides = 0; ///< meets a side that takes no part: the inside of a closed body
    double folds = 0;   ///< meets its own object, nearer than asked for
};

/// The rays are the same for the same patch. Exactly 0 and 1 where all rays agree, else within some hundredths.
/// `foldMetres`: how near its own object is where a coarser mesh has folded onto itself; 0: nowhere.
Seen lookAround(const trace::SceneTracer& tracer, const Sides& sides, const Patch& patch, double foldMetres);

} // namespace shadowlab::radiosity
