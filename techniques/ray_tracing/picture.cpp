// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/picture.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::ray_tracing {

namespace {

constexpr int kBlock = trace::SceneTracer::kBlock;

/// Calls work(corner, blockSize) for every block of the picture, on all cores. A thread takes a row of blocks at a time: a
/// tenth of a millisecond's work and more, so that taking it costs nothing, and little enough to leave no core idle.
template <typename Work>
void forEachBlock(ivec2 size, const Work& work) {
    trace::parallelFor(static_cast<std::size_t>((size.y + kBlock - 1) / kBlock), [&](std::size_t row) {
        const int y = static_cast<int>(row) * kBlock;
        for (int x = 0; x < size.x; x += kBlock)
            work(ivec2(x, y), glm::min(ivec2(kBlock), size - ivec2(x, y)));
    });
}

/// Calls work(index, index with rows counted from the bottom) for every pixel, a row of blocks at a time.
template <typename Work>
void forEachPixel(ivec2 size, const Work& work) {
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    trace::parallelFor((height + kBlock - 1) / kBlock, [&](std::size_t row) {
        for (std::size_t y = row * kBlock; y < std::min(height, (row + 1) * kBlock); ++y)
            for (std::size_t x = 0; x < width; ++x)
                work(y * width + x, (height - 1 - y) * width + x);
    });
}

} // namespace

void Picture::trace(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                    const TraceSettings& settings) {
    size_ = size;
    eyeWorld_ = camera.positionWorld;
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    points_.resize(pixels);
    visibility_.resize(tracer.scene().lights.size());
    for (Grid<trace::Visibility>& ofLight : visibility_)
        ofLight.resize(pixels);

    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    const dvec2 centre(0.5);
    forEachBlock(size, [&](ivec2 corner, ivec2 blockSize) {
        std::array<trace::SurfacePoint, kBlock * kBlock> blockPoints;
        std::array<trace::Visibility, kBlock * kBlock> blockAnswers;
        const auto count = static_cast<std::size_t>(blockSize.x * blockSize.y);
        const std::span points(blockPoints.data(), count);
        const std::span answers(blockAnswers.data(), count);
        const auto forEachRow = [&](const auto& copy) { // copy(place in the block, place in the picture)
            for (int y = 0; y < blockSize.y; ++y)
                copy(y * blockSize.x, static_cast<std::ptrdiff_t>(corner.y + y) * size.x + corner.x);
        };
        if (settings.receivers.empty()) {
            tracer.eyePoints(rays, corner, blockSize, centre, points);
        } else {
            std::array<std::uint32_t, kBlock * kBlock> receivers;
            forEachRow([&](int block, std::ptrdiff_t picture) {
                std::copy_n(settings.receivers.begin() + picture, blockSize.x, receivers.begin() + block);
            });
            tracer.eyePointsOn({receivers.data(), count}, rays, corner, blockSize, centre, points);
        }
        forEachRow([&](int block, std::ptrdiff_t picture) {
            std::transform(points.begin() + block, points.begin() + block + blockSize.x, points_.begin() + picture,
                           [](const trace::SurfacePoint& point) {
                               return KeptPoint{point.primitive, vec2(point.weights), point.eyeOnFront};
                           });
        });
        for (std::size_t light = 0; light < visibility_.size(); ++light) {
            if (settings.start == trace::ShadowStart::exact)
                tracer.visibilities(points, static_cast<int>(light), answers);
            else // each alone: the naive ray starts where no two of a block agree on a plane
                std::ranges::transform(points, answers.begin(), [&](const trace::SurfacePoint& point) {
                    return tracer.visibility(point, static_cast<int>(light), settings.start);
                });
            forEachRow([&](int block, std::ptrdiff_t picture) {
                std::copy_n(answers.begin() + block, blockSize.x, visibility_[light].begin() + picture);
            });
        }
    });
}

void Picture::shadeLightsOff(const Surfaces& surfaces) {
    radiance_.resize(points_.size());
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        radiance_[fromBelow] = points_[i] ? surfaces.lightsOff(points_[i].surfacePoint()) : surfaces.scene().background;
    });
}

void Picture::shadeLight(const Surfaces& surfaces, int light) {
    const Grid<trace::Visibility>& visibility = visibility_[static_cast<std::size_t>(light)];
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        if (visibility[i] != trace::Visibility::lit) return;
        const trace::SurfacePoint point = points_[i].surfacePoint();
        const dvec3 positionWorld = surfaces.tracer().positionWorld(point);
        const dvec3 toViewerWorld = glm::normalize(eyeWorld_ - positionWorld);
        radiance_[fromBelow] +=
            vec3(surfaces.lit(point, light, positionWorld, surfaces.normalWorld(point, toViewerWorld), toViewerWorld));
    });
}

void Picture::clearTrees() {
    reflected_.clear();
    transmitted_.clear();
    levels_.clear();
    trees_ = secondaryRays_ = 0;
}

void Picture::traceTrees(const Surfaces& surfaces, const scene::Camera& camera, const TreeSettings& settings) {
    reflected_.assign(points_.size(), vec3(0.0f));
    transmitted_.assign(points_.size(), vec3(0.0f));
    levels_.assign(points_.size(), 0);
    const trace::SceneTracer& tracer = surfaces.tracer();
    const trace::EyeRays rays = tracer.eyeRays(camera, size_);
    const DielectricStack aroundEye = surfaces.mediaAround(rays.eyeCentred());
    std::atomic<std::size_t> trees = 0, secondaryRays = 0;
    forEachBlock(size_, [&](ivec2 corner, ivec2 blockSize) {
        RayTree tree; // its memory serves the whole block
        for (int y = corner.y; y < corner.y + blockSize.y; ++y)
            for (int x = corner.x; x < corner.x + blockSize.x; ++x) {
                const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
                const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
                const std::size_t i = row * width + column;
                if (!points_[i]) continue;
                levels_[i] = 1;
                if (!settings.attenuates() && !surfaces.splits(points_[i].surfacePoint())) continue;
                // The point again, in double: the kept one is too coarse for rays to start from.
                const dvec2 pixel(x + 0.5, y + 0.5);
                const trace::SurfacePoint first = tracer.eyePoint(rays, pixel);
                if (!first) continue;
                tree.trace(surfaces, settings, rays.eyeCentred(), glm::normalize(rays.through(pixel).directionCentred),
                           first, aroundEye);
                const std::size_t fromBelow = (height - 1 - row) * width + column;
                radiance_[fromBelow] = vec3(tree.root().intensity);
                reflected_[fromBelow] = vec3(tree.addedByReflection());
                transmitted_[fromBelow] = vec3(tree.addedByRefraction());
                levels_[i] = static_cast<std::uint8_t>(tree.levels());
                ++trees;
                secondaryRays +=
                    static_cast<std::size_t>(std::ranges::count_if(tree.nodes(), &TreeNode::isFollowed)) - 1;
            }
    });
    trees_ = trees;
    secondaryRays_ = secondaryRays;
}

} // namespace shadowlab::ray_tracing
