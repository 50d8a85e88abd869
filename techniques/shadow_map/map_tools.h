// What the techniques with a map work with: cameras are fitted, maps are drawn, receivers look them up.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shading_passes.h"
#include "techniques/shadow_map/receivers.h"

namespace shadowlab::shadow_map {

struct MapTools {
    explicit MapTools(const ShadowMapParams& p) : params(p) {}
    const ShadowMapParams& params;
    MapFitter fitter{params};
    MapDrawer drawer{params, fitter};
    Receivers receivers{params, fitter};
    ShadingPasses passes;
};

/// The pass `light`: shades the picture with the light wherever its map, or what was decided with it, lets it through.
void addLight(MapTools& tools, Frame& frame, int light, const LightShadowMap& map);

/// The stage `visibility`: how much of the light that is, 0 to 1.
void publishVisibility(MapTools& tools, Frame& frame, int light, const LightShadowMap& map);

} // namespace shadowlab::shadow_map
