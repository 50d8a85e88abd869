// The points at which the filters disc and pcss compare: what sample_points.glsl computes, in double where it may be.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"
#include "techniques/shadow_map/filters/filter_params.h"

namespace shadowlab::shadow_map {

/// Two numbers in 0..1 that turn a pixel's samples. `fragment`: the pixel, rows counted from below.
dvec2 sampleNoise(FilterParams::Noise noise, const ivec2& fragment, const ivec2& texel, int layer);

/// Of `count` points in the unit circle, the seeds of a sunflower (Vogel 1979).
dvec2 pointInDisc(int i, int count, const dvec2& chance);

/// Of any number of points in the square from -1 to 1 (Roberts 2018).
dvec2 pointInSquare(int i, const dvec2& chance);

} // namespace shadowlab::shadow_map
