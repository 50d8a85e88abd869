// Patches are cut finer where light changes, and nowhere else.
//
// A patch has one radiosity. Where the light on it is uneven, that is wrong by some part of the difference; and where the edge
// of a shadow goes through it, by much. So first all is solved for coarse patches, then those that are wrong by most power are
// cut in four, and so on (M. Cohen, D. Greenberg, D. Immel and P. Brock, "An Efficient Radiosity Approach for Realistic Image
// Synthesis", IEEE Computer Graphics and Applications 6(3), 1986).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/radiosity/interpolation/patch_borders.h"
#include "techniques/radiosity/lights/direct_light.h"

namespace shadowlab::radiosity {

struct RefinementLimits {
    std::size_t mostPatches = 5000;
    /// A patch whose radiosity is wrong by less than this share of the mean of all is left as it is.
    double smallestError = 0.02;
    double smallestArea = 0; ///< m^2; none below is cut
    /// 1 where every patch is drawn in one colour; less where colours are interpolated, which shows a plain gradient right, and
    /// no edge of a shadow.
    double gradientWeight = 1;
};

/// A patch to be cut, and why.
struct Refinement {
    enum class Reason : std::uint8_t {
        gradient, ///< its neighbours are brighter or darker
        shadow,   ///< the edge of a shadow goes through it
        balance   ///< a neighbour is cut, and would be too small beside it
    };
    std::uint32_t patch = 0;
    Reason reason = Reason::gradient;
};

/// Those to be cut next, by their numbers. A few rounds, each with some more patches, find what one round from coarse patches
/// cannot see. `radiosity` (W/m^2) and `reflectance`: of each patch; their luminance counts. `lights`: what each light brings.
/// Patches that are wrong by as much power, to six digits, are cut together or not at all: what is symmetric stays so. A patch
/// with nearly three times the area of a neighbour that is cut is cut too, so that no neighbours are more than one level apart
/// that were not so from the start.
std::vector<Refinement> patchesToRefine(const std::vector<Patch>& patches, const PatchBorders& borders,
                                        std::span<const dvec3> radiosity, std::span<const dvec3> reflectance,
                                        std::span<const DirectLight> lights, const RefinementLimits& limits);

/// The patches after that, in the order of their faces as before.
struct Refined {
    static constexpr std::uint32_t kNew = ~std::uint32_t{0};
    std::vector<Patch> patches;
    std::vector<std::uint32_t> from;   ///< of each patch: its number before, or kNew (exchange_builder.h)
    std::vector<std::uint32_t> parent; ///< of each patch: the number of that which it is, or was cut from
    std::vector<std::uint8_t> level;   ///< of each patch: how often it was cut
};

/// Quads and triangles are cut into four of their shape, quads more than twice as long as wide into two; others by two lines
/// through the centre, along the longest edge and across. `level`: of each patch before; of the first patches nothing.
Refined refined(const std::vector<Patch>& patches, std::span<const Refinement> refinements,
                std::span<const std::uint8_t> level);

} // namespace shadowlab::radiosity
