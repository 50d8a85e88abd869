// What the parameters `exact` and `alias-free` decide about one pixel, found by their own tests: the judge that they are compared with plays no part.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_map/probe/texel_depths.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

struct ExactDecision {
    trace::Visibility visibility = trace::Visibility::noSurface;
    std::string who; ///< decided
    std::optional<Decision::Face> blocker{};
};

/// By the map, where the first triangle at the texel's centre is before the point, too; by a ray elsewhere. `first`: none where
/// the point is outside of all maps. Of an edge in the texel nothing is known here: a ray is sent where the shader need not.
ExactDecision decideExactly(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light,
                            const std::optional<TexelDepth>& first);

/// Every triangle that the light can see, tested against the point as in alias_free.h.
ExactDecision decideAliasFree(const trace::SceneTracer& tracer, const View& view, ivec2 pixel, int light);

} // namespace shadowlab::shadow_map
