// The planes around what is in view.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/foundation/scene/query/picture_part.h"

namespace shadowlab::scene {

/// Left, right, bottom, top and near plane of that part of the view, in the world: positive inside. The far plane is at infinity.
inline std::array<dvec4, 5> planesWorld(const dmat4& clipFromWorld, const PicturePart& part) {
    const dmat4 transposed = glm::transpose(clipFromWorld);
    return {transposed * dvec4(1, 0, 0, -part.lower.x), transposed * dvec4(-1, 0, 0, part.upper.x),
            transposed * dvec4(0, 1, 0, -part.lower.y), transposed * dvec4(0, -1, 0, part.upper.y),
            transposed * dvec4(0, 0, 1, 1)};
}

} // namespace shadowlab::scene
