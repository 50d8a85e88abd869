// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/packets/pixel_rays.h"

#include <algorithm>
#include <tuple>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::trace {

namespace {

constexpr int kSide = SceneTracer::kBlock;

/// Pixels of one block, so that their rays can be traced together.
struct Batch {
    std::size_t first = 0, count = 0; ///< of the list of pixels
};

ivec2 blockOf(ivec2 pixel) { return pixel / kSide; }

std::vector<Batch> batchesOf(std::span<const ivec2> pixels) {
    std::vector<Batch> batches;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i == 0 || blockOf(pixels[i]) != blockOf(pixels[i - 1])) batches.push_back({i, 0});
        ++batches.back().count;
    }
    return batches;
}

/// Where the eye rays through the pixels of one batch end. All of a block at once costs about as much as kMany alone.
void findPoints(std::span<const ivec2> pixels, const SceneTracer& tracer, const EyeRays& rays, ivec2 pictureSize,
                std::span<SurfacePoint> points) {
    constexpr std::size_t kMany = 6;
    if (pixels.size() < kMany) {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            points[i] = tracer.eyePoint(rays, dvec2(pixels[i]) + 0.5);
        return;
    }
    const ivec2 corner = kSide * blockOf(pixels[0]), size = glm::min(ivec2(kSide), pictureSize - corner);
    SurfacePoint all[kSide * kSide];
    tracer.eyePoints(rays, corner, size, dvec2(0.5), all);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const ivec2 inBlock = pixels[i] - corner;
        points[i] = all[inBlock.y * size.x + inBlock.x];
    }
}

} // namespace

void sortByBlock(std::vector<ivec2>& pixels) {
    std::ranges::sort(pixels, {},
                      [](ivec2 pixel) { return std::tuple(blockOf(pixel).y, blockOf(pixel).x, pixel.y, pixel.x); });
}

std::vector<Visibility> visibilitiesOf(std::span<const ivec2> pixels, const SceneTracer& tracer, const EyeRays& rays,
                                       ivec2 pictureSize, int light) {
    std::vector<Visibility> answers(pixels.size());
    const std::vector<Batch> batches = batchesOf(pixels);
    parallelFor(batches.size(), [&](std::size_t i) {
        const auto [first, count] = batches[i];
        SurfacePoint points[kSide * kSide];
        findPoints(pixels.subspan(first, count), tracer, rays, pictureSize, points);
        tracer.visibilities(std::span(points).first(count), light, std::span(answers).subspan(first, count));
    });
    return answers;
}

} // namespace shadowlab::trace
