// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/volume_end.h"

#include <algorithm>
#include <limits>

namespace shadowlab::shadow_volume {

namespace {

// The end plane lies beyond the receivers by this share of their size: far more than a step of the depth buffer, so that
// cap and receiver keep different depths, and too little to cost pixels.
constexpr double kBeyondBounds = 0.0001;

// In units of the receivers' size. A grazing light reaches a side of the box only after a long way. Ending the volume there
// saves little, and the rounding of its far vertices grows with the distance.
constexpr double kLongest = 4.0;

dvec3 pushedToPlane(const dvec3& pointWorld, const dvec3& awayWorld, const dvec4& planeWorld) {
    return pointWorld -
           awayWorld * (glm::dot(planeWorld, dvec4(pointWorld, 1.0)) / glm::dot(dvec3(planeWorld), awayWorld));
}

dvec3 awayFrom(const scene::Light& light, const dvec3& pointWorld) {
    const dvec4 lightWorld = scene::homogeneousPositionWorld(light);
    return pointWorld * lightWorld.w - dvec3(lightWorld);
}

dvec4 sideOf(const scene::Bounds& box, int axis, double side) {
    dvec4 plane(0.0);
    plane[axis] = side;
    plane.w = -side * (side > 0 ? box.upperWorld : box.lowerWorld)[axis];
    return plane;
}

} // namespace

std::optional<dvec4> endPlaneWorld(const scene::Bounds& box, const scene::Light& light,
                                   const scene::Bounds& receivers) {
    const double size = glm::length(receivers.upperWorld - receivers.lowerWorld);
    std::optional<dvec4> best;
    double shortest = kLongest * size;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            dvec4 plane = sideOf(receivers, axis, side);
            plane.w -= kBeyondBounds * size;
            // The distance to the plane is a ratio of linear functions of the point, so over the box its maximum is at a
            // corner.
            double longest = 0;
            for (int i = 0; i < 8; ++i) {
                const dvec3 corner = box.corner(i), away = awayFrom(light, corner);
                const bool approaches = side * away[axis] > 0 && glm::dot(plane, dvec4(corner, 1.0)) < 0;
                longest = approaches ? std::max(longest, glm::length(pushedToPlane(corner, away, plane) - corner))
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

bool missesAll(const scene::Bounds& box, const scene::Light& light, const scene::Bounds& receivers) {
    if (receivers.isEmpty()) return true;
    const double slack = kBeyondBounds * glm::length(receivers.upperWorld - receivers.lowerWorld);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const dvec4 plane = sideOf(receivers, axis, side);
            bool away = true;
            for (int i = 0; i < 8 && away; ++i) {
                const dvec3 corner = box.corner(i);
                away = glm::dot(plane, dvec4(corner, 1.0)) > slack && side * awayFrom(light, corner)[axis] >= 0;
            }
            if (away) return true;
        }
    return false;
}

dvec4 pushedWorld(const dvec3& pointWorld, const scene::Light& light, const VolumeEnd& end) {
    const dvec3 away = awayFrom(light, pointWorld);
    if (end.planeWorld) return {pushedToPlane(pointWorld, away, *end.planeWorld), 1.0};
    if (end.distance) return {pointWorld + away * (*end.distance / glm::length(away)), 1.0};
    return {away, 0.0};
}

} // namespace shadowlab::shadow_volume
