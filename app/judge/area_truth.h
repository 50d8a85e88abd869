// The truth about a light's area: of each pixel, the share of the light that is seen (trace/area/area_visibility.h).
//
// On one surface the share changes slowly, with a known bound. So the points around a pixel's centre (for ties) are traced only where
// they lie on another triangle, or where the share might pass one half between the centre and them.
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
