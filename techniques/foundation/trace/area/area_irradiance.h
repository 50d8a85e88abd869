// What a light with an area adds at a point: its irradiance, no samples, but the whole integral.
//
// Of a piece of the light that is seen as a whole, the cosine's integral over its solid angle is 1/2 of the closed integral of
// r x dr along its border, in product with the normal, r being the unit vector from the point to the border (J. H. Lambert,
// "Photometria", 1760; for a plane border the sum of angle times normal over its sides). So no piece needs more than its corners:
// see light_piece.h. Which pieces are seen is found as for the share of area, in area_visibility.h. Near the edge of a shadow the
// two shares differ: a place of the light counts for less irradiance the farther and the more aslant it is.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::trace {

/// Irradiance is divided by pi times the light's radiance: 1 under a light that fills all of the hemisphere.
struct AreaIrradiance {
    double visible = 0;    ///< 0..1 of the light's area, the same as AreaShare::visible
    double irradiance = 0; ///< of what is seen of the light, at a surface with the normal that was given
    /// Of all of the light in front of the surface, without shadows. What lies behind the surface, by that normal or by the
    /// triangle's own, counts for neither.
    double unshadowed = 0;
};

} // namespace shadowlab::trace
