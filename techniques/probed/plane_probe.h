// Which triangles cover one pixel when they are projected onto its plane from the light.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The point on its plane, and all that the light's line through it meets.
struct PlaneProbe {
    struct Cover {
        std::string object;
        std::uint32_t triangle = 0;
        dvec3 placeWorld{0.0}; ///< the caster's point whose projection is the pixel's
        double height = 0;     ///< N.P + D, metres above the plane
        double weight = 0;     ///< w' = (N.P_L + D) - (N.P + D): 0 at the light's height, negative beyond
        bool casts = false;    ///< it is between the plane and the light
        std::string why{};     ///< it does not
        std::array<dvec3, 3> cornersWorld{};
    };
    dvec4 planeWorld{0.0};  ///< (N, D), positive on the light's side
    dvec4 lightWorld{0.0};  ///< homogeneous
    double lightHeight = 0; ///< N.P_L + D; of a direction its cosine
    double contact = 0;     ///< metres above the plane below which things belong to it
    /// The point lies on no plane that receives: planeWorld is zero, and what receives is listed instead.
    bool receives = true;
    struct Other {
        std::string object;
        dvec4 planeWorld{0.0}; ///< (N, D)
    };
    std::vector<Other> others;
    bool clips = true;         ///< does the technique, with its settings, leave out what does not cast?
    std::vector<Cover> covers; ///< from the plane toward the light
};

} // namespace shadowlab
