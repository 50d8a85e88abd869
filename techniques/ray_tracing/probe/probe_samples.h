// The rays that a picture of many samples sends for one pixel.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/sampling/sampled_picture.h"

namespace shadowlab::ray_tracing {

struct SamplesQuestion {
    const Surfaces& surfaces;
    const trace::MovingScene& scene;
    const AnalyticLights* analytic; ///< nullptr: none
    const scene::Camera& camera;
    ivec2 size{0};
    ivec2 pixel{0};
    int light = kNoLight; ///< whose shadow rays are told
};

/// Adds the first samples of the pixel, as SampledPicture takes them, to the probe: Probe::rays, and a fact for each of a few.
/// `first` is what the ray through the pixel's middle meets.
void describeSamples(const SamplesQuestion& asked, const SampledSettings& settings, const trace::SurfacePoint& first,
                     Probe& probe);

} // namespace shadowlab::ray_tracing
