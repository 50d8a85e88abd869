// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "techniques/foundation/trace/packets/pixel_rays.h"

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
    float farthest = part.depth[part.index(pixel)];
    forEachNeighbour(part, pixel, [&](ivec2 other) { farthest = std::max(farthest, part.depth[part.index(other)]); });
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

/// The marked pixels, counted in the whole picture.
std::vector<ivec2> inPicture(const CountedPart& part, const PixelMask& marked) {
    std::vector<ivec2> pixels;
    for (int y = 0; y < part.size.y; ++y)
        for (int x = 0; x < part.size.x; ++x)
            if (marked[part.index({x, y})]) pixels.push_back(part.corner + ivec2(x, y));
    return pixels;
}

} // namespace

void markDiffering(const CountedPart& part, PixelMask& marked) {
    // Three pixels in a column agree when their sum is 0 or 3; so do nine in a square when it is 0 or 9. The sum of each
    // column is computed once, and used by the three squares that it belongs to.
    const auto width = static_cast<std::size_t>(part.size.x);
    std::vector<std::uint8_t> columns(width);
    const ivec2 lower = part.corner, upper = part.pictureSize - part.corner - part.size; // pixels beyond the part
    for (int y = 0; y < part.size.y; ++y) {
        const std::uint8_t* row = &part.counted[part.index({0, y})];
        const std::uint8_t* above = y > 0 ? row - width : row;
        const std::uint8_t* below = y + 1 < part.size.y ? row + width : row;
        for (std::size_t x = 0; x < width; ++x)
            columns[x] = static_cast<std::uint8_t>(above[x] + row[x] + below[x]);
        const bool edgeRow = (y == 0 && lower.y > 0) || (y + 1 == part.size.y && upper.y > 0);
        const float* depth = &part.depth[part.index({0, y})];
        std::uint8_t* mark = &marked[part.index({0, y})];
        for (std::size_t x = 0; x < width; ++x) {
            const int sum = columns[x > 0 ? x - 1 : x] + columns[x] + columns[x + 1 < width ? x + 1 : x];
            const bool edge = edgeRow || (x == 0 && lower.x > 0) || (x + 1 == width && upper.x > 0);
            mark[x] |= static_cast<std::uint8_t>(depth[x] < 1 && (edge || (sum != 0 && sum != 9)));
        }
    }
}

void markEdges(const CountedPart& part, const scene::Mesh& mesh, std::span<const SilhouetteEdge> edges,
               const dmat4& clipFromMesh, PixelMask& marked) {
    const auto clip = [&](std::uint32_t vertex) {
        return clipFromMesh * dvec4(dvec3(mesh.positionsMesh[vertex]), 1.0);
    };
    for (const SilhouetteEdge& edge : edges)
        if (const auto segment = projected(clip(edge.a), clip(edge.b), part)) markTouched(part, *segment, marked);
}

Repair decide(const CountedPart& part, const PixelMask& marked, const trace::SceneTracer& tracer,
              const scene::Camera& camera, int light) {
    using enum trace::Visibility;
    const trace::EyeRays rays = tracer.eyeRays(camera, part.pictureSize);
    Repair repair;
    repair.pixels.assign(marked.size(), Repaired::notLookedAt);
    repair.flips.assign(marked.size(), 0);
    std::vector<ivec2> pixels = inPicture(part, marked);
    while (!pixels.empty()) {
        trace::sortByBlock(pixels);
        repair.lookedAt += pixels.size();
        for (const ivec2& pixel : pixels)
            repair.pixels[part.index(pixel - part.corner)] = Repaired::confirmed;
        const std::vector<trace::Visibility> answers =
            trace::visibilitiesOf(pixels, tracer, rays, part.pictureSize, light);
        std::vector<ivec2> next;
        PixelMask waiting(repair.pixels.size(), 0);
        // [anchor: decide-with-rays]
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const ivec2 inPart = pixels[i] - part.corner;
            const bool dark = part.counted[part.index(inPart)] != 0;
            if (answers[i] == noSurface || dark == (answers[i] != lit)) continue;
            repair.flips[part.index(inPart)] = 255;
            repair.anyFlipped = true;
            if (answers[i] == turnedAway) continue;
            repair.pixels[part.index(inPart)] = Repaired::changed;
            ++repair.changed;
            forEachNeighbour(part, inPart, [&](ivec2 other) {
                const std::size_t index = part.index(other);
                if (!part.hasSurface(index) || repair.pixels[index] != Repaired::notLookedAt || waiting[index]) return;
                waiting[index] = 1;
                next.push_back(part.corner + other);
            });
        }
        pixels = std::move(next);
    }
    return repair;
}

} // namespace shadowlab::shadow_volume
