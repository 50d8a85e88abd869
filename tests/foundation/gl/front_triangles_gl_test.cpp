// Lists of triangles that can show their front (techniques/foundation/gl/scene/front_triangles.h): what they leave out is culled anyway.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/scene/front_triangles.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

class FrontTrianglesTest : public testing::GlTest {};

constexpr int kSide = 256;

/// A way to look at a body of radius 1.3 from outside.
struct Look {
    dvec4 viewer; ///< of the body's space: a point, or the direction toward it
    dmat4 clipFromMesh;
};

Look randomLook(std::mt19937& random, bool parallel) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> share(0, 1);
    const dvec3 direction = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
    const double distance = 1.5 + 20 * share(random) * share(random);
    const dmat4 view = glm::lookAt(distance * direction, dvec3(0), glm::normalize(dvec3(normal(random), normal(random), normal(random))));
    if (parallel) return {dvec4(direction, 0), glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.1, 50.0) * view};
    return {dvec4(distance * direction, 1), glm::perspective(2 * std::asin(std::min(1.4 / distance, 0.95)), 1.0, 0.05, 50.0) * view};
}

TEST_F(FrontTrianglesTest, TheViewerIsThatOfTheProjection) {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Look look = randomLook(random, i % 2 == 0);
        const dvec4 found = gl::viewerMesh(look.clipFromMesh);
        EXPECT_EQ(found.w, look.viewer.w);
        EXPECT_LT(glm::distance(found, look.viewer), 1e-9 * glm::length(look.viewer)) << i;
    }
}

TEST_F(FrontTrianglesTest, OfASphereTheyAreThoseOfTheCapInView) {
    const scene::Mesh sphere = scene::makeSphere(1, 96);
    for (const double distance : {1.2, 2.0, 10.0}) {
        const auto list = gl::frontTriangles(sphere, dvec4(0, distance, 0, 1));
        // The cap that a point at distance d sees is (1 - 1/d) / 2 of the sphere, in solid angle.
        double area = 0, whole = 0;
        const auto areaOf = [&](std::uint32_t t) {
            const uvec3& c = sphere.triangles[t];
            const dvec3 a = sphere.positionsMesh[c.x];
            return glm::length(glm::cross(dvec3(sphere.positionsMesh[c.y]) - a, dvec3(sphere.positionsMesh[c.z]) - a)) / 2;
        };
        for (std::uint32_t t = 0; t < sphere.triangles.size(); ++t)
            whole += areaOf(t);
        for (const std::uint32_t t : list)
            area += areaOf(t);
        // The border of the list lies within a row of triangles, 180 / 48 degrees at most, of the cap's.
        const double cap = (1 - 1 / distance) / 2, row = glm::radians(180.0 / 48);
        EXPECT_NEAR(area / whole, cap, row * std::sqrt(1 - 1 / (distance * distance)) / 2) << distance;
    }
}

TEST_F(FrontTrianglesTest, DrawTheSamePicturesAsAllTriangles) {
    const gl::Program program("position.vert", "triangle_id.frag");
    const gl::Texture2D ids(GL_R32UI, ivec2(kSide), "ids"), depth(GL_DEPTH24_STENCIL8, ivec2(kSide), "depth");
    const gl::Framebuffer framebuffer(&ids, &depth, "ids");
    const scene::Mesh torus = scene::makeTorus(1, 0.3, {96, 48});
    const gl::MeshBuffers all(torus);
    const auto count = static_cast<std::uint32_t>(torus.triangles.size());
    std::mt19937 random(2);
    std::size_t drawn = 0, leftOut = 0;
    for (int i = 0; i < 60; ++i) {
        Look look = randomLook(random, i % 3 == 0);
        const bool mirrored = i % 2 == 0; // then the fronts are clockwise in the picture
        if (mirrored) look.clipFromMesh = glm::scale(look.clipFromMesh, dvec3(-1, 1, 1));
        const gl::FrontTriangles fronts(torus, all, gl::viewerMesh(look.clipFromMesh));
        leftOut += count - gl::frontTriangles(torus, fronts.viewerMesh()).size();
        const auto picture = [&](const auto& triangles) {
            gl::setBaselineState();
            glViewport(0, 0, kSide, kSide);
            framebuffer.bind();
            const GLuint none[4] = {~0u, 0, 0, 0};
            glClearBufferuiv(GL_COLOR, 0, none);
            glClear(GL_DEPTH_BUFFER_BIT);
            glEnable(GL_CULL_FACE);
            glCullFace(mirrored ? GL_FRONT : GL_BACK);
            program.use();
            program.set("clipFromMesh", mat4(look.clipFromMesh));
            program.set("triangleBase", 0);
            triangles.drawNumbered(0, count / 3); // runs of the mesh, as its parts are
            triangles.drawNumbered(count / 3, count - count / 3);
            std::vector<std::uint32_t> pixels(kSide * kSide);
            glReadPixels(0, 0, kSide, kSide, GL_RED_INTEGER, GL_UNSIGNED_INT, pixels.data());
            return pixels;
        };
        const std::vector<std::uint32_t> expected = picture(all);
        EXPECT_EQ(picture(fronts), expected) << i;
        drawn += expected.size() - static_cast<std::size_t>(std::ranges::count(expected, ~0u));
    }
    EXPECT_GT(drawn, 60u * kSide * kSide / 8);
    EXPECT_GT(leftOut, 60u * count * 2 / 5); // nearly half, and more from near
}

} // namespace
} // namespace shadowlab
