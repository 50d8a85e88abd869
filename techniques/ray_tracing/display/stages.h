// The stages of ray tracing: each function publishes one.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/sampling/light_shares.h"
#include "techniques/ray_tracing/sampling/sampled_picture.h"
#include "techniques/ray_tracing/structures/structure_cache.h"

namespace shadowlab::ray_tracing {

/// How many rays were traced, and how many of them were blocked.
struct RayCounts {
    std::size_t hits = 0; ///< of eye rays
    struct OfLight {
        std::size_t asked = 0, blocked = 0;
    };
    std::vector<OfLight> shadowRays; ///< per light
};
RayCounts countRays(const trace::SceneTracer& tracer, const Picture& picture);
void publishCounts(Frame& frame, const RayCounts& counts);

/// Distances from the eye.
void publishDistances(Frame& frame, const trace::SceneTracer& tracer, const Picture& picture);

/// The results of the shadow rays to a light, and the visibility that all techniques publish.
void publishShadowRays(Frame& frame, const Picture& picture, int light);
/// `shares`: the visible share of the light's area, where it was computed; else nullptr.
void publishVisibility(Frame& frame, const Picture& picture, int light, const LightShares* shares);
/// Lit, penumbra and umbra: where all, a part, or nothing of the light is seen.
void publishPenumbra(Frame& frame, const Picture& picture, int light, const LightShares* shares);

/// What reflection or refraction rays add; black where no tree was traced.
void publishAdded(Frame& frame, std::string_view stage, const Picture& picture, const Grid<vec3>& addedFromBelow);

/// How many samples each pixel has.
void publishSamples(Frame& frame, const Picture& picture, const SampledPicture& sampled);

/// The number of levels of each pixel's tree.
void publishLevels(Frame& frame, const Picture& picture);

/// Traces the picture's rays again, counting intersection tests.
void publishTests(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures);

/// Draws the volumes of the acceleration structure as lines over the finished picture.
void publishStructure(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures,
                      const Picture& picture);

} // namespace shadowlab::ray_tracing
