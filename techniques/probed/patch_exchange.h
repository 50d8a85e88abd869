// The patch that one pixel shows, and the light that it exchanges with another one.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// A flat piece of a surface that sends light out in all directions, as a Lambertian one does.
struct PatchProbe {
    std::string object;              ///< of which it is a piece
    std::vector<dvec3> cornersWorld; ///< counter-clockwise seen from the front
    dvec3 centreWorld, normalWorld;  ///< its centroid; the front's side, unit
    double area = 0;                 ///< m^2
    dvec3 emission{0.0};             ///< E, W/m^2
    dvec3 reflectance{0.0};          ///< rho, 0..1
    dvec3 radiosity{0.0};            ///< B, W/m^2
};

/// The pixel's patch j, and another one that it exchanges light with.
struct PatchExchange {
    PatchProbe j;
    std::optional<PatchProbe> k{};
    double formFactorJk = 0; ///< the share of what leaves j that reaches k, with what stands in between
    double formFactorKj = 0;
};

} // namespace shadowlab
