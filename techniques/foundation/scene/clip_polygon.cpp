// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/clip_polygon.h"

namespace shadowlab::scene {

std::vector<dvec4> clippedPolygon(const std::vector<dvec4>& polygon, const dvec4& plane) {
    std::vector<dvec4> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec4 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const double dHere = glm::dot(plane, here), dNext = glm::dot(plane, next);
        if (dHere >= 0) inside.push_back(here);
        if ((dHere >= 0) != (dNext >= 0)) inside.push_back(glm::mix(here, next, dHere / (dHere - dNext)));
    }
    return inside;
}

} // namespace shadowlab::scene
