// Shading normals of an object in the world, where its scale may stretch them.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// True if the matrix gives normals different lengths: it scales along some axes more than along others. Normals of corners
/// must then be made unit vectors *before* they are interpolated. Otherwise the longer ones would count for more, and the
/// surface would be shaded otherwise than the same mesh written out with that scale.
inline bool stretchesNormals(const dmat3& worldFromObject) {
    // Of turns and even scales the columns are perpendicular and equally long, but for rounding, about 1e-15.
    constexpr double kRounding = 1e-12;
    const dmat3 products = glm::transpose(worldFromObject) * worldFromObject;
    const double length = products[0][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(products[i][j] - (i == j ? length : 0.0)) <= kRounding * length)) return true;
    return false;
}

} // namespace shadowlab::scene
