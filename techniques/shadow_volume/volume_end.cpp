// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/volume_end.h"

#include <algorithm>
#include <limits>

namespace shadowlab::shadow_volume {

namespace {

// The end stays this share of the scene's size beyond it: far more than the depth buffer's steps, which it must not be
// mistaken for the last receiver by, and far less than would cost anything.
constexpr double kBeyond = 0.0001;

// In units of the scene's size. A grazing light meets no side soon; what is gained by ending the volume there is little, and
// the rounding of its far corners grows with the way.
constexpr double kLongest = 4.0;

} // namespace

std::optional<dvec4> endPlaneWorld(const scene::Bounds& box, const scene::Light& light,
                                   const scene::Bounds& sceneBounds) {
    const double size = glm::length(sceneBounds.upperWorld - sceneBounds.lowerWorld);
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    std::optional<dvec4> best;
    double shortest = kLongest * size;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            dvec4 plane(0.0);
            plane[axis] = side;
            plane.w = -side * (side > 0 ? sceneBounds.upperWorld : sceneBounds.lowerWorld)[axis] - kBeyond * size;
            // The way is a ratio of linear functions of the point, so over the box it is longest at a corner.
            double longest = 0;
            for (int i = 0; i < 8; ++i) {
                const dvec3 corner = box.corner(i), away = corner * lightWorld.w - dvec3(lightWorld);
                const double approach = side * away[axis];
                longest = approach > 0 ? std::max(longest, glm::length(pushedToPlane(corner, light, plane) - corner))
                                       : std::numeric_limits<double>::infinity();
                if (!(longest < shortest)) break;
            }
            if (longest < shortest) {
                shortest = longest;
                best = plane;
            }
        }
    return best;
}

dvec3 pushedToPlane(const dvec3& pointWorld, const scene::Light& light, const dvec4& planeWorld) {
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    const dvec3 away = pointWorld * lightWorld.w - dvec3(lightWorld);
    return pointWorld - away * (glm::dot(planeWorld, dvec4(pointWorld, 1.0)) / glm::dot(dvec3(planeWorld), away));
}

} // namespace shadowlab::shadow_volume
