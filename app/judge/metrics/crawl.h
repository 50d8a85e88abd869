// Shadows that crawl over a surface while the eye moves.
//
// Counted at pixels, maps that stand still and maps that do not hardly differ: when the eye moves, the stairs of every edge move
// over the pixels. So what is followed are points of surfaces: those that lie at the middle of a pixel in one frame, and at the
// middle of another pixel in the next. The picture's own raster then has no part in it.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::judge {

class Crawl {
public:
    /// The next frame of a scene in which only the eye moves: one byte a pixel, 1 where it is lit, by a technique and in
    /// truth. The tracer is ready for the scene.
    void addFrame(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size,
                  std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit);

    /// % of the points that were followed whose light changed although the truth did not; none: no point was.
    [[nodiscard]] std::optional<double> percent() const;
    [[nodiscard]] int followed() const { return followed_; }

private:
    std::optional<scene::Camera> camera_; ///< of the frame before
    std::vector<std::uint8_t> lit_, truthLit_;
    int followed_ = 0, changed_ = 0;
};

/// Where in a picture of that size a point is seen, in pixels from the upper left corner; nothing behind the eye.
std::optional<dvec2> pixelOf(const scene::Camera& camera, ivec2 size, const dvec3& pointWorld);

} // namespace shadowlab::judge
