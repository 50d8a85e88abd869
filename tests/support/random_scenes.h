// Random scenes of everything that a scene may hold, for what must be true of all of them.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// The scene of that number: same number, same scene. One to eight boxes, spheres, tori, quads and loose triangles of any
/// place, size and turn, some mirrored, some casting or receiving no shadows, mostly over a floor; one to four lights of
/// any kind; an eye that mostly looks at some of it, from near, from far, or from inside.
scene::Scene randomScene(unsigned number);

} // namespace shadowlab::testing
