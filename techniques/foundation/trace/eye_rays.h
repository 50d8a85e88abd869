// The rays from the eye through the points of a picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/packets/block_rays.h"
#include "techniques/foundation/trace/ray.h"

namespace shadowlab::trace {

/// What the ends of eye rays depend on: all of a scene but its lights, where it is seen from, and the picture's size.
struct SeenFrom {
    SeenFrom() = default;
    SeenFrom(const scene::Scene& scene, const scene::Camera& seenBy, ivec2 pictureSize)
        : revisions(scene.revisions), camera(seenBy), size(pictureSize) {
        revisions.lights = 0;
    }
    scene::Revisions revisions; ///< that of the lights left out
    scene::Camera camera;
    ivec2 size{0};
    friend bool operator==(const SeenFrom&, const SeenFrom&) = default;
};

/// The same rays as scene::rayDirectionWorld, with what all of them share computed once. Their t is the depth along the
/// camera's axis, so the near plane is one number for all.
class EyeRays {
public:
    /// `eyeIsWithin`: within a closed body that touches other surfaces (CoincidentFaces::isWithinBody).
    EyeRays(const scene::Camera& camera, ivec2 size, const dvec3& originWorld, bool eyeIsWithin)
        : eyeIsWithin_(eyeIsWithin), eyeCentred_(camera.positionWorld - originWorld), near_(camera.near), size_(size),
          worldFromView_(glm::transpose(dmat3(scene::viewFromWorld(camera)))),
          halfHeight_(std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0)),
          halfWidth_(halfHeight_ * size.x / size.y) {}

    [[nodiscard]] const dvec3& eyeCentred() const { return eyeCentred_; }
    [[nodiscard]] bool eyeIsWithin() const { return eyeIsWithin_; }

    /// Metres along the camera's axis; nothing nearer is hit.
    [[nodiscard]] double nearest() const { return near_; }

    /// `pixel` counts from the upper left corner; (x + 0.5, y + 0.5) is a pixel's centre.
    [[nodiscard]] Ray through(dvec2 pixel) const {
        const dvec3 directionView(xView(pixel.x), yView(pixel.y), -1.0);
        Ray ray;
        ray.originCentred = eyeCentred_;
        ray.directionCentred = worldFromView_ * directionView;
        ray.nearest = near_;
        return ray;
    }

    /// A ray through a thin lens that stands where the eye is, square to the camera's axis: from a place on it, given in view
    /// space, to where the ray through its middle meets the plane that is in focus, so many metres along the axis.
    [[nodiscard]] Ray throughLens(dvec2 pixel, dvec2 placeView, double focus) const {
        Ray ray = through(pixel);
        const dvec3 placeCentred = worldFromView_ * dvec3(placeView, 0.0);
        ray.originCentred += placeCentred;
        ray.directionCentred -= placeCentred / focus; // t stays the depth along the axis
        return ray;
    }

    /// The directions of through() for the block of pixels that begins at `corner`: the same products, which all rays of
    /// a column or a row share, to be added in the same order.
    [[nodiscard]] BlockFan fan(ivec2 corner, dvec2 within) const {
        BlockFan fan;
        for (int i = 0; i < kBlockSide; ++i) {
            const double x = xView(corner.x + i + within.x), y = yView(corner.y + i + within.y);
            for (int axis = 0; axis < 3; ++axis) {
                fan.column[axis][i] = worldFromView_[0][axis] * x;
                fan.row[axis][i] = worldFromView_[1][axis] * y;
                fan.back[axis] = worldFromView_[2][axis] * -1.0;
            }
        }
        return fan;
    }

private:
    [[nodiscard]] double xView(double pixel) const { return (2.0 * pixel / size_.x - 1.0) * halfWidth_; }
    [[nodiscard]] double yView(double pixel) const { return (1.0 - 2.0 * pixel / size_.y) * halfHeight_; }

    bool eyeIsWithin_;
    dvec3 eyeCentred_;
    double near_;
    ivec2 size_;
    dmat3 worldFromView_;
    double halfHeight_, halfWidth_;
};

} // namespace shadowlab::trace
