// Dragging lights and objects: how far a thing moves in the scene when the mouse moves over the picture.
//
// Every way of dragging is solved for a small step of the mouse and followed step by step. So a thing moves for every
// movement of the mouse, also where the eye sees the ground edge-on, and also while it is outside the picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/lab/handles.h"

namespace shadowlab::lab {

/// Which movements a drag allows.
enum class DragWay {
    level,    ///< over the ground
    picture,  ///< in the plane through the thing that faces the eye
    upright,  ///< up and down
    alongX, alongY, alongZ, ///< one axis of the world
    turn,     ///< a directional light, about the camera's target
};

/// What the mouse has taken hold of. Decided when the button goes down, kept until it is up.
struct Hold {
    DragWay way = DragWay::picture;
    dvec3 gripFromPlaceWorld{0.0}; ///< from the handle's place to the point that was taken hold of
    double side = 1;               ///< of a directional light: 1 before the scene, and -1 behind it, where the far side is held
    double gain = 1;               ///< of a thing outside the picture: how much farther it goes than the mouse
    double leastDepth = 0.1;       ///< of the distance to the camera's target: what is nearer to the eye moves as if it were there
};

/// The way for a thing that is taken hold of at `gripWorld`. The ground serves where the eye sees it under the thing well enough.
/// `markPixel` is the thing's mark at the picture's edge, if it is seen only by that.
Hold holdOf(const scene::Camera& camera, ivec2 size, const scene::Scene& scene, const Handle& handle, const dvec3& gripWorld,
            const std::optional<dvec2>& markPixel);

/// How far the thing moves in world space while the mouse moves by `byPixels`, x to the right and y down. Of a directional
/// light: how far the point moves where its handle is.
dvec3 draggedBy(const Hold& hold, const scene::Camera& camera, ivec2 size, const dvec3& placeWorld, const dvec2& byPixels);

} // namespace shadowlab::lab
