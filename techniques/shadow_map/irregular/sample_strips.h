// Samples of the light's picture plane, put into buckets of 64: where the eye sees much, the buckets are small.
//
// A regular grid would be simpler, and is what Johnson et al. use ("The Irregular Z-Buffer", ACM TOG 24(4), 2005). But a
// floor that reaches from the eye's feet to the horizon puts nearly all of its samples into one cell of it. So the plane is
// cut into strips of equally many samples, and each strip, across, into buckets of equally many (Leutenegger, Lopez and
// Edgington, "STR: A Simple and Efficient Algorithm for R-Tree Packing", ICDE 1997, without the tree).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/shadow_map/irregular/asked_samples.h"

namespace shadowlab::shadow_map {

// A whole number of fours, which are tested together. A million samples and 10^5 triangles take the same time, to a tenth,
// with anything from 64 to 256; smaller buckets meet more triangles, and larger ones make 10^6 triangles slow.
constexpr std::size_t kBucketSamples = 64;

/// Which samples belong to which strip.
struct StripLists {
    struct Strip {
        int plane;
        std::size_t first, count; ///< of the indices
    };
    std::vector<Strip> strips;
    std::vector<std::uint32_t> indices; ///< of samples
};

/// Strips of about equally many samples of one plane, across u; none without samples.
StripLists cutIntoStrips(const Samples& samples, int threads);

/// Up to kBucketSamples neighbours. Their places count from the middle of the bucket, so that float tells them apart.
struct Bucket {
    alignas(16) float u[kBucketSamples], v[kBucketSamples], nearness[kBucketSamples];
    std::uint32_t primitives[kBucketSamples]; ///< that the samples lie on
    std::uint32_t indices[kBucketSamples];    ///< of the samples
    std::uint32_t count = 0;                  ///< of samples
    std::uint32_t live = 0;                   ///< those that no triangle has put in shadow yet; they come first
    dvec2 middle{0.0}, half{0.0};             ///< all samples are within
    double largest = 0;                       ///< PlaceBox::largestCoordinate() of its samples
    double farthest = 0;                      ///< least nearness of those that live
    double clearance = 0; ///< by how much a blocker must be nearer than a sample to be so for certain
};

/// The buckets of a strip, one behind the other along v.
struct SampleStrip {
    std::vector<Bucket> buckets;
    std::vector<vec2> lower, upper; ///< of each bucket. Along v, neither ever goes back from one to the next
    PlaneRect rect;
};

/// Sorts the samples of one strip. `contact`: by how much a blocker's nearness must differ from the sample's at least.
SampleStrip makeStrip(const ShadowQuery& query, const Samples& samples, std::span<const std::uint32_t> indices,
                      double contact);

} // namespace shadowlab::shadow_map
