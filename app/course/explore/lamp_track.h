// The track of a lamp in an explorable slide: where it stands at each of its positions, in the scene, in the picture, and in a plan of
// the scene from above on which it is dragged.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "app/film/motion.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::course {

/// The positions are those of the frames of `motion`, of the light of that index. `camera`: the eye; the pictures are `aspect` times as
/// wide as high. As the page's script reads it: positions with what is said of them, and the plan (docs/explore.md).
///
/// The plan looks straight down: +x is right, +z is down. A directional light has no place; it is drawn where a lamp would stand that
/// shines at the camera's target from there.
nlohmann::json lampTrack(const film::Motion& motion, const scene::Snapshot& scene, const scene::Camera& camera, double aspect, int light);

} // namespace shadowlab::course
