// Surfaces close to what shines by itself.
//
// A lamp that glows 15 cm below a ceiling lights a small part of it, and takes back much of what that part reflects. One value for a patch that is larger
// spreads the light over all of the patch, and the room is too bright. So what lies close to such a lamp is cut by its distance, however large the patches
// are elsewhere (the same grading as of a wide ground, patches/ground.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/room/sides.h"

namespace shadowlab::radiosity {

/// The parts of the sides that exchange light, divided where they are close to what emits and see it. `parts`: those before, where there are any. `scale`: 1; larger
/// where pieces must be fewer. Nothing: nothing is close, or more than `most` pieces would be added.
std::optional<FaceParts> dividedNearEmitters(const FaceParts& parts, const trace::SceneTracer& tracer, const Sides& sides, double scale, std::size_t most);

} // namespace shadowlab::radiosity
