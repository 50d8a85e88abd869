// A part of an algorithm as it lies in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// What the second camera, which looks on from outside, shows beside the objects: a light's frustum, the faces of a volume,
/// the plane of a receiver.
struct SceneShape {
    enum class Kind { lines, faces };
    std::string label; ///< what it is, for the key of the colours; shapes of one label have one colour
    vec3 colorLinear;
    Kind kind = Kind::lines;
    std::vector<dvec3>
        pointsWorld; ///< lines: two for each segment; faces: three for each triangle, seen from both sides
};

} // namespace shadowlab
