// Adaptive refinement: patches are cut where the light changes.
//
// A patch has one radiosity. Where the light on it varies, that is an error, and a large one where the edge of a shadow crosses
// it. So the equations are first solved for coarse patches; those with the largest error in power are cut in four, and so on (M.
// Cohen, D. Greenberg, D. Immel and P. Brock, "An Efficient Radiosity Approach for Realistic Image Synthesis", IEEE Computer
// Graphics and Applications 6(3), 1986).
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
    /// Patches whose error is below this share of the mean radiosity are not cut.
    double smallestError = 0.02;
    double smallestArea = 0; ///< m^2; smaller patches are not cut
    /// 1 where every patch is drawn in one colour; less where colours are interpolated, which reproduces a linear gradient but no
    /// shadow edge.
    double gradientWeight = 1;
};

/// A patch to be cut, and why.
struct Refinement {
    enum class Reason : std::uint8_t {
        gradient, ///< its neighbours are brighter or darker
        shadow,   ///< the edge of a shadow goes through it
        balance   ///< a neighbour is cut and would be too small beside it
    };
    std::uint32_t patch = 0;
    Reason reason = Reason::gradient;
};

/// By how much each patch is wrong for having one value, in the mean over it, W/m^2: what the gradients to its neighbours and the edges of
/// shadows let expect. An estimate, and no bound: what lies between two patches, none of them knows.
std::vector<double> errorsOfPatches(const std::vector<Patch>& patches, const PatchBorders& borders, std::span<const dvec3> radiosity,
                                    std::span<const dvec3> reflectance, std::span<const DirectLight> lights);

/// The patches to be cut next, by their numbers. A few rounds, each with some more patches, find shadows that one round from
/// coarse patches misses. `radiosity` (W/m^2) and `reflectance`: of each patch; only luminance is compared. `lights`: the direct
/// light of each light. Patches whose errors agree to six digits are cut together or not at all, so that symmetric scenes stay
/// symmetric. A neighbour with nearly three times the area of a patch that is cut is cut too, so that neighbours do not differ by
/// more than one level unless they did at the start.
std::vector<Refinement> patchesToRefine(const std::vector<Patch>& patches, const PatchBorders& borders,
                                        std::span<const dvec3> radiosity, std::span<const dvec3> reflectance,
                                        std::span<const DirectLight> lights, const RefinementLimits& limits);

/// The refined patches, in the order of their faces as before.
struct Refined {
    static constexpr std::uint32_t kNew = ~std::uint32_t{0};
    std::vector<Patch> patches;
    std::vector<std::uint32_t> from;   ///< for each patch its number before, or kNew (exchange_builder.h)
    std::vector<std::uint32_t> parent; ///< for each patch the number of the old patch that it is, or is a piece of
    std::vector<std::uint8_t> level;   ///< for each patch how often it has been cut
};

/// Cuts each as dividedPatch() does. `level`: of each patch before; empty: all are 0.
Refined refined(const std::vector<Patch>& patches, std::span<const Refinement> refinements,
                std::span<const std::uint8_t> level);

} // namespace shadowlab::radiosity
