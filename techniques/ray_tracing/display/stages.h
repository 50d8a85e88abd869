// The stages of ray tracing, and its counters.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>

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

/// Traces the picture's rays again, counting intersection tests.
void publishTests(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures);

/// Draws the volumes of the acceleration structure as lines over the finished picture.
void publishStructure(Frame& frame, const trace::SceneTracer& tracer, const StructureCache& structures,
                      const Picture& picture);

/// What the stages are made from.
struct StageSources {
    const trace::SceneTracer& tracer;
    const StructureCache& structures;
    const Picture& picture;
    const SampledPicture& sampled;
    const std::map<int, LightShares>& shares; ///< by light
};

/// Publishes the stages that the frame asks for, except `lights-off`, which is drawn between two passes.
void publishStages(Frame& frame, const StageSources& sources);

} // namespace shadowlab::ray_tracing
