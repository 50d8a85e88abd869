// A triangle against the samples of a bucket, four at a time: the inner loop of the alias-free shadow map.
//
// In float, with bounds for the rounding error. A result within its bound decides nothing: then a shadow ray is traced, the same one
// that would be traced without any buckets.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/shadow_map/irregular/sample_strips.h"
#include "techniques/shadow_map/irregular/seen_triangle.h"

namespace shadowlab::shadow_map {

class BucketTest {
public:
    explicit BucketTest(const ShadowQuery& query)
        : query_(query), parallel_(query.isParallel()), extent_(query.extent()) {}

    /// Answers `shadowed` for all living samples that the triangle blocks, and takes them out of the bucket. False when the
    /// bucket as a whole could be passed over.
    bool test(const SeenTriangle& triangle, Bucket& bucket);

    [[nodiscard]] std::uint64_t askedExactly() const { return askedExactly_; }

private:
    bool isBlocked(const Bucket& bucket, unsigned sample, const SeenTriangle& triangle, bool certain);
    /// Takes out a sample that is in shadow: no other triangle need be tested against it.
    void drop(Bucket& bucket, unsigned sample);

    const ShadowQuery& query_;
    bool parallel_;
    double extent_;
    std::uint64_t askedExactly_ = 0;
};

} // namespace shadowlab::shadow_map
