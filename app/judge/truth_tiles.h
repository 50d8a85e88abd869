// What every truth is made of: tiles of pixels, the points that their eye rays end in, and the points around a centre that
// decide whether a pixel is a tie.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <functional>
#include <optional>

#include "app/judge/truth.h"

namespace shadowlab::judge {

constexpr int kTileSide = trace::SceneTracer::kBlock;
constexpr std::size_t kTilePixels = std::size_t(kTileSide) * kTileSide;

/// The pixels of one tile: as many as kTileSide on a side, fewer at the picture's borders.
struct Tile {
    ivec2 corner, size;
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(size.x * size.y); }
};

using TilePoints = std::array<trace::SurfacePoint, kTilePixels>;
using TileVisibility = std::array<trace::Visibility, kTilePixels>;

/// Points around a centre at which the truth is compared with that of the centre: eight on the circle of the tie radius,
/// and eight, turned by half a step, on the circle half as wide, for what is too thin to reach the outer one.
constexpr int kPointsAround = 16;
dvec2 pointAround(int step, double tieRadiusPx);

/// Calls work(tile) for all tiles of a picture, on several threads. Throws trace::Stopped soon after `stop` was requested.
void forEachTile(ivec2 size, const std::stop_token& stop, const std::function<void(const Tile&)>& work);

/// Calls visit(index in a picture of that size, index in the tile, pixel).
template <typename Visit>
void forEachPixel(const Tile& tile, ivec2 size, const Visit& visit) {
    for (int y = 0; y < tile.size.y; ++y)
        for (int x = 0; x < tile.size.x; ++x) {
            const ivec2 pixel = tile.corner + ivec2(x, y);
            visit(static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x),
                  static_cast<std::size_t>(y * tile.size.x + x), pixel);
        }
}

/// The object that a point lies on; trace::kNoPrimitive for none.
std::uint32_t objectOf(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

/// What a point is that sees this share of a light with an area: lit where that is more than one half.
trace::Visibility visibilityOf(const trace::SceneTracer& tracer, int light, const trace::SurfacePoint& point, double share);

/// All without a surface, and no ties.
Truth emptyTruth(ivec2 size);

/// Where the pixel would be seen if it showed this triangle, whatever lies before it. The eye ray may just miss the
/// triangle: the point is where it meets the triangle's plane. Nothing where the eye sees the triangle edge-on.
std::optional<trace::SurfacePoint> pointOfPrimitive(const trace::SceneTracer& tracer, const trace::EyeRays& rays,
                                                    std::uint32_t primitive, dvec2 pixel);

} // namespace shadowlab::judge
