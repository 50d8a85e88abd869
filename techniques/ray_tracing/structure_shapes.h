// Boxes, balls and cells of a structure as lines in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/engine.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// One shape for each level, from the outermost in. `originWorld`: of centred space. A ball is drawn as its outline seen
/// from `eyeWorld`; without one as three circles, for who looks on from anywhere.
std::vector<SceneShape> structureShapes(const trace::Engine& engine, trace::Structure structure,
                                        const dvec3& originWorld, const std::optional<dvec3>& eyeWorld);

} // namespace shadowlab::ray_tracing
