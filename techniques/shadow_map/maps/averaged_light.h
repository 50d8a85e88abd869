// Soft shadows by brute force: many maps, each from another point of the light, and the mean of their answers.
// Heckbert and Herf, "Simulating Soft Shadows with Graphics Hardware", CMU-CS-97-104, 1997, with maps instead of projections.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/map_tools.h"

namespace shadowlab::shadow_map {

class AveragedLight {
public:
    explicit AveragedLight(MapTools& tools) : tools_(tools) {}

    /// Is this light's visibility averaged over its points? Only of a light with an area.
    [[nodiscard]] bool averagesOver(const scene::Light& light) const;
    /// Visibility of every pixel, 0 to 1; valid until the next call.
    const gl::Texture2D& average(Frame& frame, int light);

private:
    MapTools& tools_;
    gl::Texture2D averaged_;
};

} // namespace shadowlab::shadow_map
