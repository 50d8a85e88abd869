// What the shadow map knows of one pixel: the way from the point to its texel, what the texel holds, and the comparison.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_map/maps/averaged_light.h"

namespace shadowlab::shadow_map {

/// The technique's parts, prepared for the snapshot that is asked about.
struct ProbedMap {
    const ShadowMapParams& params;
    const MapFitter& fitter;
    const AveragedLight* averaged = nullptr;  ///< of the shadow map
    const trace::SceneTracer* rays = nullptr; ///< of the exact map: they decide where the map is not certain
    bool samplesArea = false;                 ///< Technique::samplesArea() of the light

    /// Is the light's visibility the mean of many maps' answers?
    [[nodiscard]] bool averagesOver(const scene::Light& light) const {
        return averaged && averaged->averagesOver(light);
    }
};

/// Adds the shadow map's facts, drawings and decision to what any technique says of the pixel.
void probeShadowMap(Probe& probe, const ProbedMap& of, const scene::Snapshot& snapshot, const View& view, ivec2 pixel,
                    int light);

/// Polygons that each pass of a frame draws, if all its maps are drawn anew: "every polygon is rendered N + 1 times". Empty where
/// rays decide, or a light has more than one map.
std::vector<Probe::DrawnPass> drawnPasses(const ProbedMap& of, const scene::Scene& scene, const View& view);

} // namespace shadowlab::shadow_map
