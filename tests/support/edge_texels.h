// The texels of a map through whose centres an edge passes so nearly that the rasteriser's grid decides which side they are on.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <vector>

#include "techniques/probe.h"
#include "techniques/probed/map_probe.h"
#include "tests/support/brute_force.h"

namespace shadowlab::testing {

class EdgeTexels {
public:
    /// GL_SUBPIXEL_BITS = 8: a corner is moved to the next 256th, by up to 1/512 along both axes, so an edge by up to 0.0028 texels.
    static constexpr double kNear = 1.0 / 256;

    EdgeTexels(const std::vector<WorldTriangle>& triangles, const MapProbe& map)
        : resolution_(map.resolution),
          isNear_(static_cast<std::size_t>(resolution_) * static_cast<std::size_t>(resolution_), false) {
        for (const WorldTriangle& triangle : triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto clip = [&](std::size_t corner) {
                    return map.lightClipFromLightRelative * dvec4(triangle.cornersWorld[corner] - map.originWorld, 1.0);
                };
                addEdge(clip(i), clip((i + 1) % 3));
            }
    }
    /// Beyond the map's border nothing is drawn.
    [[nodiscard]] bool operator()(const ivec2& texel) const {
        const bool outside = texel.x < 0 || texel.y < 0 || texel.x >= resolution_ || texel.y >= resolution_;
        return !outside && isNear_[index(texel)];
    }

private:
    [[nodiscard]] std::size_t index(const ivec2& texel) const {
        return static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(resolution_) +
               static_cast<std::size_t>(texel.x);
    }
    void addEdge(dvec4 a, dvec4 b) {
        constexpr double kLeastW = 1e-6;
        if (a.w < kLeastW && b.w < kLeastW) return;
        if (a.w < kLeastW) a = glm::mix(b, a, (b.w - kLeastW) / (b.w - a.w));
        if (b.w < kLeastW) b = glm::mix(a, b, (a.w - kLeastW) / (a.w - b.w));
        dvec2 from = (dvec2(a) / a.w * 0.5 + 0.5) * static_cast<double>(resolution_),
              to = (dvec2(b) / b.w * 0.5 + 0.5) * static_cast<double>(resolution_);
        const int major = std::abs(to.x - from.x) >= std::abs(to.y - from.y) ? 0 : 1, minor = 1 - major;
        if (from[major] > to[major]) std::swap(from, to);
        const double slope = to[major] > from[major] ? (to[minor] - from[minor]) / (to[major] - from[major]) : 0;
        const int first = std::max(0, static_cast<int>(std::floor(from[major] - 0.5 - kNear))),
                  last = std::min(resolution_ - 1, static_cast<int>(std::ceil(to[major] - 0.5 + kNear)));
        for (int step = first; step <= last; ++step) {
            const double at = glm::clamp(step + 0.5, from[major], to[major]);
            const double crossing = from[minor] + slope * (at - from[major]);
            const int row = static_cast<int>(std::floor(crossing));
            const double away =
                glm::length(dvec2(at - step - 0.5, (crossing - row - 0.5) / std::sqrt(1 + slope * slope)));
            ivec2 texel;
            texel[major] = step;
            texel[minor] = row;
            if (row >= 0 && row < resolution_ && away < kNear * std::sqrt(2.0)) isNear_[index(texel)] = true;
        }
    }
    int resolution_;
    std::vector<bool> isNear_;
};

} // namespace shadowlab::testing
