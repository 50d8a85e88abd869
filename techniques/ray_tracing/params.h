// The knobs of ray tracing.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/ray_tracing/ray_tree.h"

namespace shadowlab::ray_tracing {

struct RayTracedParams {
    bool excludeSource = true;
    enum class Receivers { traced, idBuffer } receivers = Receivers::traced;
    // A ray through a glass ball with a ball of water in it, seen in a mirror, meets 5 surfaces until it is out again. One
    // more reflection on the way makes 6. On the built-in scene no deeper tree is told from it by eye (docs/ray-traced.md).
    int depth = 6;
    // Half of the smallest step between two 8-bit greys: what adds less to a pixel is not seen.
    double cutoff = 0.002;
    Fresnel fresnel = Fresnel::exact;
    dvec3 attenuation{1, 0, 0};

    [[nodiscard]] trace::ShadowStart start() const {
        return excludeSource ? trace::ShadowStart::exact : trace::ShadowStart::naive;
    }
    [[nodiscard]] TreeSettings tree() const { return {depth, cutoff, fresnel, attenuation, start()}; }
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(RayTracedParams& params);

} // namespace shadowlab::ray_tracing
