// Rays to meshes: to groups of triangles that matter, and as often as their density says.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/mesh_aim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/radiosity/lights/lamps_between.h"
#include "tests/radiosity/lone_mesh.h"
#include "tests/radiosity/quasirandom.h"

namespace shadowlab::radiosity {
namespace {

/// A ring 1 m wide, as an object of a scene whose material glows.
struct GlowingRing {
    GlowingRing() {
        scene.materials.emplace_back().emission = vec3(2);
        testing::addObject(scene, scene::makeTorus(0.5, 0.03, {64, 32}), testing::translation({1, 2, 3}));
    }
    [[nodiscard]] const scene::Object& object() const { return scene.objects[0]; }
    scene::Scene scene;
};

bool usesSpheres(scene::Mesh mesh, const dmat4& worldFromObject = dmat4(1)) {
    scene::Scene scene;
    scene.materials.emplace_back();
    return MeshAim(scene, testing::addObject(scene, std::move(mesh), worldFromObject)).usesSpheres();
}

TEST(MeshAim, OnlyBallsFillTheirSpheres) {
    EXPECT_TRUE(usesSpheres(scene::makeSphere(0.5, 48)));
    EXPECT_TRUE(usesSpheres(scene::makeSphere(1, 48), glm::scale(dmat4(1), dvec3(0.9, 1, 0.9)))) << "an apple";
    EXPECT_FALSE(usesSpheres(scene::makeSphere(1, 48), glm::scale(dmat4(1), dvec3(0.5, 1, 0.5)))) << "an egg";
    EXPECT_FALSE(usesSpheres(scene::makeSphere(1, 48), glm::scale(dmat4(1), dvec3(0.05, 1, 0.05)))) << "a tube";
    EXPECT_FALSE(usesSpheres(scene::makeTorus(0.5, 0.03, {64, 32})));
}

// One over the density, summed over the chosen points of the side that is seen, each by its cosine here, is the irradiance.
TEST(MeshAim, PointsAreChosenAsOftenAsTheirDensitySays) {
    const GlowingRing ring;
    const MeshAim aim(ring.scene, ring.object());
    const dvec3 from(1.1, 2.6, 3), down(0, -1, 0);
    constexpr int kChoices = 4000; // of each group
    double found = 0;
    for (std::size_t group = 0; group < aim.groups(); ++group)
        for (int i = 0; i < kChoices; ++i) {
            const auto x = testing::quasirandom4(i);
            const auto way = aim.choose(group, from, x[0], {x[1], x[2]});
            ASSERT_TRUE(way);
            EXPECT_NEAR(glm::length(way->direction), 1, 1e-12);
            const dvec3 point = from + way->distance * way->direction, off = point - dvec3(1, 2, 3);
            const dvec3 onCircle = 0.5 * glm::normalize(dvec3(off.x, 0, off.z)), outward = glm::normalize(off - onCircle);
            EXPECT_NEAR(glm::distance(off, onCircle), 0.03, 0.001) << "it has faces";
            if (glm::dot(outward, way->direction) < 0) found += std::max(0.0, glm::dot(way->direction, down)) / (way->density * kChoices);
            if (i == 0) {
                EXPECT_EQ(aim.density(group, from, way->direction, 2 * way->distance, 0.5), aim.density(group, from, way->direction, way->distance, 0.5) * 4);
            }
        }
    const double truth = glm::pi<double>() * testing::meshFormFactor(ring.object(), from, down);
    EXPECT_GT(truth, 0.1);
    EXPECT_NEAR(found / truth, 1, 0.01) << "sides by the torus, which the mesh's faces follow to some degrees";
}

// What a point brings, over the likelihood of its group, would be the same for all if groups were points: so much less noise do they leave.
TEST(MeshAim, GroupsAreAsLikelyAsTheyBringLight) {
    const GlowingRing ring;
    const MeshAim aim(ring.scene, ring.object());
    const Receiver at{{1.4, 1, 2.5}, {0, 1, 0}, 0.01};
    ASSERT_EQ(aim.groups(), 128u);
    std::vector<double> likely;
    double all = 0;
    for (std::size_t group = 0; group < aim.groups(); ++group)
        all += likely.emplace_back(aim.likely(group, at, 0));
    constexpr int kChoices = 200; // of each group
    const auto variance = [&](const auto& shareOf) {
        double mean = 0, square = 0;
        for (std::size_t group = 0; group < aim.groups(); ++group)
            for (int i = 0; i < kChoices; ++i) {
                const auto x = testing::quasirandom4(i);
                const auto way = aim.choose(group, at.positionWorld, x[0], {x[1], x[2]});
                const dvec3 off = at.positionWorld + way->distance * way->direction - dvec3(1, 2, 3);
                const dvec3 outward = glm::normalize(off - 0.5 * glm::normalize(dvec3(off.x, 0, off.z)));
                const double brought = glm::dot(outward, way->direction) < 0 ? way->direction.y / (shareOf(group) * way->density) : 0;
                mean += shareOf(group) * brought / kChoices, square += shareOf(group) * brought * brought / kChoices;
            }
        return square / (mean * mean) - 1;
    };
    const double byGroups = variance([&](std::size_t group) { return likely[group] / all; });
    const double alike = variance([&](std::size_t) { return 1.0 / 128; }); // groups have about as many triangles each
    std::cout << "variance by groups " << byGroups << ", all alike " << alike << "\n";
    EXPECT_GT(alike, 1.5) << "half of it is turned away";
    EXPECT_LT(byGroups, 0.35);
}

// Where only a part of a mesh glows, and what it reflects is little, nearly all rays go there; and none to what sends nothing.
TEST(MeshAim, WhatGlowsIsChosen) {
    GlowingRing ring;
    ring.scene.materials.emplace_back();
    scene::Object& object = ring.scene.objects[0];
    scene::Mesh mesh = *object.mesh;
    const auto half = static_cast<std::uint32_t>(mesh.triangles.size() / 2);
    mesh.parts = {{"lamp", 0, half, false}, {"wall", half, static_cast<std::uint32_t>(mesh.triangles.size()) - half, false}};
    object.mesh = std::make_shared<scene::Mesh>(mesh);
    object.partMaterials = {0, 1};
    const MeshAim aim(ring.scene, object);
    EXPECT_NEAR(aim.emitted(), 2 * glm::pi<double>() * 0.5 * surfaceArea(object), 1e-6 * aim.emitted()) << "vertices are floats";
    const Receiver at{{1, 1, 3}, {0, 1, 0}, 0.01};
    int dark = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        EXPECT_EQ(aim.likely(aim.groupOf(t), at, 0) > 0, t < half) << t;
        EXPECT_GT(aim.likely(aim.groupOf(t), at, 1e-3), 0);
        dark += t >= half;
    }
    EXPECT_EQ(dark, 4096 / 2);
}

} // namespace
} // namespace shadowlab::radiosity
