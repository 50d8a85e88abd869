// The plane that the lectures draw shadows in: through the eye, the light and the point.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The plane through eye, light and point that the lectures draw in. Two unit axes at right angles; the point is the origin, and
/// the eye is on the left.
struct LightSection {
    dvec3 originWorld{0.0}, rightWorld{1, 0, 0}, upWorld{0, 1, 0};
    /// The three lie on one line, or so nearly that it says nothing: the plane is then any that holds the line.
    bool isChosen = false;
    [[nodiscard]] dvec2 of(const dvec3& positionWorld) const { return ofDirection(positionWorld - originWorld); }
    [[nodiscard]] dvec2 ofDirection(const dvec3& directionWorld) const {
        return {glm::dot(directionWorld, rightWorld), glm::dot(directionWorld, upWorld)};
    }
    [[nodiscard]] dvec3 world(const dvec2& place) const {
        return originWorld + place.x * rightWorld + place.y * upWorld;
    }
    [[nodiscard]] dvec3 normalWorld() const { return glm::cross(rightWorld, upWorld); }
};

/// `lightWorld` is homogeneous; `normalWorld` the surface's at the point: it chooses the plane where eye and light do not.
/// Up is up in the scene, as far as the plane allows.
LightSection lightSection(const dvec3& eyeWorld, const dvec3& pointWorld, const dvec4& lightWorld,
                          const dvec3& normalWorld);

/// Where a triangle (its corners in world space) meets the plane; none where it does not. A corner in the plane counts as above
/// it, so that what two triangles share is cut alike.
std::optional<std::array<dvec2, 2>> cutBy(const LightSection& section, const std::array<dvec3, 3>& cornersWorld);

} // namespace shadowlab
