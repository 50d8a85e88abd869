// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/default_near.h"

#include <algorithm>

#include "techniques/foundation/scene/query/view/depth_fit.h"

namespace shadowlab::scene {

double defaultNear(const Scene& scene, Camera camera) {
    constexpr double kOrdinary = 0.1;    // metres
    constexpr double kShare = 0.1;       // of the distance to what is looked at
    constexpr double kLeastShare = 0.01; // the same, where something reaches to the eye
    constexpr double kWidest = 4;        // wider than any screen: the scene does not know the picture's shape
    const double way = glm::length(camera.targetWorld - camera.positionWorld);
    camera.near = kLeastShare * std::min(way, 1.0);
    const double nearest = nearestInView(camera, scene, kWidest, kOrdinary);
    double near = std::min(kOrdinary, kShare * way);
    if (nearest < kOrdinary) near = std::min(near, std::max(camera.near, kShare * nearest));
    return std::min(near, kShare * camera.far);
}

} // namespace shadowlab::scene
