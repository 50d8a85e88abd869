// Vertices that lie far from nearly all others: left over at the origin of a mesh whose coordinates are those of a country, say.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// Where most points of a mesh are: along each axis the middle third of them lies in the box. Fewer than a third of the points, however
/// far away, do not move it.
class CommonPlace {
public:
    /// `pointAt(i)` gives the points, i from 0 to `count` - 1. A few thousand of them, evenly taken, determine the box.
    template <typename PointAt>
    CommonPlace(std::size_t count, const PointAt& pointAt) {
        constexpr std::size_t kEnough = 4096; // the thirds are then known to a hundredth of all points
        const std::size_t step = std::max<std::size_t>(1, count / kEnough);
        std::vector<dvec3> points;
        for (std::size_t i = 0; i < count; i += step)
            points.push_back(pointAt(i));
        if (points.empty()) return;
        for (int axis = 0; axis < 3; ++axis) {
            const auto nth = [&](std::size_t n) {
                const auto middle = points.begin() + static_cast<std::ptrdiff_t>(n);
                std::ranges::nth_element(points, middle, {}, [&](const dvec3& p) { return p[axis]; });
                return points[n][axis];
            };
            lower_[axis] = nth((points.size() - 1) / 3);
            upper_[axis] = nth(points.size() - 1 - (points.size() - 1) / 3);
        }
        const dvec3 extent = upper_ - lower_;
        size_ = std::max({extent.x, extent.y, extent.z});
    }

    /// Largest distance along an axis; 0 in the box.
    [[nodiscard]] double distanceTo(const dvec3& point) const {
        const dvec3 beyond = glm::max(glm::max(lower_ - point, point - upper_), dvec3(0.0));
        return std::max({beyond.x, beyond.y, beyond.z});
    }

    /// More than a thousand times the box's size away. A statue in its hall, a village in its valley, a ground that reaches to the horizon
    /// are nearer. In a picture of all, what is in the box would be smaller than a pixel.
    [[nodiscard]] bool isFar(const dvec3& point) const { return size_ > 0 && distanceTo(point) > kFarInSizes * size_; }

private:
    static constexpr double kFarInSizes = 1000.0;
    dvec3 lower_{0.0}, upper_{0.0};
    double size_ = 0;
};

} // namespace shadowlab::scene
