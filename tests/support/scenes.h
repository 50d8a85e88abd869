// Small scenes for tests, built in memory.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <random>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::testing {

/// A mesh of loose triangles (three vertices each, flat normals), one material.
scene::Mesh triangleSoup(const std::vector<dvec3>& corners);

/// Adds an object with that mesh; returns it for further changes.
scene::Object& addObject(scene::Scene& scene, scene::Mesh mesh, const dmat4& worldFromObject = dmat4(1.0));

/// A scene with the default material, a floor of 10 x 10 at y = 0 and a camera at (0, 3, 6) that looks at the origin.
scene::Scene floorScene();

scene::Light pointLight(const dvec3& positionWorld);
scene::Light directionalLight(const dvec3& directionWorld);

/// A small, simple scene that every technique can be tried on: floor, box, sphere and torus, one point light.
scene::Scene simpleScene();

/// The simple scene with a mirrored object, one that casts no shadow and one that receives none, under a light of each type,
/// and under lights that rays find hard: along an axis, close to the floor, among the objects.
scene::Scene everyKindOfLight();

/// The whole scene moved: camera, lights and objects.
scene::Scene moved(const scene::Scene& scene, const dvec3& offsetWorld);

/// Everything as many times as large: camera, lights and objects.
scene::Scene scaled(const scene::Scene& scene, double factor);

inline scene::Snapshot snapshot(scene::Scene scene) { return std::make_shared<const scene::Scene>(std::move(scene)); }

dmat4 translation(const dvec3& offset);

} // namespace shadowlab::testing
