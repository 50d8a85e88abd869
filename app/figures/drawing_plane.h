// The plane in the scene that a drawing of rays lies in, and what of the scene's surfaces lies in it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/probe.h"

namespace shadowlab::figures {

/// Two unit axes at right angles in the plane. Drawings have y downward: see onSheet().
struct DrawingPlane {
    dvec3 originWorld{0.0}, rightWorld{1, 0, 0}, upWorld{0, 1, 0};
    [[nodiscard]] dvec2 of(const dvec3& positionWorld) const { return ofDirection(positionWorld - originWorld); }
    [[nodiscard]] dvec2 ofDirection(const dvec3& directionWorld) const {
        return {glm::dot(directionWorld, rightWorld), glm::dot(directionWorld, upWorld)};
    }
    [[nodiscard]] dvec3 normalWorld() const { return glm::cross(rightWorld, upWorld); }
};

/// The plane of incidence of the first surface: of the ray that comes and the normal, in which the reflected and the
/// refracted ray lie, too. Up is up in the scene, as far as the plane allows; the eye is on the left.
DrawingPlane planeOfIncidence(const Probe& probe);
/// The same plane turned, so that the normal points up.
DrawingPlane planeWithNormalUp(const Probe& probe);

/// Where the scene's triangles meet the plane: two points for each segment.
std::vector<dvec2> cut(const scene::Scene& scene, const DrawingPlane& plane);

} // namespace shadowlab::figures
