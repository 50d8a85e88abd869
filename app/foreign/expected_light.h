// What each pixel should show if nothing cast a shadow: the light that is judged, and all else, in the shading of this program.
//
// A foreign renderer need not shade alike. All that is taken from here is which share of a pixel's light comes from the light that is
// judged, and that share is scaled to what the pictures say (found_visibility.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/judge/truth.h"

namespace shadowlab::foreign {

/// Linear radiances, one for each pixel, rows from the top; zero where no surface is seen.
struct ExpectedLight {
    std::vector<vec3> ofLight;   ///< that the judged light adds where it is seen
    std::vector<vec3> ofLightFlat; ///< the same with the triangle's own normal, as a program without smooth normals shades it
    std::vector<vec3> ofOthers;  ///< the part of `remaining` that other lights add
    std::vector<std::uint8_t> isDull; ///< 1: the surface has no highlight
    std::vector<vec3> remaining; ///< emission, ambient light, and all other lights without shadows
};

/// The unit normal of the point's triangle, on the side that the eye sees.
dvec3 flatNormalWorld(const trace::SceneTracer& tracer, const trace::SurfacePoint& point);

ExpectedLight expectedLight(const trace::SceneTracer& tracer, const scene::Camera& camera, ivec2 size, int light);

} // namespace shadowlab::foreign
