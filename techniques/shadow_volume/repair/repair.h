// Finds the pixels in which the count may be wrong, and decides them again with rays. Knows no graphics API.
//
// A count is wrong where the rasteriser rounded: at a crack between two sides it misses a face or draws one twice, and a
// single pixel is lit among shadowed ones. So a wrong pixel differs from a neighbour. All other pixels that differ from a
// neighbour lie along the outline of the shadow, which is short. All of these are decided again with an eye ray and a
// shadow ray. A shadow ray alone, from the surface that the rasteriser shows, would be wrong where that surface is not the
// nearest one.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

/// What was counted in a rectangle of a picture: one entry per pixel of the rectangle, rows from the top.
struct CountedPart {
    ivec2 pictureSize{0}, corner{0}, size{0}; ///< pixels; the corner is the upper left one
    std::vector<std::uint8_t> counted;        ///< 1: the count is not zero, the pixel is dark
    std::vector<float> depth;                 ///< as in a depth buffer, 0..1; 1: no surface covers the pixel's centre

    [[nodiscard]] std::size_t index(ivec2 inPart) const {
        return static_cast<std::size_t>(inPart.y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(inPart.x);
    }
    [[nodiscard]] bool hasSurface(std::size_t index) const { return depth[index] < 1; }
    [[nodiscard]] bool holds(ivec2 inPart) const {
        return inPart.x >= 0 && inPart.y >= 0 && inPart.x < size.x && inPart.y < size.y;
    }
};

/// One byte per pixel of a CountedPart.
using PixelMask = std::vector<std::uint8_t>;

/// Marks each pixel that has a surface and of whose eight neighbours one has another bit; neighbours without a surface have
/// a bit, too. At the border of the part the neighbours beyond it are unknown, so such a pixel is always marked.
void markDiffering(const CountedPart& part, PixelMask& marked);

/// Marks each pixel that has a surface and is touched by an edge, as the eye sees it. What lies before the near plane is
/// cut off; edges behind what the pixel and its neighbours show are left out. `clipFromMesh` is of the caster.
void markEdges(const CountedPart& part, const scene::Mesh& mesh, std::span<const SilhouetteEdge> edges,
               const dmat4& clipFromMesh, PixelMask& marked);

/// The result for one pixel of the part.
enum class Repaired : std::uint8_t { notLookedAt, confirmed, changed };

struct Repair {
    std::vector<Repaired> pixels;
    PixelMask flips;         ///< 255 where the bit in the stencil has to be inverted
    bool anyFlipped = false; ///< true if there is such a pixel
    std::size_t lookedAt = 0, changed = 0;
};

/// Decides the marked pixels for a light, and then the neighbours of those that were wrong, until no more are found: errors
/// come in clusters. A pixel is lit or not as the nearest triangle on its eye ray is; where that faces away from the light,
/// the bit becomes dark; the picture seldom changes by that, and it does not count as changed. Where the eye ray meets
/// nothing, the bit stays as it is. The tracer has the scene that was counted.
Repair decide(const CountedPart& part, const PixelMask& marked, const trace::SceneTracer& tracer,
              const scene::Camera& camera, int light);

} // namespace shadowlab::shadow_volume
