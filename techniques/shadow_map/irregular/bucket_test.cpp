// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/bucket_test.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "techniques/foundation/trace/bvh/float4.h"

namespace shadowlab::shadow_map {

namespace {

using trace::Float4;

// Of the largest that a function can be in a bucket: in float its three coefficients, the sample's place, two products and two
// sums are rounded, at most six times 2^-24 of it, and adding or taking off the bound once more.
constexpr double kFloat = 8 * 0x1p-24;
constexpr double kUnderflow = 1e-30; // float loses digits below 1e-38

/// A linear function of the places of a bucket.
struct InBucket {
    dvec2 slope;
    double middle, spread; ///< its value in the middle; how far it is from that at most
    InBucket(const dvec3& function, const Bucket& bucket)
        : slope(function), middle(function.x * bucket.middle.x + function.y * bucket.middle.y + function.z),
          spread(std::abs(function.x) * bucket.half.x + std::abs(function.y) * bucket.half.y) {}
    [[nodiscard]] double size() const { return std::abs(middle) + spread; }
};

/// The same for four places at once, counted from the bucket's middle.
struct OfFour {
    Float4 middle, slopeU, slopeV;
    explicit OfFour(const InBucket& f)
        : middle(Float4::all(static_cast<float>(f.middle))), slopeU(Float4::all(static_cast<float>(f.slope.x))),
          slopeV(Float4::all(static_cast<float>(f.slope.y))) {}
    [[nodiscard]] Float4 at(Float4 u, Float4 v) const { return middle + slopeU * u + slopeV * v; }
};

} // namespace

bool BucketTest::test(const SeenTriangle& triangle, Bucket& bucket) {
    const double m = std::max(triangle.largest, bucket.largest);
    const Sizes sizes{m, std::min(m, extent_)};
    const InBucket sides[3] = {{triangle.sides[0], bucket}, {triangle.sides[1], bucket}, {triangle.sides[2], bucket}};
    const double size = std::max({sides[0].size(), sides[1].size(), sides[2].size()});
    const double bound = kFloat * size + triangle.sideBound(m) + kUnderflow;
    bool outside = false, inFront = false; // of some side: is all of the bucket?
    for (const InBucket& side : sides) {
        outside |= side.middle + side.spread < -bound;
        inFront |= side.middle - side.spread > bound;
    }
    // For a triangle in doubt the inner side of its edges is not known: then only sides of both signs are a miss, and the nearness
    // says nothing.
    const bool certain = isCertain(triangle.determinant, sizes, parallel_);
    if (outside && (certain || inFront)) return false;
    const InBucket plane(triangle.nearness, bucket);
    const double error =
        kFloat * plane.size() + triangle.nearnessBound(sizes, plane.size(), parallel_) + kUnderflow + bucket.clearance;
    if (certain && std::min(plane.middle + plane.spread, triangle.nearest) + error < bucket.farthest) return false;

    const OfFour side[3] = {OfFour(sides[0]), OfFour(sides[1]), OfFour(sides[2])}, nearness(plane);
    const Float4 above = Float4::all(static_cast<float>(bound)), below = Float4::all(static_cast<float>(-bound));
    const Float4 clearance = Float4::all(static_cast<float>(error));
    // From the last sample to the first: a sample that is dropped is replaced by the last one, which has been tested by then.
    for (unsigned four = (bucket.live + 3) / 4; four-- > 0;) {
        const unsigned first = 4 * four;
        const Float4 u = Float4::load(bucket.u + first), v = Float4::load(bucket.v + first);
        const Float4 a = side[0].at(u, v), b = side[1].at(u, v), c = side[2].at(u, v);
        const int out = whereLess(a, below) | whereLess(b, below) | whereLess(c, below);
        const int in = whereLess(above, a) | whereLess(above, b) | whereLess(above, c);
        int possible = ~(certain ? out : out & in) & 0xf, sure = 0;
        if (first + 4 > bucket.live) possible &= (1 << (bucket.live - first)) - 1;
        if (!possible) continue;
        if (certain) {
            const Float4 own = Float4::load(bucket.nearness + first), here = nearness.at(u, v);
            possible &= ~whereLess(here + clearance, own);
            sure = whereLess(above, a) & whereLess(above, b) & whereLess(above, c) & whereLess(own, here - clearance);
        }
        while (possible) {
            const int lane = std::bit_width(static_cast<unsigned>(possible)) - 1;
            possible &= ~(1 << lane);
            const unsigned sample = first + static_cast<unsigned>(lane);
            if (query_.tracer.isLeft(bucket.primitives[sample], triangle.primitive)) continue; // its own, or one in the same place
            if ((sure >> lane & 1 && !triangle.mayHaveHoles) || isBlocked(bucket, sample, triangle, certain))
                drop(bucket, sample);
        }
    }
    return true;
}

// [anchor: samples-in-the-light]
bool BucketTest::isBlocked(const Bucket& bucket, unsigned sample, const SeenTriangle& triangle, bool certain) {
    ++askedExactly_;
    const trace::SurfacePoint& point = query_.points[bucket.indices[sample]];
    // A triangle in doubt is hit anywhere along itself. Where that may be behind the sample, or behind the light, too, what a
    // ray finds depends on the boxes of the tree it goes through.
    const bool between = certain || triangle.farthest - bucket.clearance > bucket.nearness[sample];
    return between ? query_.tracer.isBlockedBy(triangle.primitive, point, query_.light)
                   : query_.tracer.visibility(point, query_.light) == trace::Visibility::shadowed;
}

void BucketTest::drop(Bucket& bucket, unsigned sample) {
    query_.answers[bucket.indices[sample]] = trace::Visibility::shadowed;
    const unsigned last = --bucket.live;
    bucket.u[sample] = bucket.u[last];
    bucket.v[sample] = bucket.v[last];
    bucket.nearness[sample] = bucket.nearness[last];
    bucket.primitives[sample] = bucket.primitives[last];
    bucket.indices[sample] = bucket.indices[last];
}

} // namespace shadowlab::shadow_map
