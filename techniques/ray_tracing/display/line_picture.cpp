// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/display/line_picture.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/model/camera.h"

namespace shadowlab::ray_tracing {

namespace {

constexpr float kHiddenShare = 0.25f; // faint, but visible behind a surface
// A line on a surface must be drawn over it, so its depth counts as a little smaller.
constexpr double kNearer = 1 - 3e-3;

/// Clips the segment from a to b to where the linear function with these end values is at least 0. False: nothing is left.
bool cut(double a, double b, double& from, double& to) {
    if (a < 0 && b < 0) return false;
    if (a < 0) from = std::max(from, a / (a - b));
    if (b < 0) to = std::min(to, a / (a - b));
    return from < to;
}

} // namespace

LinePicture::LinePicture(std::vector<vec3> colors, std::vector<double> depths, const scene::Camera& camera, ivec2 size)
    : colors_(std::move(colors)), depths_(std::move(depths)), drawnBy_(colors_.size(), 0),
      viewFromWorld_(scene::viewFromWorld(camera)), near_(camera.near),
      perHeight_(0.5 * size.y / std::tan(glm::radians(camera.fovYDegrees) / 2)), size_(size) {}

void LinePicture::draw(const dvec3& fromWorld, const dvec3& toWorld, const vec3& color, int radius) {
    dvec3 a = transformPoint(viewFromWorld_, fromWorld), b = transformPoint(viewFromWorld_, toWorld);
    // Clipped to the near plane and the four sides of the view, enlarged by the line's width.
    const double wide = (0.5 * size_.x + radius + 1) / perHeight_, high = (0.5 * size_.y + radius + 1) / perHeight_;
    double from = 0, to = 1;
    if (!cut(-a.z - near_, -b.z - near_, from, to) || !cut(-a.z * wide - a.x, -b.z * wide - b.x, from, to) ||
        !cut(-a.z * wide + a.x, -b.z * wide + b.x, from, to) || !cut(-a.z * high - a.y, -b.z * high - b.y, from, to) ||
        !cut(-a.z * high + a.y, -b.z * high + b.y, from, to))
        return;
    const dvec3 way = b - a;
    b = a + to * way;
    a += from * way;
    const auto pixelOf = [&](const dvec3& p) {
        return dvec2(0.5 * size_.x + perHeight_ * p.x / -p.z, 0.5 * size_.y - perHeight_ * p.y / -p.z);
    };
    const dvec2 start = pixelOf(a), along = pixelOf(b) - start;
    const int steps = 1 + static_cast<int>(std::max(std::abs(along.x), std::abs(along.y)));
    ++line_;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        // Along a line in the picture the reciprocal of the depth is linear.
        const double depth = 1 / ((1 - share) / -a.z + share / -b.z);
        stamp(start + share * along, depth, color, radius);
    }
}

void LinePicture::stamp(dvec2 pixel, double depth, const vec3& color, int radius) {
    const ivec2 middle(glm::floor(pixel));
    for (int y = std::max(0, middle.y - radius); y <= std::min(size_.y - 1, middle.y + radius); ++y)
        for (int x = std::max(0, middle.x - radius); x <= std::min(size_.x - 1, middle.x + radius); ++x) {
            const ivec2 off = ivec2(x, y) - middle;
            const auto i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
            if (off.x * off.x + off.y * off.y > radius * radius || drawnBy_[i] == line_) continue;
            drawnBy_[i] = line_;
            const bool hidden = depth * kNearer > depths_[i];
            colors_[i] = glm::mix(colors_[i], color, hidden ? kHiddenShare : 1.0f);
        }
}

} // namespace shadowlab::ray_tracing
