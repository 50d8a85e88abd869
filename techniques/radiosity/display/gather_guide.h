// From which patches the light at a patch comes: where it comes from few, a gather sends rays to these on purpose.
//
// Rays that leave a point in all directions seldom meet a small bright patch, such as a lamp's, or the sun's on a floor, and what they bring is then
// noise. But the solution knows how much each patch sends to each other: F_ij B_j. So as many rays go to points of patches that are chosen
// in proportion to that (as paths in H. W. Jensen, "Importance Driven Path Tracing Using the Photon Map", Eurographics Workshop on Rendering 1995, go
// where photons came from), and both kinds are weighed by how likely each is to find a point (E. Veach and L. Guibas, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", SIGGRAPH 1995: the balance heuristic).
// Where light comes from all sides, rays in all directions find it well enough, and none is chosen. And under the open sky only what patches emit is
// found on purpose: what they reflect is little there, and while rays do not depend on the lights, pictures by each of them add up to that by all to
// the last bit. In rooms they add up but for noise.
// Simplified: a point uses the shares of the whole patch on which it lies, and within a patch all points are chosen alike. Patches of meshes that were
// simplified are never chosen, since their points lie beside the surface that rays meet. Neither makes the mean wrong: all points can be met by chance.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

class GatherGuide {
public:
    /// Chooses nothing.
    GatherGuide() = default;
    /// `radiosity` and the part of it that is emitted: of each of Room::allPatches(), W/m^2. `outside`: radiance where a patch sees no surface. The room must
    /// outlive this object.
    GatherGuide(const Room& room, const ExchangeMatrix& exchange, std::span<const dvec3> radiosity, std::span<const dvec3> emission, const dvec3& outside);

    // Patches are numbered as in Room::allPatches(). `at`: on which patch the light arrives.

    /// Does the light there come from few patches, so that points of them are worth choosing?
    [[nodiscard]] bool isUneven(std::uint32_t at) const { return at < upTo_.size() && !upTo_[at].empty(); }

    struct Choice {
        std::uint32_t patch = 0;
        dvec3 positionWorld{0.0}, normal{0.0};
        double density = 0; ///< with which the point is chosen, among the points of all patches, 1/m^2
    };
    /// Where isUneven(). `which` and `where`: of the unit interval and the unit square, evenly distributed.
    [[nodiscard]] Choice choose(std::uint32_t at, double which, const dvec2& where) const;
    /// Where isUneven(): the density with which points of the other patch are chosen, in the mean over it, 1/m^2; 0: never.
    [[nodiscard]] double density(std::uint32_t at, std::uint32_t other) const;

private:
    [[nodiscard]] double share(std::uint32_t at, std::uint32_t other) const;

    const Room* room_ = nullptr;
    /// Of each patch: the share of its light that comes from each of Room::patches() and those before it; empty where it is not uneven.
    std::vector<std::vector<float>> upTo_;
};

} // namespace shadowlab::radiosity
