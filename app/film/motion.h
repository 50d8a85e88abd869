// What moves over a sequence of frames, and the scene and the camera of each of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/film/path.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::film {

struct Motion {
    int frames = 1;
    std::optional<double> orbitLightDegrees, orbitCameraDegrees; ///< over all frames together
    std::optional<Path> path;                                    ///< instead of orbits
};

/// What one frame shows.
struct Moment {
    scene::Snapshot snapshot;
    scene::Camera camera; ///< the snapshot's own is that of the scene as it was loaded
};

/// The moment of one frame; `frame` counts from 0. An orbit has gone frame / frames of its way, so that a full turn
/// repeats without a double picture; on a path, frame 0 is its frame 1. `previous` is the snapshot of an earlier moment
/// of the same motion, if there was one: what has not moved since then keeps its revisions, and is not prepared again.
Moment momentAt(const Motion& motion, const scene::Snapshot& base, int frame,
                const scene::Snapshot& previous = nullptr);

} // namespace shadowlab::film
