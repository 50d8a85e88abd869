// SPDX-License-Identifier: MIT
#include "tests/support/webp_tiles.h"

#include <webp/decode.h>

#include <algorithm>
#include <stdexcept>

namespace shadowlab::testing {

image::Image decodedWebp(std::span<const std::uint8_t> bytes) {
    int width = 0, height = 0;
    std::uint8_t* const pixels = WebPDecodeRGBA(bytes.data(), bytes.size(), &width, &height);
    if (!pixels) throw std::runtime_error("no WebP");
    image::Image image(width, height);
    std::copy_n(pixels, image.rgba.size(), image.rgba.begin());
    WebPFree(pixels);
    return image;
}

image::Image fromTiles(ivec2 size, int side, const std::vector<int>& tiles, std::span<const TileSheet> sheets) {
    image::Image whole(size.x, size.y);
    const int across = (size.x + side - 1) / side;
    for (std::size_t place = 0; place < tiles.size(); ++place)
        for (const TileSheet& sheet : sheets) {
            const int number = tiles[place] - sheet.firstTile;
            if (tiles[place] < 0 || number < 0 || number >= sheet.count) continue;
            const int cell = side + 2 * sheet.border;
            image::Image tile(side, side);
            image::blit(tile, -(number % sheet.columns) * cell - sheet.border, -(number / sheet.columns) * cell - sheet.border, sheet.picture);
            image::blit(whole, static_cast<int>(place) % across * side, static_cast<int>(place) / across * side, tile);
        }
    return whole;
}

} // namespace shadowlab::testing
