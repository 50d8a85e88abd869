// The eye, and the matrices that follow from it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <limits>
#include <string>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

struct Camera {
    dvec3 positionWorld{0.0, 1.0, 5.0};
    dvec3 targetWorld{0.0};
    dvec3 upWorld{0.0, 1.0, 0.0};
    double fovYDegrees = 45.0; ///< full vertical angle
    double near = 0.1;         ///< metres; nothing nearer is seen
    double far =
        std::numeric_limits<double>::infinity(); ///< metres; a hint for depth fitting, never a clip of the picture
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// One of the cameras that a scene offers, beside the one it begins with.
struct Viewpoint {
    std::string name;
    Camera camera;
    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// True if position, target and up define a view. False if the target is the position, or if up is within a millionth of a
/// radian of parallel to the view, because "right" would then consist of rounding errors.
bool hasView(const Camera& camera);

/// View space: origin at the eye, camera looks down -z, +y up in the picture.
dmat4 viewFromWorld(const Camera& camera);

/// Perspective projection with the far plane at infinity, so that points at infinity (w = 0) keep a depth.
/// Source: Everitt and Kilgard, "Practical and Robust Stenciled Shadow Volumes", 2002.
dmat4 clipFromView(const Camera& camera, double aspect);

/// Unit direction, in world space, of the ray through a point of the picture.
/// `pixel` counts from the upper left corner; (x + 0.5, y + 0.5) is a pixel's centre. `size` is in pixels.
dvec3 rayDirectionWorld(const Camera& camera, dvec2 pixel, ivec2 size);

/// Corners, in world space, of the rectangle that the camera sees of the plane at that depth (metres along its axis): upper
/// left, upper right, lower right and lower left of the picture. `aspect` is width over height.
std::array<dvec3, 4> viewCorners(const Camera& camera, double aspect, double depth);

} // namespace shadowlab::scene
