// Moving the camera: what a drag of the mouse, the wheel and the arrow keys do to it. No window and no widget here.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/camera.h"

namespace shadowlab::lab {

/// The picture's unit vectors in world space.
struct PictureAxes {
    dvec3 rightWorld, upWorld, forwardWorld;
};
PictureAxes pictureAxes(const scene::Camera& camera);

/// Goes around the target, by degrees: `right` about the up direction, `over` toward it. Stops short of looking straight
/// along up, where the picture would turn over.
scene::Camera orbited(scene::Camera camera, double rightDegrees, double overDegrees);

/// Looks around from where it stands, by degrees.
scene::Camera turnedHead(scene::Camera camera, double rightDegrees, double upDegrees);

/// Moves eye and target in the picture's plane, so that what is as far as the target moves by these shares of the
/// picture's height, to the right and up.
scene::Camera panned(scene::Camera camera, double right, double up);

/// Comes nearer to the target (factor < 1) or leaves it (> 1).
scene::Camera zoomed(scene::Camera camera, double factor);

/// Flies: eye and target go the same way, in metres along right, up and the direction of view.
scene::Camera flown(scene::Camera camera, double right, double up, double forward);

/// Metres from the eye to the target.
double targetDistance(const scene::Camera& camera);

} // namespace shadowlab::lab
