// What every part of the technique works with: cameras are fitted, maps are drawn, receivers look them up.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/receivers.h"

namespace shadowlab::shadow_map {

struct MapTools {
    explicit MapTools(const ShadowMapParams& p) : params(p) {}
    const ShadowMapParams& params;
    MapFitter fitter{params};
    MapDrawer drawer{params, fitter};
    Receivers receivers{params, fitter};
};

} // namespace shadowlab::shadow_map
