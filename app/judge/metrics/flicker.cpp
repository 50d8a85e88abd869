// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flicker.h"

#include <cmath>
#include <utility>

namespace shadowlab::judge {

namespace {

/// How far from a pixel's middle a point may lie, in pixels: near enough for the answers there to be its own, and far enough
/// for some points in a hundred (0.1 of a pixel to all sides is 3 % of its area).
constexpr double kNearMiddle = 0.1;

} // namespace

void ExcessFlips::addFrame(std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit, double boundaryPx) {
    if (!lit_.empty()) {
        for (std::size_t i = 0; i < lit.size(); ++i)
            flips_ += lit[i] != lit_[i] && truthLit[i] == truthLit_[i];
        boundaryPx_ += boundaryPx;
    }
    lit_ = std::move(lit);
    truthLit_ = std::move(truthLit);
}

std::optional<double> ExcessFlips::rate() const {
    if (boundaryPx_ <= 0) return std::nullopt;
    return static_cast<double>(flips_) / boundaryPx_;
}

std::optional<dvec2> pixelOf(const scene::Camera& camera, ivec2 size, const dvec3& pointWorld) {
    const dvec3 forwardWorld = glm::normalize(camera.targetWorld - camera.positionWorld);
    const dvec3 rightWorld = glm::normalize(glm::cross(forwardWorld, camera.upWorld));
    const dvec3 upWorld = glm::cross(rightWorld, forwardWorld);
    const dvec3 toPointWorld = pointWorld - camera.positionWorld;
    const double depth = glm::dot(toPointWorld, forwardWorld);
    if (!(depth > 0)) return std::nullopt;
    const double pixelsPerSlope = 0.5 * size.y / std::tan(glm::radians(camera.fovYDegrees) / 2);
    const dvec2 slope = dvec2(glm::dot(toPointWorld, rightWorld), -glm::dot(toPointWorld, upWorld)) / depth;
    return 0.5 * dvec2(size) + pixelsPerSlope * slope;
}

void Crawl::addFrame(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                     std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit) {
    const trace::EyeRays rays = tracer.eyeRays(camera, size);
    const auto index = [&](ivec2 pixel) {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x);
    };
    for (int y = 0; camera_ && y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const trace::SurfacePoint point = tracer.eyePoint(rays, dvec2(x + 0.5, y + 0.5));
            if (!point) continue;
            const std::optional<dvec2> before = pixelOf(*camera_, size, tracer.positionWorld(point));
            if (!before) continue;
            const ivec2 pixel(glm::floor(*before));
            if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) continue;
            if (glm::length(*before - (dvec2(pixel) + 0.5)) > kNearMiddle) continue;
            const std::size_t now = index({x, y}), then = index(pixel);
            if (truthLit[now] != truthLit_[then]) continue; // an edge, or what was hidden behind something
            ++followed_;
            changed_ += lit[now] != lit_[then] ? 1 : 0;
        }
    camera_ = camera;
    lit_ = std::move(lit);
    truthLit_ = std::move(truthLit);
}

std::optional<double> Crawl::percent() const {
    if (followed_ == 0) return std::nullopt;
    return 100.0 * changed_ / followed_;
}

} // namespace shadowlab::judge
