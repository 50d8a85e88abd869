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

#include "techniques/foundation/trace/packets/pixel_rays.h"
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

/// What was counted in a rectangle of a picture.
struct CountedPart {
    ivec2 pictureSize{0}, corner{0}, size{0}; ///< pixels; the corner is the upper left one
    /// As a target's depth and stencil are read: 24 bits of depth, then 8 of the count, rows from below.
    std::vector<std::uint32_t> words;
    std::uint32_t countMask = 0xff; ///< the bits of the count that are kept
    bool isAll = false;             ///< beyond the part nothing is counted, or nothing that matters

    /// `inPart`: pixels from the part's upper left corner.
    [[nodiscard]] std::size_t index(ivec2 inPart) const {
        return static_cast<std::size_t>(size.y - 1 - inPart.y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(inPart.x);
    }
    /// The count is not zero: the pixel is dark.
    [[nodiscard]] bool isCounted(std::size_t index) const { return (words[index] & countMask) != 0; }
    /// As in a depth buffer, 0..1; 1: no surface covers the pixel's centre.
    [[nodiscard]] float depth(std::size_t index) const { return static_cast<float>(words[index] >> 8) / kNoSurface; }
    [[nodiscard]] bool hasSurface(std::size_t index) const { return words[index] >> 8 != kNoSurface; }
    [[nodiscard]] bool holds(ivec2 inPart) const {
        return inPart.x >= 0 && inPart.y >= 0 && inPart.x < size.x && inPart.y < size.y;
    }
    static constexpr std::uint32_t kNoSurface = 0xffffff;
};

/// One byte per pixel of a CountedPart, 0 or 1, in the same order.
using PixelMask = std::vector<std::uint8_t>;

/// Marks each pixel that has a surface and of whose eight neighbours one has another bit; neighbours without a surface have
/// a bit, too. At the border of the part the neighbours beyond it are unknown unless the part isAll, so such a pixel is always marked.
void markDiffering(const CountedPart& part, PixelMask& marked);

/// Marks each pixel that has a surface and is touched by an edge, as the eye sees it. What lies before the near plane is
/// cut off; edges behind what the pixel and its neighbours show are left out. `clipFromMesh` is of the caster.
void markEdges(const CountedPart& part, const scene::Mesh& mesh, std::span<const SilhouetteEdge> edges,
               const dmat4& clipFromMesh, PixelMask& marked);

/// Pixels of the picture, counted from its upper left corner.
struct Repair {
    std::vector<ivec2> lookedAt; ///< what was decided
    std::vector<ivec2> changed;  ///< of those: the count was wrong
    std::vector<ivec2> flips;    ///< the bit in the stencil has to be inverted
};

/// Decides the marked pixels for a light, and then the neighbours of those that were wrong, until no more are found: errors
/// come in clusters. A pixel is lit or not as the nearest triangle on its eye ray is; where that faces away from the light,
/// the bit becomes dark; the picture seldom changes by that, and it does not count as changed. Where the eye ray meets
/// nothing, the bit stays as it is. The tracer has the scene that was counted. Afterwards all that were looked at are marked.
/// `rays` ask, and remember for the next frame what does not depend on lights.
Repair decide(const CountedPart& part, PixelMask& marked, const trace::SceneTracer& tracer, const scene::Camera& camera, int light,
              trace::PixelRays& rays);

} // namespace shadowlab::shadow_volume
