// What moves over a sequence of frames, and the scene and the camera of each of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::session {

struct Motion {
    int frames = 1;
    std::optional<double> orbitLightDegrees, orbitCameraDegrees; ///< over all frames together
};

/// What one frame shows.
struct Moment {
    scene::Snapshot snapshot;
    scene::Camera camera; ///< the snapshot's own is that of the scene as it was loaded
};

/// The moment of one frame; `frame` counts from 0. An orbit has gone frame / frames of its way, so that a full turn
/// repeats without a double picture.
Moment momentAt(const Motion& motion, const scene::Snapshot& base, int frame);

} // namespace shadowlab::session
