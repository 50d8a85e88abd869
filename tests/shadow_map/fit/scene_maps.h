// A light's maps as they are when the eye does not matter.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/shadow_map/fit/fit.h"

namespace shadowlab::testing {

/// Fitted to all casters that matter and all receivers, with fit=scene; `castersInDepth` for filters that ask how far casters are.
inline shadow_map::LightMaps
sceneMaps(const scene::Scene& scene, const scene::Light& light, int resolution, int guardTexels,
          const shadow_map::ProjectionParams& params = {.fit = shadow_map::ProjectionParams::Fit::scene},
          bool castersInDepth = false) {
    const std::vector<scene::Bounds> all = scene::objectBounds(scene);
    std::vector<scene::Bounds> casters;
    for (const std::size_t caster : scene::usefulCasters(scene, light, all))
        casters.push_back(all[caster]);
    return shadow_map::fitLightMaps({.light = light,
                                     .all = all,
                                     .casters = casters,
                                     .receivers = {},
                                     .eye = {.camera = scene.camera, .aspect = 4.0 / 3.0, .visibleDepth = {}},
                                     .params = params,
                                     .resolution = resolution,
                                     .guardTexels = guardTexels,
                                     .castersInDepth = castersInDepth});
}

} // namespace shadowlab::testing
