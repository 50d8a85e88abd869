// The stages that show what the rays of a picture found.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/sampling/light_shares.h"
#include "techniques/ray_tracing/sampling/sampled_picture.h"
#include "techniques/ray_tracing/structures/structure_cache.h"

namespace shadowlab::ray_tracing {

/// How many rays were sent, and what came of them.
struct RayCounts {
    std::size_t hits = 0; ///< of eye rays
    struct OfLight {
        std::size_t asked = 0, blocked = 0;
    };
    std::vector<OfLight> shadowRays; ///< per light
};
RayCounts countRays(const trace::SceneTracer& tracer, const Picture& picture);
void publishCounts(Frame& frame, const RayCounts& counts);

/// How far from the eye its rays end.
void publishDistances(Frame& frame, const trace::SceneTracer& tracer, const Picture& picture);

/// What came of the shadow rays to a light, and which of it is the visibility that all techniques publish.
void publishShadowRays(Frame& frame, const Picture& picture, int light);
/// `shares`: of the light's area, where that was asked; else nullptr.
void publishVisibility(Frame& frame, const Picture& picture, int light, const LightShares* shares);
/// Where all, a part, or nothing of the light is seen.
void publishPenumbra(Frame& frame, const Picture& picture, int light, const LightShares* shares);

/// What reflection or refraction rays add; nothing at all where no tree was traced.
void publishAdded(Frame& frame, std::string_view stage, const Picture& picture, const Grid<vec3>& addedFromBelow);

/// How many samples each pixel has.
void publishSamples(Frame& frame, const Picture& picture, const SampledPicture& sampled);

/// Of how many levels each pixel's tree is.
void publishLevels(Frame& frame, const Picture& picture);

/// Traces the picture's rays once more, and counts.
void publishTests(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures);

/// The structure's parts as lines over the picture, which is finished.
void publishStructure(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures,
                      const Picture& picture);

} // namespace shadowlab::ray_tracing
