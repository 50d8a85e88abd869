// What rays or triangles decide about one pixel, found by the technique's own tests: the judge that it is compared with plays no part.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_map/probe/texel_depths.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

struct TriangleDecision {
    trace::Visibility visibility = trace::Visibility::noSurface;
    std::string who; ///< decided
    std::optional<Decision::Face> blocker{};
};

/// Adds the decision to the facts and drawings of the probe, held against the truth.
void addTriangleDecision(Probe& probe, const TriangleDecision& decision, trace::Visibility truth);

/// By the map, where the first triangle at the texel's centre is before the point, too; by a ray elsewhere. `first`: none where
/// the point is outside of all maps. Of an edge in the texel nothing is known here: a ray is sent where the shader need not.
TriangleDecision decideExactly(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light,
                               const std::optional<TexelDepth>& first);

/// Every triangle that the light can see, tested against the point as in alias_free.h.
TriangleDecision decideAliasFree(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light);

} // namespace shadowlab::shadow_map
