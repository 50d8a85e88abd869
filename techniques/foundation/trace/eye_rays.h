// The rays from the eye through the points of a picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/camera.h"
#include "techniques/foundation/trace/ray.h"

namespace shadowlab::trace {

/// The same rays as scene::rayDirectionWorld, with what all of them share computed once. Their t is the depth along the
/// camera's axis, so the near plane is one number for all.
class EyeRays {
public:
    EyeRays(const scene::Camera& camera, ivec2 size, const dvec3& originWorld)
        : eyeCentred_(camera.positionWorld - originWorld), near_(camera.near), size_(size),
          worldFromView_(glm::transpose(dmat3(scene::viewFromWorld(camera)))),
          halfHeight_(std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0)),
          halfWidth_(halfHeight_ * size.x / size.y) {}

    [[nodiscard]] const dvec3& eyeCentred() const { return eyeCentred_; }

    /// `pixel` counts from the upper left corner; (x + 0.5, y + 0.5) is a pixel's centre.
    [[nodiscard]] Ray through(dvec2 pixel) const {
        const dvec3 directionView((2.0 * pixel.x / size_.x - 1.0) * halfWidth_,
                                  (1.0 - 2.0 * pixel.y / size_.y) * halfHeight_, -1.0);
        Ray ray;
        ray.originCentred = eyeCentred_;
        ray.directionCentred = worldFromView_ * directionView;
        ray.nearest = near_;
        return ray;
    }

private:
    dvec3 eyeCentred_;
    double near_;
    ivec2 size_;
    dmat3 worldFromView_;
    double halfHeight_, halfWidth_;
};

} // namespace shadowlab::trace
