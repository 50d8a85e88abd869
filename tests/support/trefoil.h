// A knot of any number of triangles: closed, and meeting itself nowhere unless its tube is too thick.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::testing {

/// A tube of that radius along a trefoil some 6 across, `along` by `around` quads, vertices in rows. Its strands are a little
/// more than 0.6 apart where they pass each other.
inline scene::Mesh trefoil(double tube, std::uint32_t along, std::uint32_t around) {
    scene::Mesh mesh;
    const auto middle = [](double t) {
        return dvec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
    };
    for (std::uint32_t i = 0; i < along; ++i) {
        const double t = glm::two_pi<double>() * i / along;
        const dvec3 forward = glm::normalize(middle(t + 1e-4) - middle(t - 1e-4));
        const dvec3 side = glm::normalize(glm::cross(forward, dvec3(0, 0, 1))), up = glm::cross(side, forward);
        for (std::uint32_t j = 0; j < around; ++j) {
            const double angle = glm::two_pi<double>() * j / around;
            mesh.positionsMesh.emplace_back(middle(t) + tube * (std::cos(angle) * side + std::sin(angle) * up));
        }
    }
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const std::uint32_t j1 = (j + 1) % around, i1 = (i + 1) % along;
            const std::uint32_t a = i * around + j, b = i * around + j1, c = i1 * around + j1, d = i1 * around + j;
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(a, c, d);
        }
    return mesh;
}

} // namespace shadowlab::testing
