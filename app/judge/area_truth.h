// The truth about a light's area: of each pixel, the share of the light that is seen (trace/area/area_visibility.h).
//
// Shares change slowly where one surface is seen, and how slowly is known. So the points around a pixel's centre are asked
// only where they lie on another triangle, or where the share might pass one half on the way to them.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/judge/truth.h"

namespace shadowlab::judge {

/// With ties where there is a `rasterised`.
Truth areaTruth(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light,
                const Rasterised* rasterised, const std::stop_token& stop);

/// As tiesAmong() in truth.h.
std::vector<std::uint8_t> areaTiesAmong(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                                        int light, double tieRadiusPx, const std::vector<ivec2>& pixels);

} // namespace shadowlab::judge
