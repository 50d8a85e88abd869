// A picture cut into square blocks of pixels: the pieces of work that threads take.
//
// Rows of blocks lie one below the other, counted from the top, so the part of a picture that is done is its upper part.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "techniques/foundation/math/types.h"

namespace shadowlab::trace {

struct Blocks {
    ivec2 size; ///< of the picture, pixels
    int side;   ///< of a block, pixels; those at the right and lower border may be smaller

    /// How many lie beside and below each other.
    [[nodiscard]] ivec2 grid() const { return (size + side - 1) / side; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(grid().x * grid().y); }
    /// Its upper left pixel.
    [[nodiscard]] ivec2 corner(std::size_t block) const {
        return side * ivec2(static_cast<int>(block) % grid().x, static_cast<int>(block) / grid().x);
    }
    [[nodiscard]] ivec2 sizeAt(ivec2 corner) const { return glm::min(ivec2(side), size - corner); }
};

} // namespace shadowlab::trace
