// Embree's packets of eight rays, doing a whole shadow picture: the reference for the speed of the blocks of rays
// (block_rays.h). It answers in float, with an offset against acne, so near edges its picture is another.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Eye rays of a picture and one light, in float, in centred space: through the middle of pixel (x, y) runs
/// corner + (x + 0.5) * perX + (y + 0.5) * perY.
struct PacketView {
    vec3 eye, corner, perX, perY, light;
    int width; ///< a multiple of eight
};

class EmbreePackets {
public:
    virtual ~EmbreePackets() = default;
    /// A row of the picture: 0 nothing is seen, 1 in shadow, 2 lit.
    virtual void row(const PacketView& view, int y, std::uint8_t* mask) const = 0;
};

/// Nothing where the program was built without Embree.
std::unique_ptr<EmbreePackets> makeEmbreePackets(const std::vector<Triangle>& triangles);

} // namespace shadowlab::trace
