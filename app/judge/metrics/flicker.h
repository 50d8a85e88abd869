// Shadows that change from one frame to the next although the truth does not: at pixels, and at points of surfaces.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::judge {

class ExcessFlips {
public:
    /// The next frame: one byte a pixel, 1 where it is lit, and the length of the true boundary in pixels.
    void addFrame(std::vector<std::uint8_t> lit, std::vector<std::uint8_t> truthLit, double boundaryPx);

    /// Flips without reason over all frames, per pixel of true boundary (of the frames after the first). Nothing for a
    /// single frame, or when there is no boundary. 0 for an exact technique, however fast things move.
    [[nodiscard]] std::optional<double> rate() const;

private:
    std::vector<std::uint8_t> lit_, truthLit_;
    std::uint64_t flips_ = 0;
    double boundaryPx_ = 0;
};

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
