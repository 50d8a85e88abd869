// Walls that have changed places are walls again, and what is right stays as it is.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/inside_out.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::radiosity {
namespace {

/// A box about the origin, its fronts outside or inside.
void addBox(ClusteredMesh& mesh, double side, bool frontsAreInside) {
    const scene::Mesh box = scene::makeBox(dvec3(side));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const vec3& position : box.positionsMesh)
        mesh.positions.emplace_back(position);
    for (const uvec3& t : box.triangles) {
        const uvec3 corners = frontsAreInside ? uvec3(t.x, t.z, t.y) : t;
        mesh.triangles.push_back(corners + first);
    }
    mesh.parts.resize(mesh.triangles.size(), 0);
}

/// A hollow box: an outer wall, and an inner one that looks into the hollow.
ClusteredMesh hollowBox(double outer, double inner) {
    ClusteredMesh mesh;
    addBox(mesh, outer, false);
    addBox(mesh, inner, true);
    return mesh;
}

double volume(const ClusteredMesh& mesh) {
    double sum = 0;
    for (const uvec3& t : mesh.triangles)
        sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6;
    return sum;
}

ClusteredMesh mirrored(ClusteredMesh mesh) {
    for (dvec3& position : mesh.positions)
        position.x = -position.x;
    return mesh;
}

TEST(InsideOut, WallsThatHaveChangedPlacesAreTurned) {
    ClusteredMesh mesh = hollowBox(1.8, 2);
    EXPECT_NEAR(volume(mesh), 1.8 * 1.8 * 1.8 - 8, 1e-6) << "less than nothing: inside out";
    orientOutward(mesh, false);
    EXPECT_NEAR(volume(mesh), 8 - 1.8 * 1.8 * 1.8, 1e-6) << "all 24 triangles are turned";
}

TEST(InsideOut, WhatIsRightStays) {
    const ClusteredMesh before = hollowBox(2, 1.8);
    ClusteredMesh mesh = before;
    orientOutward(mesh, false);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(InsideOut, MirroredBodiesHaveTheirFrontsInside) {
    const ClusteredMesh right = mirrored(hollowBox(2, 1.8));
    ClusteredMesh mesh = right;
    orientOutward(mesh, true);
    EXPECT_EQ(mesh.triangles, right.triangles);
    mesh = mirrored(hollowBox(1.8, 2));
    orientOutward(mesh, true);
    EXPECT_NEAR(volume(mesh), 1.8 * 1.8 * 1.8 - 8, 1e-6);
}

TEST(InsideOut, OnlyTheWallsThatAreWrongAreTurned) {
    // Beside the hollow box that is inside out a second one that is not.
    ClusteredMesh mesh = hollowBox(1.8, 2);
    const ClusteredMesh other = hollowBox(2, 1.8);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const dvec3& position : other.positions)
        mesh.positions.push_back(position + dvec3(3, 0.1, 0.2));
    for (const uvec3& t : other.triangles)
        mesh.triangles.push_back(t + first);
    mesh.parts.resize(mesh.triangles.size(), 0);
    const std::vector<uvec3> before = mesh.triangles;
    orientOutward(mesh, false);
    ASSERT_EQ(before.size(), 48u);
    for (std::size_t t = 0; t < before.size(); ++t)
        EXPECT_EQ(mesh.triangles[t] != before[t], t < 24) << t;
}

} // namespace
} // namespace shadowlab::radiosity
