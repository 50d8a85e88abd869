// A half plane under a square light: the penumbra that is known in closed form, and how errors fall with the number of points.
//
// Light of 1 x 1 m at a height of 4, edge of the half plane at a height of 2 above x = 0: on the floor the penumbra is exactly
// |x| < 1/2, and the visible share of the light's area 1/2 + x.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <vector>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

inline const PlaneView kHalfPlaneView{.centre = {0, 0}, .pixelsPerMetre = 64, .size = {96, 4}};

/// 1 x 1 m, shining down.
inline scene::Light squareLight(const dvec3& centreWorld) {
    scene::Light light;
    light.type = scene::LightType::rect;
    light.positionWorld = centreWorld;
    light.edgeUWorld = {1, 0, 0};
    light.edgeVWorld = {0, 0, 1}; // u x v points down
    return light;
}

inline scene::Scene halfPlaneUnderSquareLight() {
    scene::Scene scene = floorScene();
    scene.camera = kHalfPlaneView.camera();
    // 3 x 4 m are enough: no point in the picture sees the light beside the other three sides.
    addObject(scene, scene::makeQuad({3, 4}), translation({-1.5, 2, 0}));
    scene.lights.push_back(squareLight({0, 4, 0}));
    return scene;
}

/// Of log error against log count, by least squares.
inline double logSlope(const std::vector<int>& counts, const std::vector<double>& errors) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double x = std::log(counts[i]), y = std::log(errors[i]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace shadowlab::testing
