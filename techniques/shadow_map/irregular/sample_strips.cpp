// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/sample_strips.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowlab::shadow_map {

namespace {

/// About one sample in 64, chosen by Knuth's multiplicative hash: every 64th would always be in the same columns of a picture
/// that is a multiple of 64 wide.
bool isPolled(std::size_t index) { return static_cast<std::uint32_t>(index) * 0x9e3779b9u >> 26 == 0; }

/// Where, along u, the strips of a plane meet: so many that buckets are about as many in a strip as strips in the plane.
std::vector<double> bordersOf(std::vector<double> polled, std::size_t samples) {
    const auto strips = static_cast<std::size_t>(
        std::lround(std::sqrt(static_cast<double>(samples) / static_cast<double>(kBucketSamples))));
    std::ranges::sort(polled);
    std::vector<double> borders;
    for (std::size_t i = 1; i < strips && !polled.empty(); ++i)
        borders.push_back(polled[i * polled.size() / strips]);
    return borders;
}

/// A sample of a strip: all that sorting along v moves about.
struct Key {
    float v;
    std::uint32_t index;
};

/// Puts the lower half, in whole buckets, before the upper, and so on within each: the buckets then lie in order.
void sortBuckets(std::span<Key> keys) {
    if (keys.size() <= kBucketSamples) return;
    const std::size_t middle = (keys.size() / kBucketSamples + 1) / 2 * kBucketSamples;
    std::ranges::nth_element(keys, keys.begin() + static_cast<std::ptrdiff_t>(middle), {}, &Key::v);
    sortBuckets(keys.first(middle));
    sortBuckets(keys.subspan(middle));
}

/// Returns the rectangle that holds the samples.
PlaneRect fill(Bucket& bucket, const ShadowQuery& query, const Samples& samples, std::span<const Key> keys,
               double contact) {
    PlaceBox box;
    for (const Key& key : keys)
        box.include(samples.places[key.index]);
    bucket.middle = 0.5 * (box.rect.lower + box.rect.upper);
    bucket.farthest = box.farthest;
    bucket.largest = box.largestCoordinate(query.isParallel());
    vec2 half(0.0f);
    for (const Key& key : keys) {
        const dvec3& place = samples.places[key.index];
        const vec2 here(dvec2(place) - bucket.middle);
        bucket.u[bucket.count] = here.x;
        bucket.v[bucket.count] = here.y;
        bucket.nearness[bucket.count] = static_cast<float>(place.z);
        bucket.primitives[bucket.count] = query.points[key.index].primitive;
        bucket.indices[bucket.count++] = key.index;
        half = glm::max(half, glm::abs(here));
    }
    // Places that are not used are tested along with the others of their four; they may hold anything that is a number.
    for (std::size_t i = bucket.count; i < kBucketSamples; ++i)
        bucket.u[i] = bucket.v[i] = bucket.nearness[i] = 0;
    bucket.half = dvec2(half);
    bucket.live = bucket.count;
    constexpr double kRounding = 0x1p-23; // of a nearness to float: twice what it can be
    bucket.clearance = kRounding * std::max(std::abs(box.farthest), std::abs(box.nearest)) + contact;
    return box.rect;
}

} // namespace

StripLists cutIntoStrips(const Samples& samples, int threads) {
    // The cuts are estimated from a subset of the samples. Which samples are in it does not depend on the number of threads, so neither
    // do the strips.
    const std::size_t planes = samples.regions.size(), count = samples.places.size();
    std::vector<std::vector<double>> polled(planes), borders(planes);
    for (std::size_t i = 0; i < count; ++i)
        if (isPolled(i) && samples.planeOf[i] != kNotAsked) polled[samples.planeOf[i]].push_back(samples.places[i].x);
    StripLists lists;
    std::vector<std::size_t> firstStrip;
    for (std::size_t p = 0; p < planes; ++p) {
        borders[p] = bordersOf(std::move(polled[p]), samples.regions[p].count);
        firstStrip.push_back(lists.strips.size());
        for (std::size_t s = 0; s <= borders[p].size() && samples.regions[p].count > 0; ++s)
            lists.strips.push_back({static_cast<int>(p), 0, 0});
    }

    // A counting sort: how many of each piece of the picture go to each strip; where they so begin; there they go.
    const std::size_t strips = lists.strips.size();
    std::vector<std::vector<std::uint32_t>> nextOf(count / kPointPiece + 1, std::vector<std::uint32_t>(strips, 0));
    std::vector<std::uint16_t> stripOf(count);
    inPieces(count, kPointPiece, threads, [&](std::size_t piece, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            if (samples.planeOf[i] == kNotAsked) continue;
            const std::vector<double>& cuts = borders[samples.planeOf[i]];
            const auto at = std::ranges::upper_bound(cuts, samples.places[i].x) - cuts.begin();
            stripOf[i] = static_cast<std::uint16_t>(firstStrip[samples.planeOf[i]] + static_cast<std::size_t>(at));
            ++nextOf[piece][stripOf[i]];
        }
    });
    std::uint32_t next = 0;
    for (std::size_t s = 0; s < strips; ++s) {
        lists.strips[s].first = next;
        for (std::vector<std::uint32_t>& ofPiece : nextOf)
            next += std::exchange(ofPiece[s], next);
        lists.strips[s].count = next - lists.strips[s].first;
    }
    lists.indices.resize(next);
    inPieces(count, kPointPiece, threads, [&](std::size_t piece, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            if (samples.planeOf[i] != kNotAsked)
                lists.indices[nextOf[piece][stripOf[i]]++] = static_cast<std::uint32_t>(i);
    });
    return lists;
}

SampleStrip makeStrip(const ShadowQuery& query, const Samples& samples, std::span<const std::uint32_t> indices,
                      double contact) {
    std::vector<Key> keys;
    keys.reserve(indices.size());
    for (const std::uint32_t index : indices)
        keys.push_back({static_cast<float>(samples.places[index].y), index});
    sortBuckets(keys);
    SampleStrip strip;
    strip.buckets.resize((keys.size() + kBucketSamples - 1) / kBucketSamples);
    for (std::size_t b = 0; b < strip.buckets.size(); ++b) {
        const std::size_t first = b * kBucketSamples;
        const PlaneRect rect =
            fill(strip.buckets[b], query, samples,
                 std::span(keys).subspan(first, std::min(kBucketSamples, keys.size() - first)), contact);
        strip.lower.emplace_back(rect.lower);
        strip.upper.emplace_back(rect.upper);
        strip.rect.include(rect.lower);
        strip.rect.include(rect.upper);
    }
    return strip;
}

} // namespace shadowlab::shadow_map
