// A scene that was made in another unit than metres.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The note for a scene that is far from metres; empty: none. Size alone proves nothing: watches and valleys are scenes, too. But
/// what a light of a place gives falls with the square of the distance, so its intensity fixes a unit of length. A scene is
/// told when both agree:
/// - its things are less than half a metre across, and all its lights are so near for their intensity that every place is a thousand
///   times brighter than white: made in metres, a scene as large as this in kilometres, say;
/// - its things are more than ten metres across, nothing shines but its lights, and all these are so far for their intensity that
///   every place is a thousand times darker than white: black in the picture, as where the millimetres of a drawing are taken for metres.
std::string noteOnUnits(const Scene& scene);

} // namespace shadowlab::scene
