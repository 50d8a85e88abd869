// SPDX-License-Identifier: MIT
#include "tests/shadow_map/edge_reach.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "tests/shadow_map/fit/scene_maps.h"

namespace shadowlab::testing {

TieRadius edgeReach(const scene::Snapshot& snapshot, int light, int resolution, ivec2 size, double texels) {
    const scene::Light& source = snapshot->light(light);
    const shadow_map::LightMaps maps = sceneMaps(*snapshot, source, resolution, 1);
    return [=](const std::optional<trace::EyeHit>& hit) {
        if (!hit) return 1.5;
        const dvec3 offset = source.positionWorld - hit->positionWorld;
        const double distance = maps.parallel ? 1.0 : glm::length(offset);
        const double texel = 2.0 / (maps.lightClipFromLightView[0][0][0] * resolution) * distance;
        const dvec3 toLight = maps.parallel ? -source.directionWorld : glm::normalize(offset);
        // A surface that the light only grazes is not cut off before 50 texels' worth of one.
        const double onSurface = texel / std::max(0.02, std::abs(glm::dot(toLight, hit->geometricNormalWorld)));
        const double tanHalf = std::tan(snapshot->camera.fovYDegrees * glm::pi<double>() / 360.0);
        return std::max(1.5, texels * onSurface * size.y / (2.0 * tanHalf * hit->distance));
    };
}

} // namespace shadowlab::testing
