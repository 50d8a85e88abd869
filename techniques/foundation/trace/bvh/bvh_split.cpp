// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/bvh/bvh_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shadowlab::trace {

namespace {

// More bins cut better and cost more; beyond 16 the trees hardly change (Wald 2007). Few triangles need fewer.
constexpr int kMostBins = 16;
int binsFor(std::size_t count) { return std::min(kMostBins, 4 + static_cast<int>(count / 8)); }

/// In which bin of each axis a centroid lies.
struct Binning {
    Float4 origin, scale, last;
    int count;
    std::array<bool, 3> usable{}; ///< axes along which there is something to cut

    Binning(const SplitBox& centroids, std::size_t references)
        : origin(centroids.lower), last(Float4::all(0)), count(binsFor(references)) {
        alignas(16) float from[4], to[4], scales[4] = {0, 0, 0, 0};
        centroids.lower.store(from);
        centroids.upper.store(to);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float extent = to[axis] - from[axis], perExtent = static_cast<float>(count) / extent;
            usable[axis] = extent > 0 && std::isfinite(extent) && std::isfinite(perExtent);
            if (usable[axis]) scales[axis] = perExtent;
        }
        scale = Float4::load(scales);
        last = Float4::all(static_cast<float>(count - 1));
    }
    /// A centroid that is no number (of a triangle larger than float) is in the last; every one is in some.
    void bins(Float4 centroid, std::int32_t* of) const {
        truncate(larger(smaller((centroid - origin) * scale, last), Float4::all(0)), of);
    }
};

struct Cut {
    std::size_t axis = 3; ///< 3: none
    int bin = 0;          ///< the first of the second group
    SplitBox boxes[2];
};

Cut cheapestCut(std::span<const SplitReference> references, const Binning& binning, std::uint32_t leafSize) {
    SplitBox boxes[3][kMostBins];
    std::uint32_t counts[3][kMostBins] = {};
    for (const SplitReference& reference : references) {
        alignas(16) std::int32_t bin[4];
        binning.bins(reference.centroid(), bin);
        const SplitBox box = reference.box();
        for (int axis = 0; axis < 3; ++axis) {
            boxes[axis][bin[axis]].include(box);
            ++counts[axis][bin[axis]];
        }
    }
    const auto leaves = [leafSize](std::uint32_t count) {
        return static_cast<float>((count + leafSize - 1) / leafSize);
    };
    Cut best;
    float leastCost = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!binning.usable[axis]) continue;
        SplitBox right[kMostBins];
        float rightCost[kMostBins];
        SplitBox sum;
        std::uint32_t count = 0;
        for (int bin = binning.count - 1; bin > 0; --bin) {
            sum.include(boxes[axis][bin]);
            count += counts[axis][bin];
            right[bin] = sum;
            rightCost[bin] = sum.halfArea() * leaves(count);
        }
        sum = {};
        count = 0;
        for (int bin = 1; bin < binning.count; ++bin) {
            sum.include(boxes[axis][bin - 1]);
            count += counts[axis][bin - 1];
            if (count == 0) continue;
            if (count == references.size()) break;
            const float cost = sum.halfArea() * leaves(count) + rightCost[bin];
            if (!(cost < leastCost)) continue;
            leastCost = cost;
            best = {axis, bin, {sum, right[bin]}};
        }
    }
    return best;
}

Split halved(std::span<SplitReference> references, const SplitBox& centroids) {
    alignas(16) float extent[4];
    (centroids.upper - centroids.lower).store(extent);
    const auto axis = static_cast<std::size_t>(std::max_element(extent, extent + 3) - extent);
    const auto half = static_cast<std::ptrdiff_t>(references.size() / 2);
    const auto key = [axis](const SplitReference& r) { return std::pair(r.lower[axis] + r.upper[axis], r.primitive); };
    const auto precedes = [&](const SplitReference& a, const SplitReference& b) {
        const auto [middleA, numberA] = key(a);
        const auto [middleB, numberB] = key(b);
        // NaN is sorted last, so that the order is defined.
        if (std::isnan(middleA) || std::isnan(middleB))
            return std::pair(std::isnan(middleA), numberA) < std::pair(std::isnan(middleB), numberB);
        return std::pair(middleA, numberA) < std::pair(middleB, numberB);
    };
    std::nth_element(references.begin(), references.begin() + half, references.end(), precedes);
    Split split;
    split.left = static_cast<std::uint32_t>(half);
    for (std::size_t i = 0; i < references.size(); ++i) {
        const std::size_t group = i < split.left ? 0 : 1;
        split.boxes[group].include(references[i].box());
        split.centroids[group].include(references[i].centroid());
    }
    return split;
}

} // namespace

Split split(std::span<SplitReference> references, const SplitBox& centroids, std::uint32_t leafSize, bool halve) {
    if (halve) return halved(references, centroids);
    const Binning binning(centroids, references.size());
    const Cut cut = cheapestCut(references, binning, leafSize);
    if (cut.axis == 3) return halved(references, centroids); // all centroids in one point, say
    Split split{0, {cut.boxes[0], cut.boxes[1]}, {}};
    std::size_t left = 0, right = references.size(); // sorted up to here, and from here on
    while (left < right) {
        const Float4 centroid = references[left].centroid();
        alignas(16) std::int32_t bin[4];
        binning.bins(centroid, bin);
        if (bin[cut.axis] < cut.bin) {
            split.centroids[0].include(centroid);
            ++left;
        } else {
            split.centroids[1].include(centroid);
            std::swap(references[left], references[--right]);
        }
    }
    split.left = static_cast<std::uint32_t>(left);
    return split;
}

} // namespace shadowlab::trace
