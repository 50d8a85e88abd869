// The comparison of one point with its map, step by step, and what of the map the plane of a drawing passes through.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/exact_visibility.h"
#include "techniques/probe.h"
#include "techniques/shadow_map/compared_depth.h"
#include "techniques/shadow_map/texel_depths.h"

namespace shadowlab::shadow_map {

/// A point that is compared, and with what.
struct ComparedPoint {
    const scene::Scene& scene;
    const LightMaps& maps;
    int layer = 0;
    const ShadowMapParams& params;
    const FilterParams& filter;
    const TexelDepths& depths;
    dvec3 pointWorld{0.0};
    std::array<dvec3, 3> cornersWorld{}; ///< of the triangle that the point lies on
};

/// The filter's comparisons, with their shares; none for filters that compare at chosen samples or average depths.
std::vector<MapProbe::Tap> tapsOf(const ComparedPoint& point);

/// All but the taps and the drawing's cells. Nothing where the point is behind the light's camera.
std::optional<MapProbe> probeMap(const ComparedPoint& point);

/// The texels on both sides of the point that the plane passes through, and some of all that it does.
void addCells(MapProbe& probe, const ComparedPoint& point, const LightSection& section);

/// Metres along the light's axis that a depth at a place of the map stands for.
double metresOf(const LightMaps& maps, int layer, const dvec2& uv, double depth);

} // namespace shadowlab::shadow_map
