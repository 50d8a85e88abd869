// A part of an algorithm as it lies in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// What the second camera, which looks on from outside, shows beside the objects: a light's frustum, the faces of a volume,
/// the plane of a receiver.
struct SceneShape {
    enum class Kind { lines, faces };
    std::string label; ///< what it is, in a few words: they are written beside it; shapes of one label have one colour
    vec3 colorLinear;
    Kind kind = Kind::lines;
    std::vector<dvec3>
        pointsWorld; ///< lines: two for each segment; faces: three for each triangle, seen from both sides
    /// The object that it was made from, as an index into the scene's: of the shapes with an object, the picture shows those of
    /// one object only, where not all are asked for. None: it belongs to no single object, and is always shown.
    std::optional<std::size_t> object{};
    bool onRequest = false; ///< left out where it is not asked for: it would distract from the rest
};

} // namespace shadowlab
