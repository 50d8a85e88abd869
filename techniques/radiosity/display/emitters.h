// The patches that shine by themselves, chosen by chance in proportion to the power that they send.
//
// Rays that leave a point in all directions seldom meet a small bright patch, and what they bring is then noise. So a gather also sends
// rays to points of such patches, and weighs both kinds by how likely each is to find a direction (E. Veach and L. Guibas, "Optimally
// Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995: the balance heuristic).
// Where much of the scene shines, rays in all directions find it well enough, and none is chosen.
// Simplified: patches of meshes that were simplified are never chosen, since their points lie beside the surface that rays meet.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

class Emitters {
public:
    Emitters() = default;
    Emitters(const Room& room, const Sources& sources);
    [[nodiscard]] bool isEmpty() const { return patches_.empty(); }

    /// A point of a patch that shines.
    struct Choice {
        std::uint32_t patch = 0; ///< of Room::allPatches()
        dvec3 positionWorld{0.0}, normal{0.0};
        double density = 0; ///< with which it is chosen, among the points of all patches, 1/m^2
    };
    /// `which` and `where`: of the unit interval and the unit square, evenly distributed.
    [[nodiscard]] Choice choose(double which, const dvec2& where) const;
    /// The density with which points of the patch are chosen, in the mean over it, 1/m^2; 0: never.
    [[nodiscard]] double density(std::uint32_t patch) const { return patch < densities_.size() ? densities_[patch] : 0; }

private:
    struct Shining {
        std::uint32_t patch;
        double upTo; ///< the share of the power of all that this one and those before it send
        Polygon polygon;
        dvec3 normal;
    };
    std::vector<Shining> patches_;
    std::vector<double> densities_; ///< of each patch
    dvec3 originWorld_{0.0};
};

} // namespace shadowlab::radiosity
