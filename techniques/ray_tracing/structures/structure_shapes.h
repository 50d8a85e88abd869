// The volumes of an acceleration structure (boxes, balls, cells) as lines in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// One shape for each level, from the outermost in. `originWorld`: the origin of centred space. A ball is drawn as its outline
/// seen from `eyeWorld`; without an eye, as three circles, for views from anywhere.
std::vector<SceneShape> structureShapes(const trace::Engine& engine, trace::Structure structure,
                                        const dvec3& originWorld, const std::optional<dvec3>& eyeWorld);

/// The most cells or volumes that are listed along a ray: more could not be distinguished in a picture.
constexpr std::size_t kMostPassed = 4096;

/// The word for the parts of a structure: "cells" or "volumes".
std::string passedWord(trace::Structure structure);

/// The parts that the eye ray passes (trace::Engine::passed) as one shape, with their number in its label.
SceneShape passedShape(const std::vector<trace::StructurePart>& passed, trace::Structure structure,
                       const dvec3& originWorld);

} // namespace shadowlab::ray_tracing
