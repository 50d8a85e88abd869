// The handles of lights and objects in a picture, and where a drag of the mouse moves them.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::lab {

/// One thing that can be taken hold of.
struct Selection {
    enum class Kind { none, light, object } kind = Kind::none;
    int index = 0;
    friend bool operator==(const Selection&, const Selection&) = default;
};

struct Handle {
    Selection what;
    dvec3 positionWorld{0.0};
    std::string label;
};

/// Of all lights, and of all objects but the surfaces of lights; of an object in pieces, at the first, which has the most triangles. A
/// directional light has no place: its handle is the point its arrow comes from, seen from the camera's target, as far from there as
/// the eye is.
std::vector<Handle> handles(const scene::Scene& scene, const std::vector<scene::Bounds>& bounds,
                            const scene::Camera& camera);

/// The scene with that thing moved. A directional light turns, so that its handle is where it was moved to.
scene::Snapshot withMoved(const scene::Snapshot& snapshot, const Selection& what, const dvec3& byWorld,
                          const scene::Camera& camera);

/// From the scene to the picture of that size: for many points.
class PictureProjection {
public:
    PictureProjection(const scene::Camera& camera, const dvec2& size);
    /// In pixels from the picture's upper left corner; nothing behind the camera.
    [[nodiscard]] std::optional<dvec2> pixel(const dvec3& positionWorld) const;

private:
    dmat4 clipFromWorld_;
    dvec2 size_;
    double near_;
};
/// The same for one point.
std::optional<dvec2> pixelOf(const scene::Camera& camera, ivec2 size, const dvec3& positionWorld);

/// A mark at the picture's edge for a point that the picture does not show.
struct EdgeMark {
    dvec2 pixel{0.0};   ///< `margin` pixels within the picture
    dvec2 outward{0.0}; ///< unit, x to the right and y down: the way to turn the camera to see the point
};
/// Nothing for a point that is in the picture.
std::optional<EdgeMark> edgeMarkOf(const scene::Camera& camera, ivec2 size, double margin, const dvec3& positionWorld);

} // namespace shadowlab::lab
