// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/packets/pixel_rays.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "techniques/foundation/math/morton.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::trace {

namespace {

constexpr int kSide = SceneTracer::kBlock;

/// Pixels of one block, so that their rays can be traced together.
struct Batch {
    std::size_t first = 0, count = 0; ///< of the list of pixels
    std::size_t place = 0;            ///< of the first of them along the curve
};

ivec2 blockOf(ivec2 pixel) { return pixel / kSide; }

std::vector<Batch> batchesOf(std::span<const ivec2> pixels) {
    std::vector<Batch> batches;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i == 0 || blockOf(pixels[i]) != blockOf(pixels[i - 1])) batches.push_back({.first = i});
        ++batches.back().count;
    }
    return batches;
}

} // namespace

void sortByBlock(std::vector<ivec2>& pixels) {
    std::ranges::sort(pixels, {},
                      [](ivec2 pixel) { return std::tuple(blockOf(pixel).y, blockOf(pixel).x, pixel.y, pixel.x); });
}

std::size_t PixelRays::remembered() const {
    return static_cast<std::size_t>(std::ranges::count_if(blocks_, [](const auto& block) { return block != nullptr; }));
}

void PixelRays::lookAt(const SeenFrom& picture) {
    // Twelve megabytes. Outlines of a light that goes round pass over most of a picture in the end: then it starts afresh.
    constexpr std::size_t kMostRemembered = 8192;
    if (picture == picture_ && remembered() <= kMostRemembered) return;
    picture_ = picture;
    const ivec2 grid = (picture.size + kSide - 1) / kSide;
    blocks_.clear();
    blocks_.resize(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
}

/// Where the eye rays through the pixels of one batch end. All of a block at once costs about as much as kMany alone.
void PixelRays::findPoints(std::span<const ivec2> pixels, const SceneTracer& tracer, const EyeRays& rays,
                           std::span<SurfacePoint> points) {
    constexpr std::size_t kMany = 6;
    const ivec2 place = blockOf(pixels[0]), corner = kSide * place, size = glm::min(ivec2(kSide), picture_.size - corner);
    const int blocksInRow = (picture_.size.x + kSide - 1) / kSide;
    std::unique_ptr<Block>& block = blocks_[static_cast<std::size_t>(place.y * blocksInRow + place.x)];
    if (!block && pixels.size() < kMany) {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            points[i] = tracer.eyePoint(rays, dvec2(pixels[i]) + 0.5);
        return;
    }
    if (!block) {
        block = std::make_unique<Block>();
        tracer.eyePoints(rays, corner, size, dvec2(0.5), *block);
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const ivec2 inBlock = pixels[i] - corner;
        points[i] = (*block)[static_cast<std::size_t>(inBlock.y * size.x + inBlock.x)];
    }
}

std::vector<Visibility> PixelRays::visibilities(std::span<const ivec2> pixels, const SceneTracer& tracer,
                                                const scene::Camera& camera, ivec2 pictureSize, int light) {
    lookAt({tracer.scene(), camera, pictureSize});
    const EyeRays rays = tracer.eyeRays(camera, pictureSize);
    std::vector<Batch> batches = batchesOf(pixels); // of one block each, so that no two threads find the same points
    // Few pixels of a block are asked for, and its shadow rays alone would not fill a bundle: those of near blocks are traced together.
    std::ranges::sort(batches, {}, [&](const Batch& batch) { return alongMortonCurve(blockOf(pixels[batch.first]), 16); });
    std::size_t placed = 0;
    for (Batch& batch : batches)
        batch.place = std::exchange(placed, placed + batch.count);
    points_.resize(pixels.size());
    parallelFor(batches.size(), [&](std::size_t i) {
        const auto [first, count, place] = batches[i];
        findPoints(pixels.subspan(first, count), tracer, rays, std::span(points_).subspan(place, count));
    });
    constexpr std::size_t kBundle = kSide * kSide;
    std::vector<Visibility> found(pixels.size()), answers(pixels.size());
    parallelFor((pixels.size() + kBundle - 1) / kBundle, [&](std::size_t i) {
        const std::size_t first = kBundle * i, count = std::min(kBundle, pixels.size() - first);
        tracer.visibilities(std::span<const SurfacePoint>(points_).subspan(first, count), light, std::span(found).subspan(first, count));
    });
    for (const auto& [first, count, place] : batches)
        std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(place), count, answers.begin() + static_cast<std::ptrdiff_t>(first));
    return answers;
}

} // namespace shadowlab::trace
