// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/clip_polygon.h"

namespace shadowlab::scene {

std::vector<dvec4> boxFaceWorld(const Bounds& box, int face) {
    static constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    std::vector<dvec4> polygon;
    for (const int corner : kFaces[face])
        polygon.emplace_back(box.corner(corner), 1.0);
    return polygon;
}

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
