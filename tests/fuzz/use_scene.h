// What the program does with a scene between reading and drawing it, all of it that needs no graphics: a scene that was taken
// must stand it. Beyond not crashing it is held to what the parts promise of any scene.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::fuzz {

/// Small enough for thousands of scenes a second, and so near that bytes reach them. Otherwise the program's own.
scene::Limits smallLimits();

/// Throws Fault for a promise that is not kept.
void useScene(const scene::Snapshot& snapshot);

/// One mesh: indices, edges, and its shadow volume for lights at such places (homogeneous, in mesh space).
void useMesh(const std::shared_ptr<const scene::Mesh>& mesh);

} // namespace shadowlab::fuzz
