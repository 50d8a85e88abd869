// Pictures that were packed as tiles in sheets of WebP, put together again as a page for a browser does.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::testing {

/// Throws std::runtime_error for what is no WebP.
image::Image decodedWebp(std::span<const std::uint8_t> bytes);

/// Tiles of `side` x `side` pixels, row by row in `columns`, each with a border of so many pixels around it.
struct TileSheet {
    image::Image picture;
    int firstTile = 0, count = 0, columns = 1, border = 0;
};

/// A picture of `size` from its tiles by place, row by row; -1: there is none, and nothing is seen.
image::Image fromTiles(ivec2 size, int side, const std::vector<int>& tiles, std::span<const TileSheet> sheets);

} // namespace shadowlab::testing
