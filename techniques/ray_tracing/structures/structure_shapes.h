// Boxes, balls and cells of a structure as lines in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// One shape for each level, from the outermost in. `originWorld`: of centred space. A ball is drawn as its outline seen
/// from `eyeWorld`; without one as three circles, for who looks on from anywhere.
std::vector<SceneShape> structureShapes(const trace::Engine& engine, trace::Structure structure,
                                        const dvec3& originWorld, const std::optional<dvec3>& eyeWorld);

/// Cells of a grid that a ray may pass, and parts of a tree's level that are looked at: beyond that a picture shows nothing.
constexpr std::size_t kMostPassed = 4096;

/// What a ray passes: "cells" or "volumes".
std::string passedWord(trace::Structure structure);

/// What the eye ray passes (trace::Engine::passed) as one shape, with their number in its label.
SceneShape passedShape(const std::vector<trace::StructurePart>& passed, trace::Structure structure,
                       const dvec3& originWorld);

} // namespace shadowlab::ray_tracing
