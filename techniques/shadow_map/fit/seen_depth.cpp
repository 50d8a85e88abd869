// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/seen_depth.h"

#include <algorithm>

namespace shadowlab::shadow_map {

std::optional<dvec2> visibleDepthRange(const Frame& frame) {
    const ivec2 size = frame.target().size();
    std::vector<float> depths(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    float least = 1, most = 0;
    for (const float depth : depths) {
        if (depth >= 1) continue; // the background
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    if (least > most) return std::nullopt;
    // z_clip = a z + b and w = -z, so ndc = -a - b / z. Depths are rounded to 24 bits: one step to either side.
    const double a = frame.eye().clipFromView[2][2], b = frame.eye().clipFromView[3][2];
    constexpr double kStep = 1.0 / (1 << 24);
    const auto distance = [&](double depth) { return b / ((2 * depth - 1) + a); };
    return dvec2(distance(least - kStep), distance(std::min(most + kStep, 1 - 0.5 * kStep)));
}

} // namespace shadowlab::shadow_map
