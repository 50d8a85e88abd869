// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/alias_free.h"

#include <algorithm>

#include "techniques/shadow_map/irregular/bucket_test.h"
#include "techniques/shadow_map/irregular/sample_strips.h"
#include "techniques/shadow_map/irregular/seen_triangle.h"

namespace shadowlab::shadow_map {

namespace {

// Triangles that one thread handles in a row, and that a strip passes over together.
constexpr std::size_t kTrianglePiece = 2048;

/// Some triangles, in their order, that may cover something of one plane.
struct TriangleRun {
    std::vector<SeenTriangle> triangles;
    std::vector<vec2> lower, upper; ///< the rectangle that each covers at most
    PlaneRect rect;                 ///< all of them together
};

/// Per plane, runs that together hold all triangles that may cover a sample.
std::vector<std::vector<TriangleRun>> seeTriangles(const ShadowQuery& query, const Samples& samples) {
    const std::vector<trace::Triangle>& triangles = query.tracer.world().triangles;
    const std::span<const std::uint8_t> blocks = query.tracer.blockers(query.light);
    const std::vector<TriangleRun> none((triangles.size() + kTrianglePiece - 1) / kTrianglePiece);
    std::vector<std::vector<TriangleRun>> runs(samples.planes.size(), none);
    inPieces(triangles.size(), kTrianglePiece, query.threads,
             [&](std::size_t piece, std::size_t first, std::size_t end) {
                 for (std::size_t p = 0; p < runs.size(); ++p) {
                     const LightPlane& plane = samples.planes[p];
                     const auto& [box, count] = samples.regions[p];
                     const Asked asked{box.rect, box.largestCoordinate(plane.parallel), query.extent()};
                     TriangleRun& run = runs[p][piece];
                     for (std::size_t i = first; i < end && count > 0; ++i) {
                         if (!blocks[i]) continue;
                         const auto rect = coveredRect(plane, triangles[i], asked);
                         if (!rect) continue;
                         run.triangles.push_back(seenFrom(plane, triangles[i], static_cast<std::uint32_t>(i), asked));
                         run.triangles.back().mayHaveHoles = query.tracer.mayHaveHoles(static_cast<std::uint32_t>(i));
                         run.lower.emplace_back(rect->lower);
                         run.upper.emplace_back(rect->upper);
                         run.rect.include(*rect);
                     }
                 }
             });
    return runs;
}

/// One strip of samples, and all triangles.
class StripTest {
public:
    StripTest(const ShadowQuery& query, SampleStrip& strip)
        : strip_(strip), triangles_(strip.buckets.size(), 0), test_(query) {}

    void test(const TriangleRun& run) {
        if (run.rect.lower.x > strip_.rect.upper.x || run.rect.upper.x < strip_.rect.lower.x) return;
        const vec2 lower(strip_.rect.lower), upper(strip_.rect.upper);
        for (std::size_t t = 0; t < run.triangles.size(); ++t)
            if (run.lower[t].x <= upper.x && run.upper[t].x >= lower.x)
                test(run.triangles[t], run.lower[t], run.upper[t]);
    }

    void record(int plane, AliasFreeRecord& record) const {
        for (std::size_t b = 0; b < strip_.buckets.size(); ++b) {
            const Bucket& bucket = strip_.buckets[b];
            record.buckets.push_back(
                {plane, {strip_.lower[b], strip_.upper[b]}, bucket.count, bucket.live, triangles_[b]});
            record.samples += bucket.count;
            record.overlaps += triangles_[b];
        }
        record.askedExactly += test_.askedExactly();
    }

private:
    /// The triangle against all buckets that its rectangle meets.
    void test(const SeenTriangle& triangle, const vec2& lower, const vec2& upper) {
        const auto from = std::ranges::lower_bound(strip_.upper, lower.y, {}, &vec2::y) - strip_.upper.begin();
        for (auto b = static_cast<std::size_t>(from); b < strip_.buckets.size() && strip_.lower[b].y <= upper.y; ++b)
            if (strip_.lower[b].x <= upper.x && strip_.upper[b].x >= lower.x && strip_.buckets[b].live > 0)
                triangles_[b] += test_.test(triangle, strip_.buckets[b]);
    }

    SampleStrip& strip_;
    std::vector<std::uint32_t> triangles_; ///< of each bucket, how many were tested
    BucketTest test_;
};

} // namespace

void aliasFreeVisibilities(const trace::SceneTracer& tracer, std::span<const trace::SurfacePoint> points, int light,
                           std::span<trace::Visibility> answers, AliasFreeRecord* record, int threads) {
    const ShadowQuery query{tracer, points, light, answers, threads};
    const Samples samples = findSamples(query);
    const StripLists lists = cutIntoStrips(samples, threads);
    const std::vector<std::vector<TriangleRun>> runs = seeTriangles(query, samples);
    std::vector<AliasFreeRecord> records(record ? lists.strips.size() : 0);
    trace::parallelFor(
        lists.strips.size(),
        [&](std::size_t s) {
            const auto [plane, first, count] = lists.strips[s];
            const auto p = static_cast<std::size_t>(plane);
            // Twice the way within which SceneTracer calls it contact, in metres toward the sun. Toward other lights contact is
            // a share of the way so small that rounding to float covers it.
            const double contact = query.isParallel() ? 2 * trace::kContactPerMetre *
                                                            (1 + 2 * samples.regions[p].box.largestCoordinate(true))
                                                      : 0;
            SampleStrip strip = makeStrip(query, samples, std::span(lists.indices).subspan(first, count), contact);
            StripTest test(query, strip);
            for (const TriangleRun& run : runs[p])
                test.test(run);
            if (record) test.record(plane, records[s]);
        },
        threads);
    if (!record) return;
    *record = {};
    record->planes = samples.planes;
    for (const AliasFreeRecord& ofStrip : records) {
        record->buckets.insert(record->buckets.end(), ofStrip.buckets.begin(), ofStrip.buckets.end());
        record->samples += ofStrip.samples;
        record->overlaps += ofStrip.overlaps;
        record->askedExactly += ofStrip.askedExactly;
    }
}

} // namespace shadowlab::shadow_map
