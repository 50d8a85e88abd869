// A plane seen from straight above, on which shadows have outlines that are known in closed form.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// `pixelsPerMetre` on the plane y = 0, the point `centre` (x, z) in the middle of a picture of that size. The near plane
/// lies just above the plane: what stands on it is cut away, and only casts its shadow.
struct PlaneView {
    dvec2 centre;
    double pixelsPerMetre;
    ivec2 size;
    [[nodiscard]] dvec2 pixel(dvec2 onPlane) const { return dvec2(size) / 2.0 + (onPlane - centre) * pixelsPerMetre; }
    [[nodiscard]] scene::Camera camera() const;
};

/// A plane of 1000 x 1000 under a point light.
scene::Scene planeUnderLight(const dvec3& lightWorld);

/// Around the middle of a picture; half axes in pixels, the first one along the unit vector `along`.
struct EllipseInPicture {
    dvec2 middle{0.0}, along{1.0, 0.0};
    double a = 0, b = 0;
    /// From the outline, in pixels, for points that are near it: outside is positive.
    [[nodiscard]] double distancePx(dvec2 pixel) const;
    [[nodiscard]] double lengthPx() const;
};

/// A sphere of half a metre that hovers over the plane, a light beside it, and its shadow, which fills 60 % of the
/// picture's height.
struct SphereShadow {
    scene::Scene scene; ///< with the camera of the view
    EllipseInPicture ellipse;
};
SphereShadow sphereShadow(ivec2 size, int segments);

} // namespace shadowlab::testing
