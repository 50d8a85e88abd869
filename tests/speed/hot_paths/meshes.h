// The meshes and scenes that the benchmarks grow.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"
#include "tests/support/trefoil.h"

namespace shadowlab::speed {

/// A knot of about so many triangles, five times as many along as around.
inline scene::Mesh knot(std::int64_t triangles) {
    const auto around = static_cast<std::uint32_t>(std::max(3.0, std::sqrt(static_cast<double>(triangles) / 10.0)));
    scene::Mesh mesh = testing::trefoil(0.25, 5 * around, around);
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return scene::withNormals(mesh, scene::NormalMode::smooth);
}

/// That knot over a floor, under so many point lights in a ring.
inline scene::Scene knotScene(std::int64_t triangles, int lights = 1) {
    scene::Scene scene = testing::floorScene();
    scene.camera.positionWorld = {0, 6, 11};
    scene.camera.targetWorld = {0, 1.5, 0};
    testing::addObject(scene, knot(triangles), testing::translation({0, 3, 0}));
    for (int i = 0; i < lights; ++i) {
        const double angle = 0.7 + 6.28 * i / lights;
        scene.lights.push_back(testing::pointLight({5 * std::cos(angle), 9, 5 * std::sin(angle)}));
        scene.lights.back().name += std::to_string(i);
    }
    return scene;
}

} // namespace shadowlab::speed
