// For whose picture a room is cut.
//
// What matters to a picture (importance.h) changes a little with each turn of the eye, and at some turn a face is cut differently. Then all form factors are
// found anew. A film that turns by a degree from picture to picture would pay for that in nearly each of them. So what matters is found for an eye that
// moves in steps: one stands for all eyes near it, and sees what any of them sees. Which one it is depends on the eye alone and not on where that was before, so
// a picture of a film is the same as that picture on its own.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/room/sides.h"

namespace shadowlab::radiosity {

/// Whose picture it is.
struct Eye {
    scene::Camera camera;
    ivec2 pictureSize{1};
    friend bool operator==(const Eye&, const Eye&) = default;
};

/// The eye that stands for all near one. `scene`: a box around what it sees; its steps are shares of that and begin at its corner, so that a scene elsewhere
/// has the same. Where a surface lies between the two places, the place is kept.
Eye inSteps(const Eye& eye, const trace::CentredBox& scene, const trace::SceneTracer& tracer);

} // namespace shadowlab::radiosity
