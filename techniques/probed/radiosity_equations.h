// Some rows of the radiosity equations, with their numbers.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// Some of the n equations of a room whose patches exchange light: B_i - rho_i sum of F_ik B_k = what i sends of its own.
struct RadiosityEquations {
    std::uint32_t count = 0;            ///< n
    std::vector<std::uint32_t> patches; ///< 1 ... n, rising: those whose rows and columns these are
    std::vector<dvec3> reflectance;     ///< rho_i
    std::vector<dvec3> emission;        ///< E_i, W/m^2, with what i reflects of light sources that are no patches
    std::vector<dvec3> radiosity;       ///< B_i, W/m^2
    std::vector<std::vector<double>> formFactors; ///< F_ik, of rows and columns as in `patches`
    std::vector<dvec3> fromOthers;                ///< sum of F_ik B_k over all other columns, W/m^2
};

} // namespace shadowlab
