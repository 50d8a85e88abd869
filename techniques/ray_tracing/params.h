// The knobs of ray tracing.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/ray_tracing/tree/ray_tree.h"

namespace shadowlab::ray_tracing {

struct RayTracedParams {
    bool excludeSource = true;
    enum class Receivers { traced, idBuffer } receivers = Receivers::traced;
    // The cut-off ends most branches sooner, so a deep tree costs little. In the picture of the built-in scene (640 x 360) 10
    // levels differ from 16 without cut-off by more than 1/255 in one pixel of ten thousand, and there by at most 9/255; 6
    // levels in one of four hundred, visibly at the rim of the bubble.
    int depth = 10;
    // Half of the smallest step between two 8-bit greys: what adds less to a pixel is not seen.
    double cutoff = 0.002;
    Fresnel fresnel = Fresnel::exact;
    dvec3 attenuation{1, 0, 0};
    friend bool operator==(const RayTracedParams&, const RayTracedParams&) = default;

    [[nodiscard]] trace::ShadowStart start() const {
        return excludeSource ? trace::ShadowStart::exact : trace::ShadowStart::naive;
    }
    [[nodiscard]] TreeSettings tree() const { return {depth, cutoff, fresnel, attenuation, start()}; }
};

/// The descriptions refer to the fields of `params`.
params::ParamList describe(RayTracedParams& params);

} // namespace shadowlab::ray_tracing
