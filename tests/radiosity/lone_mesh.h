// A mesh as an object of its own, and the light that it sends.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

inline scene::Object objectOf(scene::Mesh mesh, const dmat4& worldFromObject = dmat4(1)) {
    scene::Scene scene;
    scene.materials.emplace_back();
    return addObject(scene, std::move(mesh), worldFromObject);
}

/// The form factor from a point of a surface to the fronts of all its triangles, each by its closed form, where none hides another.
inline double meshFormFactor(const scene::Object& object, const dvec3& positionWorld, const dvec3& normal) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    double sum = 0;
    for (const uvec3& t : object.mesh->triangles) {
        const auto corner = [&](int c) { return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[t[c]])); };
        const radiosity::Polygon triangle{corner(0), corner(1), corner(2)};
        if (planeOf(triangle).height(positionWorld) > 0) sum += radiosity::pointFormFactor(positionWorld, normal, triangle);
    }
    return sum;
}

} // namespace shadowlab::testing
