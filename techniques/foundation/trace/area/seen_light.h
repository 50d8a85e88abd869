// An area light as one point sees it: a rect or a disc in a plane.
//
// Of a rect it is the rect. Of a sphere it is the disc inside the circle in which the tangents from the point touch it: what stands outside
// the sphere and on its near side stands before the sphere exactly where it stands before that disc.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::trace {

/// Places on the light are given by two numbers: middle + x * axisU + y * axisV. All vectors start at the point that looks.
struct SeenLight {
    dvec3 middle{0.0}, axisU{0.0}, axisV{0.0};
    bool isDisc = false;            ///< the places within the unit circle, else those within the outline
    std::span<const dvec2> outline; ///< a square, of a disc the one around it; counter-clockwise
    dvec2 half{0.0};                ///< no place of the outline is farther from the middle, along either axis
    double area = 0;                ///< of all those places

    [[nodiscard]] dvec3 toward(dvec2 place) const { return middle + place.x * axisU + place.y * axisV; }
    /// The share of the way toward(place) at which the light is met: 1, of a sphere where the way enters it.
    [[nodiscard]] double reach(dvec2 place) const;
    /// The product of a vector with toward(place), as a linear function of the place: x * place.x + y * place.y + z.
    [[nodiscard]] dvec3 product(const dvec3& vector) const {
        return {glm::dot(vector, axisU), glm::dot(vector, axisV), glm::dot(vector, middle)};
    }
    /// How far such a function may be from its value in the middle.
    [[nodiscard]] double range(const dvec3& function) const {
        return glm::abs(function.x) * half.x + glm::abs(function.y) * half.y;
    }
    /// Metres across, at most.
    [[nodiscard]] double diameter() const { return 2 * (half.x * glm::length(axisU) + half.y * glm::length(axisV)); }
};

/// `toLight` goes from the point to the light's centre. Nothing for a point within a sphere, which sees no disc, and for
/// lights without an area.
std::optional<SeenLight> seenLight(const scene::Light& light, const dvec3& toLight);

} // namespace shadowlab::trace
