// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/pixel_gather.h"

#include <algorithm>

#include "techniques/foundation/math/random_pair.h"
#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

namespace {

constexpr int kBlockSide = 8; // pixels beside each other meet the same surfaces

/// A place of its own in the unit square for each pixel, by which the sequence of rays is shifted (R. Cranley and T. Patterson,
/// "Randomization of Number Theoretic Methods for Multiple Integration", SIAM Journal on Numerical Analysis 13, 1976): else all pixels
/// would make the same error, and one would see it as edges.
dvec2 shiftOf(ivec2 pixel) { return randomPair(pixelKey(pixel)); }

} // namespace

bool PixelGather::advance(const GatherSolution& solution, const PixelLight& light, std::size_t rays, Deadline deadline) {
    if (GatherKey key{solution.version, light.seenFrom(), light.tracer().scene().lights, rays}; sums_.empty() || key != key_) {
        key_ = std::move(key);
        sums_.assign(static_cast<std::size_t>(light.size().x) * static_cast<std::size_t>(light.size().y), dvec3(0));
        done_ = nextBlock_ = 0;
    }
    const std::size_t blocks = trace::Blocks{light.size(), kBlockSide}.count();
    while (done_ < rays) {
        ++version_;
        nextBlock_ = trace::parallelUntil(deadline, nextBlock_, blocks, [&](std::size_t block) { gatherBlock(solution, light, block); });
        if (nextBlock_ < blocks) return false;
        nextBlock_ = 0;
        ++done_;
    }
    return true;
}

void PixelGather::gatherBlock(const GatherSolution& solution, const PixelLight& light, std::size_t block) {
    const trace::Blocks all{light.size(), kBlockSide};
    const ivec2 corner = all.corner(block), end = corner + all.sizeAt(corner);
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x)
            if (light.pointAt({x, y}))
                sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(light.size().x) + static_cast<std::size_t>(x)] +=
                    gather(solution, light, {x, y}, {shiftOf({x, y}), done_, 1}).irradiance;
}

std::vector<vec4> PixelGather::irradianceFromBelow() const {
    const ivec2 size = key_.seenFrom.size;
    std::vector<vec4> irradiance(sums_.size());
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    const trace::Blocks all{size, kBlockSide};
    for (std::size_t block = 0; block < all.count(); ++block) {
        const ivec2 corner = all.corner(block), end = corner + all.sizeAt(corner);
        // Of a round that is not complete, the first blocks have one ray more than the others.
        const double rays = static_cast<double>(done_ + (block < nextBlock_ ? 1 : 0));
        for (int y = corner.y; y < end.y; ++y)
            for (int x = corner.x; x < end.x; ++x) {
                const auto row = static_cast<std::size_t>(y), column = static_cast<std::size_t>(x);
                irradiance[(height - 1 - row) * width + column] = vec4(vec3(sums_[row * width + column] / std::max(1.0, rays)), 1.0f);
            }
    }
    return irradiance;
}

} // namespace shadowlab::radiosity
