// The stages that show what a structure is and what it spares.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/ray_tracing/picture.h"
#include "techniques/ray_tracing/structures/kept_structures.h"

namespace shadowlab::ray_tracing {

inline constexpr StageInfo kTestsStage = {"intersection-tests",
                                          "Tests per pixel: volumes and triangles, eye ray and shadow rays together",
                                          StageKind::scalar, false};
inline constexpr StageInfo kStructureStage = {"structure", "The structure that spares rays most triangles",
                                              StageKind::swatches, false};

/// Traces the picture's rays once more, and counts.
void publishTests(Frame& frame, const trace::SceneTracer& tracer, const KeptStructures& structures);

/// The structure's parts as lines over the picture, which is finished.
void publishStructure(Frame& frame, const trace::SceneTracer& tracer, const KeptStructures& structures,
                      const Picture& picture);

} // namespace shadowlab::ray_tracing
