// A triangle against the samples of a bucket, four at a time: the inner loop of the alias-free shadow map.
//
// In float, with bounds for what it gets wrong. Within them nothing is decided: the tracer is asked, with the same shadow ray
// as if it had been asked in the first place.
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
    /// In shadow: nobody need ask for it again.
    void drop(Bucket& bucket, unsigned sample);

    const ShadowQuery& query_;
    bool parallel_;
    double extent_;
    std::uint64_t askedExactly_ = 0;
};

} // namespace shadowlab::shadow_map
