// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/picture.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::ray_tracing {

namespace {

constexpr int kBlockSide = trace::SceneTracer::kBlock;

/// Calls work(index, index with rows counted from the bottom) for every pixel, a row of blocks at a time.
template <typename Work>
void forEachPixel(ivec2 size, const Work& work) {
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    trace::parallelFor((height + kBlockSide - 1) / kBlockSide, [&](std::size_t row) {
        for (std::size_t y = row * kBlockSide; y < std::min(height, (row + 1) * kBlockSide); ++y)
            for (std::size_t x = 0; x < width; ++x)
                work(y * width + x, (height - 1 - y) * width + x);
    });
}

} // namespace

std::size_t Picture::blocks() const { return trace::Blocks{size_, kBlockSide}.count(); }

void Picture::restart(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size) {
    size_ = size;
    camera_ = camera;
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    points_.resize(pixels);
    seenBlocks_ = 0;
    restartLights(tracer);
}

void Picture::restartLights(const trace::SceneTracer& tracer) {
    visibility_.resize(tracer.scene().lights.size());
    for (Grid<trace::Visibility>& ofLight : visibility_)
        ofLight.resize(points_.size());
    reflected_.clear();
    transmitted_.clear();
    levels_.clear();
    intensities_.clear();
    tracedBlocks_ = treeBlocks_ = 0;
    trees_ = secondaryRays_ = 0;
}

/// Clears what is not traced yet, so that nothing of the previous picture is seen there. When all is traced at once there is
/// nothing to clear.
void Picture::clearFrom(std::size_t firstBlock) {
    const trace::Blocks blocks{size_, kBlockSide};
    for (std::size_t block = firstBlock; block < blocks.count(); ++block) {
        const ivec2 corner = blocks.corner(block), blockSize = blocks.sizeAt(corner);
        for (int y = corner.y; y < corner.y + blockSize.y; ++y) {
            const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * size_.x + corner.x;
            if (block >= seenBlocks_) std::fill_n(points_.begin() + first, blockSize.x, trace::SurfacePoint());
            for (Grid<trace::Visibility>& ofLight : visibility_)
                std::fill_n(ofLight.begin() + first, blockSize.x, trace::Visibility::noSurface);
        }
    }
}

double Picture::done(bool withTrees) const {
    const double all = static_cast<double>(blocks());
    const double traced = static_cast<double>(tracedBlocks_) / all;
    return withTrees ? 0.5 * (traced + static_cast<double>(treeBlocks_) / all) : traced;
}

/// The ends of the eye rays through the pixels of a block.
void Picture::traceEyeRays(const trace::SceneTracer& tracer, const trace::EyeRays& rays, const TraceSettings& settings, ivec2 corner,
                           ivec2 blockSize, std::span<trace::SurfacePoint> points) const {
    const dvec2 centre(0.5);
    if (settings.receivers.empty()) return tracer.eyePoints(rays, corner, blockSize, centre, points);
    std::array<std::uint32_t, kBlockSide * kBlockSide> receivers;
    for (int y = 0; y < blockSize.y; ++y)
        std::copy_n(settings.receivers.begin() + static_cast<std::ptrdiff_t>(corner.y + y) * size_.x + corner.x, blockSize.x,
                    receivers.begin() + y * blockSize.x);
    tracer.eyePointsOn({receivers.data(), points.size()}, rays, corner, blockSize, centre, points);
}

bool Picture::trace(const trace::SceneTracer& tracer, const TraceSettings& settings, Deadline deadline) {
    const trace::Blocks blocks{size_, kBlockSide};
    const trace::EyeRays rays = tracer.eyeRays(camera_, size_);
    const bool begins = tracedBlocks_ == 0;
    const std::size_t seen = seenBlocks_;
    tracedBlocks_ = trace::parallelUntil(deadline, tracedBlocks_, blocks.count(), [&](std::size_t block) {
        const ivec2 corner = blocks.corner(block), blockSize = blocks.sizeAt(corner);
        std::array<trace::SurfacePoint, kBlockSide * kBlockSide> blockPoints;
        std::array<trace::Visibility, kBlockSide * kBlockSide> blockAnswers;
        const auto count = static_cast<std::size_t>(blockSize.x * blockSize.y);
        const std::span points(blockPoints.data(), count);
        const std::span answers(blockAnswers.data(), count);
        const auto forEachRow = [&](const auto& copy) { // copy(place in the block, place in the picture)
            for (int y = 0; y < blockSize.y; ++y)
                copy(y * blockSize.x, static_cast<std::ptrdiff_t>(corner.y + y) * size_.x + corner.x);
        };
        if (block < seen) {
            forEachRow([&](int place, std::ptrdiff_t picture) {
                std::copy_n(points_.begin() + picture, blockSize.x, points.begin() + place);
            });
        } else {
            traceEyeRays(tracer, rays, settings, corner, blockSize, points);
            forEachRow([&](int place, std::ptrdiff_t picture) {
                std::copy_n(points.begin() + place, blockSize.x, points_.begin() + picture);
            });
        }
        for (std::size_t light = 0; light < visibility_.size(); ++light) {
            if (settings.start == trace::ShadowStart::exact)
                tracer.visibilities(points, static_cast<int>(light), answers);
            else // each alone: naive rays start at rounded points, on no common plane
                std::ranges::transform(points, answers.begin(), [&](const trace::SurfacePoint& point) {
                    return tracer.visibility(point, static_cast<int>(light), settings.start);
                });
            forEachRow([&](int place, std::ptrdiff_t picture) {
                std::copy_n(answers.begin() + place, blockSize.x, visibility_[light].begin() + picture);
            });
        }
    });
    seenBlocks_ = std::max(seenBlocks_, tracedBlocks_);
    if (begins) clearFrom(tracedBlocks_);
    return isTraced();
}

void Picture::shadeLightsOff(const Surfaces& surfaces) {
    radiance_.resize(points_.size());
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        radiance_[fromBelow] = points_[i] ? surfaces.lightsOff(points_[i]) : surfaces.scene().background;
    });
}

// [anchor: shade-lit]
void Picture::shadeLight(const Surfaces& surfaces, int light) {
    const Grid<trace::Visibility>& visibility = visibility_[static_cast<std::size_t>(light)];
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        if (visibility[i] != trace::Visibility::lit) return;
        const trace::SurfacePoint point = points_[i];
        const dvec3 positionWorld = surfaces.tracer().positionWorld(point);
        const dvec3 toViewerWorld = glm::normalize(camera_.positionWorld - positionWorld);
        radiance_[fromBelow] +=
            vec3(surfaces.lit(point, light, positionWorld, surfaces.normalWorld(point, toViewerWorld), toViewerWorld));
    });
}

void Picture::shadeAreaLight(const Surfaces& surfaces, int light, const Grid<float>& irradiances) {
    if (irradiances.empty()) return;
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        if (irradiances[i] == 0) return;
        const trace::SurfacePoint point = points_[i];
        const dvec3 positionWorld = surfaces.tracer().positionWorld(point);
        const dvec3 toViewerWorld = glm::normalize(camera_.positionWorld - positionWorld);
        radiance_[fromBelow] += vec3(surfaces.litByArea(point, light, irradiances[i], positionWorld,
                                                        surfaces.normalWorld(point, toViewerWorld), toViewerWorld));
    });
}

bool Picture::traceTrees(const RayWorld& world, const TreeSettings& settings, Deadline deadline) {
    const Surfaces& surfaces = world.surfaces;
    const trace::Blocks blocks{size_, kBlockSide};
    if (treeBlocks_ == 0) {
        intensities_ = reflected_ = transmitted_ = Grid<vec3>(points_.size(), vec3(0.0f));
        levels_.assign(points_.size(), 0);
    }
    const trace::SceneTracer& tracer = surfaces.tracer();
    const trace::EyeRays rays = tracer.eyeRays(camera_, size_);
    const DielectricStack aroundEye = surfaces.mediaAround(rays.eyeCentred());
    const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
    const auto hasTree = [&](std::size_t i) {
        return points_[i] && (settings.attenuates() || surfaces.splits(points_[i]));
    };
    std::atomic<std::size_t> trees = 0, secondaryRays = 0;
    treeBlocks_ = trace::parallelUntil(deadline, treeBlocks_, blocks.count(), [&](std::size_t block) {
        const ivec2 corner = blocks.corner(block), end = corner + blocks.sizeAt(corner);
        RayTree tree; // its memory serves the whole block
        std::size_t treesHere = 0, raysHere = 0;
        for (int y = corner.y; y < end.y; ++y)
            for (int x = corner.x; x < end.x; ++x) {
                const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
                const std::size_t i = row * width + column;
                levels_[i] = points_[i] ? 1 : 0;
                if (!hasTree(i)) continue;
                tree.trace(world, settings, rays.eyeCentred(), glm::normalize(rays.through(dvec2(x, y) + 0.5).directionCentred),
                           points_[i], aroundEye);
                const std::size_t fromBelow = (height - 1 - row) * width + column;
                intensities_[fromBelow] = vec3(tree.root().intensity);
                reflected_[fromBelow] = vec3(tree.addedByReflection());
                transmitted_[fromBelow] = vec3(tree.addedByRefraction());
                levels_[i] = static_cast<std::uint8_t>(tree.levels());
                ++treesHere;
                raysHere += static_cast<std::size_t>(std::ranges::count_if(tree.nodes(), &TreeNode::isFollowed)) - 1;
            }
        trees += treesHere;
        secondaryRays += raysHere;
    });
    trees_ += trees;
    secondaryRays_ += secondaryRays;
    // What has been traced so far: whole rows of blocks, and some blocks of the next row.
    forEachPixel(size_, [&](std::size_t i, std::size_t fromBelow) {
        const std::size_t block =
            (i / width) / kBlockSide * static_cast<std::size_t>(blocks.grid().x) + (i % width) / kBlockSide;
        if (block < treeBlocks_ && hasTree(i)) radiance_[fromBelow] = intensities_[fromBelow];
    });
    return treeBlocks_ == blocks.count();
}

} // namespace shadowlab::ray_tracing
