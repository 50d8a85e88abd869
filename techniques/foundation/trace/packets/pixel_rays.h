// The visibility of a light at scattered pixels; neighbouring ones are traced together.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::trace {

/// Puts pixels that share a block (SceneTracer::kBlock) next to each other.
void sortByBlock(std::vector<ivec2>& pixels);

/// One answer for each pixel (counted from the upper left), through its centre. `pixels` are sorted by block.
std::vector<Visibility> visibilitiesOf(std::span<const ivec2> pixels, const SceneTracer& tracer, const EyeRays& rays,
                                       ivec2 pictureSize, int light);

} // namespace shadowlab::trace
