// The visibility of a light at scattered pixels; neighbouring ones are traced together.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

/// Puts pixels that share a block (SceneTracer::kBlock) next to each other.
void sortByBlock(std::vector<ivec2>& pixels);

/// Asks for one picture after another, and remembers where eye rays have ended. While only lights change, outlines of shadows move a
/// few pixels from frame to frame: most pixels then lie in blocks that were asked for before.
class PixelRays {
public:
    /// One answer for each pixel (counted from the upper left), through its centre. `pixels` are sorted by block.
    std::vector<Visibility> visibilities(std::span<const ivec2> pixels, const SceneTracer& tracer, const scene::Camera& camera,
                                         ivec2 pictureSize, int light);
    /// How many blocks it remembers.
    [[nodiscard]] std::size_t remembered() const;

private:
    using Block = std::array<SurfacePoint, SceneTracer::kBlock * SceneTracer::kBlock>;
    void lookAt(const SeenFrom& picture);
    void findPoints(std::span<const ivec2> pixels, const SceneTracer& tracer, const EyeRays& rays, std::span<SurfacePoint> points);

    SeenFrom picture_;
    std::vector<std::unique_ptr<Block>> blocks_; ///< of the picture, row by row; none: not remembered
    std::vector<SurfacePoint> points_;           ///< of the pixels last asked for; its memory is used again
};

} // namespace shadowlab::trace
