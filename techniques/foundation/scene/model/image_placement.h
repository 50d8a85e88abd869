// Where an image lies on a surface.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// From a texture coordinate to a place in the image, (0, 0) its lower left corner and (1, 1) its upper right one. Options -s, -o and
/// -clamp of MTL files. The same formula is in shaders/image_place.glsl.
struct ImagePlacement {
    dvec2 scale{1.0}, offset{0.0};
    bool clamped = false; ///< beyond its border the image goes on as at the border; else it repeats

    [[nodiscard]] dvec2 at(const dvec2& texcoord) const { return texcoord * scale + offset; }
    friend bool operator==(const ImagePlacement&, const ImagePlacement&) = default;
};

} // namespace shadowlab::scene
