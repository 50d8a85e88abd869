// The filters that read averaged moments: which functions of the depth each keeps, and the bound that follows from their means.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/filters/filter_params.h"
#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

struct MomentFilter {
    std::string_view shader; ///< file below shaders/ that defines momentsOf(float z)
    /// Numbers in each texel of the map of moments: 1, 2 or 4.
    int (*count)(const FilterParams&);
    /// The radius that a bias has to cover, in texels.
    double (*comparedRadius)(const FilterParams&);
    /// What one texel contributes, as momentsOf() of the shader; z: its depth, -1 at the map's near side and 1 at its far side.
    dvec4 (*ofDepth)(const FilterParams&, double z);
    /// What follows from the means `m` around a point at depth result.depth, as filteredVisibility() of the shader has it.
    void (*answer)(const FilterParams&, const dvec4& m, MapProbe::Moments& result);
};

extern const MomentFilter kVarianceMoments, kExponentialMoment, kExponentialVarianceMoments, kFourMoments;

} // namespace shadowlab::shadow_map
