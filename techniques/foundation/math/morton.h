// Morton's curve through cells of a grid: what is near along it is mostly near in space. G. M. Morton, "A Computer Oriented Geodetic Data Base
// and a New Technique in File Sequencing", IBM, 1966.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// How far along the curve a cell lies: the bits of its coordinates in turn, `bits` of each (at most 64 together). Coordinates are 0 or more.
template <glm::length_t N>
constexpr std::uint64_t alongMortonCurve(const glm::vec<N, int>& cell, int bits) {
    std::uint64_t place = 0;
    for (int bit = 0; bit < bits; ++bit)
        for (glm::length_t axis = 0; axis < N; ++axis)
            place |= static_cast<std::uint64_t>(cell[axis] >> bit & 1) << (N * bit + axis);
    return place;
}

} // namespace shadowlab
