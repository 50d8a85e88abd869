// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::shadow_volume {

namespace {

template <typename Visit>
void forEachNeighbour(const CountedPart& part, ivec2 pixel, const Visit& visit) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (const ivec2 other = pixel + ivec2(dx, dy); other != pixel && part.holds(other)) visit(other);
}

/// Cuts off of a segment what lies where a value, linear along it, is below zero. False when nothing is left.
template <typename Point>
bool keepPositive(Point& a, Point& b, double atA, double atB) {
    if (atA < 0 && atB < 0) return false;
    if (atA < 0)
        a += (b - a) * (atA / (atA - atB));
    else if (atB < 0)
        b += (a - b) * (atB / (atB - atA));
    return true;
}

/// In pixels of the part, from its upper left corner, and with the depth as the third coordinate: that is linear along a
/// line in the picture, too.
struct SegmentPx {
    dvec3 a, b;
};

/// An edge as the eye sees it, as far as it lies in the part and one pixel around it.
std::optional<SegmentPx> projected(dvec4 aClip, dvec4 bClip, const CountedPart& part) {
    if (!keepPositive(aClip, bClip, aClip.z + aClip.w, bClip.z + bClip.w)) return std::nullopt; // the near plane
    const auto inPart = [&](const dvec4& clip) {
        const dvec3 shares(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w, 0.5 + 0.5 * clip.z / clip.w);
        return dvec3(dvec2(shares) * dvec2(part.pictureSize) - dvec2(part.corner), shares.z);
    };
    SegmentPx segment{inPart(aClip), inPart(bClip)};
    for (int axis = 0; axis < 2; ++axis) {
        const double last = part.size[axis] + 1.0;
        if (!keepPositive(segment.a, segment.b, segment.a[axis] + 1, segment.b[axis] + 1)) return std::nullopt;
        if (!keepPositive(segment.a, segment.b, last - segment.a[axis], last - segment.b[axis])) return std::nullopt;
    }
    return segment;
}

// An edge lies on the surface of its caster. The two depths are rounded to 24 bits, and from clip coordinates in float.
constexpr double kDepthSlack = 1e-6;

/// The largest depth of a pixel and its neighbours, so that a surface seen edge-on does not hide its own edge.
float farthestAround(const CountedPart& part, ivec2 pixel) {
    float farthest = part.depth(part.index(pixel));
    forEachNeighbour(part, pixel, [&](ivec2 other) { farthest = std::max(farthest, part.depth(part.index(other))); });
    return farthest;
}

/// Row by row, the pixels between where the segment enters the row and where it leaves it.
void markTouched(const CountedPart& part, SegmentPx segment, PixelMask& marked) {
    if (segment.a.y > segment.b.y) std::swap(segment.a, segment.b);
    const dvec3 along = segment.b - segment.a;
    const int firstRow = std::max(static_cast<int>(std::floor(segment.a.y)), 0);
    const int lastRow = std::min(static_cast<int>(std::floor(segment.b.y)), part.size.y - 1);
    for (int y = firstRow; y <= lastRow; ++y) {
        const auto at = [&](double row) {
            const double share = along.y > 0 ? std::clamp((row - segment.a.y) / along.y, 0.0, 1.0)
                                 : row > y   ? 1.0
                                             : 0.0;
            return segment.a + share * along;
        };
        const dvec3 in = at(y), out = at(y + 1);
        const int firstColumn = std::max(static_cast<int>(std::floor(std::min(in.x, out.x))), 0);
        const int lastColumn = std::min(static_cast<int>(std::floor(std::max(in.x, out.x))), part.size.x - 1);
        const double nearest = std::min(in.z, out.z);
        for (int x = firstColumn; x <= lastColumn; ++x)
            if (nearest <= farthestAround(part, {x, y}) + kDepthSlack)
                marked[part.index({x, y})] |= static_cast<std::uint8_t>(part.hasSurface(part.index({x, y})));
    }
}

/// The marked pixels, counted in the whole picture, those of a block of rays next to each other.
std::vector<ivec2> inPicture(const CountedPart& part, const PixelMask& marked) {
    constexpr int kBlock = trace::SceneTracer::kBlock;
    std::vector<ivec2> pixels;
    for (int y = 0, begin = 0; y < part.size.y; ++y) {
        const std::uint8_t* const row = &marked[part.index({0, y})];
        const std::uint8_t* const end = row + part.size.x;
        const auto next = [&](const std::uint8_t* from) { // memchr looks at many bytes at a time
            return static_cast<const std::uint8_t*>(std::memchr(from, 1, static_cast<std::size_t>(end - from)));
        };
        for (const std::uint8_t* at = next(row); at; at = next(at + 1))
            pixels.push_back(part.corner + ivec2(static_cast<int>(at - row), y));
        const int below = part.corner.y + y + 1;
        if (below % kBlock != 0 && y + 1 < part.size.y) continue; // the rows of blocks go on
        std::ranges::stable_sort(pixels.begin() + begin, pixels.end(), {}, [](ivec2 pixel) { return pixel.x / kBlock; });
        begin = static_cast<int>(pixels.size());
    }
    return pixels;
}

/// 1 for each pixel of a row that is dark.
void readBits(const CountedPart& part, int y, std::span<std::uint8_t> bits) {
    const std::uint32_t* const words = &part.words[part.index({0, y})];
    for (std::size_t x = 0; x < bits.size(); ++x)
        bits[x] = (words[x] & part.countMask) != 0 ? 1 : 0;
}

/// The rows from `begin` to before `end`.
void markDifferingRows(const CountedPart& part, int begin, int end, PixelMask& marked) {
    // Three pixels in a column agree when their sum is 0 or 3; so do nine in a square when it is 0 or 9. The sum of each column is
    // computed once, and used by the three squares that it belongs to. Where a square reaches beyond the picture, its middle stands
    // for what is missing. Plain loops over bytes, which compilers turn into vector instructions.
    const auto width = static_cast<std::size_t>(part.size.x);
    std::vector<std::uint8_t> above(width), row(width), below(width), columns(width + 2), differs(width);
    readBits(part, begin, row);
    readBits(part, std::max(begin - 1, 0), above);
    // Unknown pixels beyond the part.
    const ivec2 lower = part.isAll ? ivec2(0) : part.corner;
    const ivec2 upper = part.isAll ? ivec2(0) : part.pictureSize - part.corner - part.size;
    for (int y = begin; y < end; ++y) {
        if (y + 1 < part.size.y)
            readBits(part, y + 1, below);
        else
            below = row;
        for (std::size_t x = 0; x < width; ++x)
            columns[x + 1] = static_cast<std::uint8_t>(above[x] + row[x] + below[x]);
        columns[0] = columns[1];
        columns[width + 1] = columns[width];
        std::uint8_t any = 0;
        for (std::size_t x = 0; x < width; ++x) {
            const auto sum = static_cast<std::uint8_t>(columns[x] + columns[x + 1] + columns[x + 2]);
            differs[x] = sum != 0 && sum != 9 ? 1 : 0;
            any |= differs[x];
        }
        if ((y == 0 && lower.y > 0) || (y + 1 == part.size.y && upper.y > 0)) std::ranges::fill(differs, any = 1);
        if (lower.x > 0) differs.front() = any = 1;
        if (upper.x > 0) differs.back() = any = 1;
        const std::size_t first = part.index({0, y});
        for (std::size_t x = 0; any != 0 && x < width; ++x)
            if (differs[x] != 0 && part.hasSurface(first + x)) marked[first + x] = 1;
        std::swap(above, row);
        std::swap(row, below);
    }
}

} // namespace

void markDiffering(const CountedPart& part, PixelMask& marked) {
    constexpr int kRows = 64; // for a thread at a time
    const int bands = (part.size.y + kRows - 1) / kRows;
    trace::parallelFor(static_cast<std::size_t>(bands), [&](std::size_t band) {
        const int begin = static_cast<int>(band) * kRows;
        markDifferingRows(part, begin, std::min(begin + kRows, part.size.y), marked);
    });
}

void markEdges(const CountedPart& part, const scene::Mesh& mesh, std::span<const SilhouetteEdge> edges,
               const dmat4& clipFromMesh, PixelMask& marked) {
    const auto clip = [&](std::uint32_t vertex) {
        return clipFromMesh * dvec4(dvec3(mesh.positionsMesh[vertex]), 1.0);
    };
    for (const SilhouetteEdge& edge : edges)
        if (const auto segment = projected(clip(edge.a), clip(edge.b), part)) markTouched(part, *segment, marked);
}

Repair decide(const CountedPart& part, PixelMask& marked, const trace::SceneTracer& tracer, const scene::Camera& camera, int light,
              trace::PixelRays& rays) {
    using enum trace::Visibility;
    Repair repair;
    std::vector<ivec2> pixels = inPicture(part, marked);
    while (!pixels.empty()) {
        const std::vector<trace::Visibility> answers =
            rays.visibilities(pixels, tracer, camera, part.pictureSize, light);
        std::vector<ivec2> next;
        // [anchor: decide-with-rays]
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const ivec2 inPart = pixels[i] - part.corner;
            const bool dark = part.isCounted(part.index(inPart));
            if (answers[i] == noSurface || dark == (answers[i] != lit)) continue;
            repair.flips.push_back(pixels[i]);
            if (answers[i] == turnedAway) continue;
            repair.changed.push_back(pixels[i]);
            forEachNeighbour(part, inPart, [&](ivec2 other) {
                const std::size_t index = part.index(other);
                if (!part.hasSurface(index) || marked[index]) return;
                marked[index] = 1;
                next.push_back(part.corner + other);
            });
        }
        repair.lookedAt.insert(repair.lookedAt.end(), pixels.begin(), pixels.end());
        pixels = std::move(next);
        trace::sortByBlock(pixels);
    }
    return repair;
}

} // namespace shadowlab::shadow_volume
