// Light sources: the five kinds a scene may hold, and the point each is reduced to where a technique needs one.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

enum class LightType { point, directional, spot, rect, sphere };

/// The name scene files use for a type.
std::string_view toText(LightType type);

struct Light {
    std::string name;
    LightType type = LightType::point;
    dvec3 positionWorld{0.0};             ///< point, spot, rect (its centre), sphere (its centre)
    dvec3 directionWorld{0.0, -1.0, 0.0}; ///< unit; the way the light travels (directional, spot)
    dvec3 edgeUWorld{1.0, 0.0, 0.0};      ///< rect: full edge
    dvec3 edgeVWorld{0.0, 0.0, 1.0};      ///< rect: full edge; it shines to the side of cross(edgeU, edgeV)
    double radius = 0.5;                  ///< sphere
    double coneDegrees = 60.0;            ///< spot: full apex angle
    double edgeDegrees = 0.0;             ///< spot: smooth band inside the cone
    vec3 color{1.0f};                     ///< linear RGB
    double intensity = 1.0;               ///< point, spot: W/sr-like; directional: irradiance; rect, sphere: radiance
    friend bool operator==(const Light&, const Light&) = default;
};

/// The light as a homogeneous point: w = 1 at its centre, or w = 0 toward the light for a directional one.
/// v * l.w - l.xyz then points from the light through v for both kinds: the direction volumes are extruded in.
dvec4 homogeneousPositionWorld(const Light& light);

/// True if the edges of a rect span a surface; if they are nearly parallel, the side it shines to is undecided.
bool edgesSpan(const Light& light);

/// Unit vector from the light's centre in which a rect shines.
dvec3 rectNormalWorld(const Light& light);

/// True for the lights that have a surface, which eye rays see.
bool hasArea(const Light& light);

/// Intensity of the point light that stands for this light at its centre (before the cosine at a rect):
/// I for point, spot and directional, L * A for a rect, L * pi r^2 for a sphere.
double pointIntensity(const Light& light);

} // namespace shadowlab::scene
