// The track of a lamp in an explorable slide: where it stands at each of its positions, in the scene, in the picture, and in a plan of
// the scene from above on which it is dragged.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/course/lessons/lesson.h"

namespace shadowlab::course {

/// `states`: one for each position of the lamp, which is the light of that index; spread over `degrees` of its orbit. The pictures are
/// `aspect` times as wide as high. As the page's script reads it: positions with what is said of them, and the plan (docs/explore.md).
///
/// The plan looks straight down: +x is right, +z is down. A directional light has no place; it is drawn where a lamp would stand that
/// shines at the camera's target from there.
nlohmann::json lampTrack(const std::vector<ShownState>& states, double degrees, double aspect, int light);

} // namespace shadowlab::course
