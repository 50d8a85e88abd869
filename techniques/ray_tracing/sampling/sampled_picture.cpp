// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/sampled_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "techniques/foundation/trace/blocks.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/ray_tracing/sampling/lobe.h"

namespace shadowlab::ray_tracing {

namespace {

// Side of a block, a thread's piece of work: some milliseconds for the slowest trees, so that deadlines are kept.
constexpr int kSampledBlock = 16;

// Adaptive sampling tests for convergence after every so many samples. With fewer, an edge that covers a tenth of a pixel is
// often missed by all of them, and the pixel looks converged.
constexpr int kSamplesBetweenChecks = 16;

/// The 8-bit grey level, as a real number, of a linear value: IEC 61966-2-1 (sRGB).
double grey(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

} // namespace

// [anchor: eye-sample]
EyeSample eyeSample(const trace::EyeRays& rays, const SampledSettings& settings, ivec2 pixel,
                    const SampleNumbers& numbers) {
    EyeSample sample;
    sample.place = dvec2(pixel) + (settings.antialias ? numbers.pair(Purpose::pixel) : dvec2(0.5));
    sample.ray = settings.aperture > 0
                     ? rays.throughLens(sample.place, 0.5 * settings.aperture * onDisc(numbers.pair(Purpose::lens)),
                                        settings.focus)
                     : rays.through(sample.place);
    if (settings.shutter > 0) sample.time = settings.shutter * numbers.one(Purpose::time);
    return sample;
}

void SampledPicture::restart(ivec2 size) {
    size_ = size;
    pixels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), {});
    nextBlock_ = 0;
    round_ = 0;
    anyActive_ = true;
    done_ = secondaryRays_ = 0;
}

bool SampledPicture::advance(const Surfaces& surfaces, const trace::MovingScene& scene, const AnalyticLights* analytic,
                             const scene::Camera& camera, const SampledSettings& settings, Deadline deadline) {
    const trace::EyeRays rays = surfaces.tracer().eyeRays(camera, size_);
    // Simplified: the lens is so small that all of it is inside the same solids as its centre.
    const DielectricStack aroundEye = surfaces.mediaAround(rays.eyeCentred());
    const dvec3 background(surfaces.scene().background);
    const trace::Blocks blocks{size_, kSampledBlock};
    std::atomic<std::uint64_t> secondaryRays = 0;
    const auto traceBlock = [&](std::size_t block) {
        const ivec2 corner = blocks.corner(block), end = corner + blocks.sizeAt(corner);
        RayTree tree; // its memory is reused for the whole block
        std::uint64_t below = 0;
        for (int y = corner.y; y < end.y; ++y)
            for (int x = corner.x; x < end.x; ++x) {
                Pixel& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                                       static_cast<std::size_t>(x)];
                if (!pixel.isActive) continue;
                const SampleNumbers numbers(settings.pattern, {x, y}, pixel.count);
                const EyeSample eye = eyeSample(rays, settings, {x, y}, numbers);
                const trace::SurfacePoint first = scene.met(eye.ray, trace::kNoPrimitive, eye.time);
                if (!first) {
                    add(pixel, background);
                    continue;
                }
                tree.trace({surfaces, scene, eye.time, &numbers, analytic}, settings.tree, eye.ray.originCentred,
                           glm::normalize(eye.ray.directionCentred), first, aroundEye);
                add(pixel, tree.root().intensity);
                below += static_cast<std::uint64_t>(std::ranges::count_if(tree.nodes(), &TreeNode::isFollowed)) - 1;
            }
        secondaryRays += below;
    };
    while (round_ < settings.pattern.count && anyActive_) {
        nextBlock_ = trace::parallelUntil(deadline, nextBlock_, blocks.count(), traceBlock);
        if (nextBlock_ < blocks.count()) break;
        nextBlock_ = 0;
        ++round_;
        if (settings.adaptive && round_ % kSamplesBetweenChecks == 0) chooseActive(settings, surfaces.scene().exposure);
        if (std::chrono::steady_clock::now() >= deadline) break;
    }
    secondaryRays_ += static_cast<double>(secondaryRays);
    const bool finished = round_ >= settings.pattern.count || !anyActive_;
    const double partOfRound = static_cast<double>(nextBlock_) / static_cast<double>(blocks.count());
    done_ = finished ? 1.0 : (round_ + partOfRound) / settings.pattern.count;
    return finished;
}

void SampledPicture::add(Pixel& pixel, const dvec3& radiance) const {
    pixel.sum += radiance;
    ++pixel.count;
    const double value = luminance(radiance), before = value - pixel.mean;
    pixel.mean += before / pixel.count;
    pixel.squares += before * (value - pixel.mean);
}

/// The standard error of a pixel's mean as displayed, in steps of 8-bit grey: differences that are clipped to white or black do
/// not count. Evenly distributed samples have a smaller error than this.
double SampledPicture::standardErrorGrey(const Pixel& pixel, double exposure) const {
    const double n = pixel.count;
    const double error = std::sqrt(pixel.squares / (n * (n - 1)));
    return 0.5 * (grey(exposure * (pixel.mean + error)) - grey(exposure * (pixel.mean - error)));
}

/// A pixel stays active while it or one of its eight neighbours has not converged: an edge that its own samples have missed so
/// far is visible in its neighbours.
void SampledPicture::chooseActive(const SampledSettings& settings, double exposure) {
    std::vector<std::uint8_t> isUnsure(pixels_.size());
    std::ranges::transform(pixels_, isUnsure.begin(), [&](const Pixel& pixel) {
        return static_cast<std::uint8_t>(standardErrorGrey(pixel, exposure) > settings.tolerance ? 1 : 0);
    });
    anyActive_ = false;
    const auto unsureAt = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= size_.x || y >= size_.y) return false;
        return isUnsure[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                        static_cast<std::size_t>(x)] != 0;
    };
    for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) {
            bool active = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    active = active || unsureAt(x + dx, y + dy);
            Pixel& pixel =
                pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x)];
            pixel.isActive = active;
            anyActive_ = anyActive_ || active;
        }
}

std::vector<vec3> SampledPicture::radianceFromBelow() const {
    std::vector<vec3> radiance(pixels_.size(), vec3(0.0f));
    const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const Pixel& pixel = pixels_[y * width + x];
            if (pixel.count > 0)
                radiance[(height - 1 - y) * width + x] = vec3(pixel.sum / static_cast<double>(pixel.count));
        }
    return radiance;
}

std::vector<std::uint32_t> SampledPicture::samples() const {
    std::vector<std::uint32_t> counts(pixels_.size());
    std::ranges::transform(pixels_, counts.begin(), &Pixel::count);
    return counts;
}

double SampledPicture::samplesInAll() const {
    double all = 0;
    for (const Pixel& pixel : pixels_)
        all += pixel.count;
    return all;
}

} // namespace shadowlab::ray_tracing
