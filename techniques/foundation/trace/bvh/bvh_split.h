// Splits a group of triangles in two so that the expected work of a ray is least (surface area heuristic): one step of
// building the tree (bvh_build.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <span>

#include "techniques/foundation/trace/bvh/float4.h"

namespace shadowlab::trace {

/// A box; the fourth lane means nothing.
struct SplitBox {
    Float4 lower = Float4::all(std::numeric_limits<float>::infinity());
    Float4 upper = Float4::all(-std::numeric_limits<float>::infinity());
    void include(const SplitBox& other) {
        lower = smaller(lower, other.lower);
        upper = larger(upper, other.upper);
    }
    void include(Float4 point) {
        lower = smaller(lower, point);
        upper = larger(upper, point);
    }
    [[nodiscard]] float halfArea() const {
        alignas(16) float d[4];
        (upper - lower).store(d);
        return d[0] < 0 ? 0 : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    }
};

/// A triangle as the builder sees it: its box, rounded outward, and in the fourth places nothing and its number.
struct alignas(16) SplitReference {
    float lower[3], none;
    float upper[3];
    std::uint32_t primitive;

    [[nodiscard]] SplitBox box() const { return {Float4::load(lower), firstThree(Float4::load(upper))}; }
    /// Twice the middle of the box.
    [[nodiscard]] Float4 centroid() const { return Float4::load(lower) + firstThree(Float4::load(upper)); }
};

/// Two groups: the first `left` references, and the others. Neither is empty.
struct Split {
    std::uint32_t left = 0;
    SplitBox boxes[2], centroids[2];
};

/// Sorts the references into two groups. The expected work of a group: the chance that a ray meets it, which goes as the area
/// of its box, times the leaves it fills, of `leafSize` triangles each. `halve`: by number, whatever that costs.
Split split(std::span<SplitReference> references, const SplitBox& centroids, std::uint32_t leafSize, bool halve);

} // namespace shadowlab::trace
