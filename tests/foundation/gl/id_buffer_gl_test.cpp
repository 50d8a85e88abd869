// The rasteriser's triangles against those of the exact judge: the same numbers, but for pixels whose centre an edge
// passes too closely.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/gl/scene/id_buffer.h"

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using IdBufferTest = testing::GlTest;

TEST_F(IdBufferTest, NamesTheTriangleThatTheRaySees) {
    scene::Scene scene = testing::simpleScene();
    dmat4 mirror = testing::translation({-2, 1, 1});
    mirror[0][0] = -1;
    testing::addObject(scene, scene::makeTorus(0.6, 0.2, {24, 12}), mirror).castsShadow = false;
    const auto snapshot = testing::snapshot(scene);
    gl::SceneBuffers buffers;
    buffers.update(snapshot);
    const trace::ExactVisibility judge(snapshot);
    gl::IdBuffer idBuffer;
    for (const ivec2 size : {ivec2(200, 150), ivec2(161, 99)}) { // of odd height, too: a row stays in the middle
        idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, size), size);
        const std::vector<std::uint32_t> ids = idBuffer.read();
        ASSERT_EQ(ids.size(), static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        int surfaces = 0, background = 0, ofMirrored = 0, different = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, size);
                const std::uint32_t expected =
                    hit ? static_cast<std::uint32_t>(buffers.triangleBase(hit->object)) + hit->triangle
                        : gl::IdBuffer::kNone;
                different += ids[static_cast<std::size_t>(y * size.x + x)] != expected;
                hit ? ++surfaces : ++background;
                ofMirrored += hit && hit->object + 1 == scene.objects.size();
            }
        EXPECT_GT(surfaces, 5000);
        EXPECT_GT(background, 1000);
        EXPECT_GT(ofMirrored, 100);
        EXPECT_LT(different, surfaces / 500);
    }
}

// Of so large a mesh a software renderer is given the fronts alone (front_triangles.h): those of the mirrored and stretched object.
TEST_F(IdBufferTest, NamesTheTrianglesOfALargeMirroredMesh) {
    scene::Scene scene = testing::floorScene();
    dmat4 turned = testing::translation({0, 1, 0}) * glm::rotate(dmat4(1), 1.1, dvec3(1, 0.3, 0.2));
    testing::addObject(scene, scene::makeTorus(0.8, 0.3, {80, 40}), turned * glm::scale(dmat4(1), dvec3(-1, 1.4, 1)));
    scene.camera.positionWorld = {0.5, 1.8, 3};
    scene.camera.targetWorld = {0, 1, 0};
    const auto snapshot = testing::snapshot(scene);
    gl::SceneBuffers buffers;
    buffers.update(snapshot);
    const trace::ExactVisibility judge(snapshot);
    const ivec2 size(480, 360);
    gl::IdBuffer idBuffer;
    idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, size), size);
    const std::vector<std::uint32_t> ids = idBuffer.read();
    int ofTorus = 0, different = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, size);
            if (!hit || hit->object + 1 != scene.objects.size()) continue;
            ++ofTorus;
            different += ids[static_cast<std::size_t>(y * size.x + x)] != static_cast<std::uint32_t>(buffers.triangleBase(hit->object)) + hit->triangle;
        }
    EXPECT_GT(ofTorus, 20'000);
    // An edge passes within 1/512 of a pixel of the centre, where the rasteriser moves corners to a grid of 1/256: triangles some five pixels
    // wide have 0.6 pixels of edge for each of area, so 0.23 %; twice that.
    EXPECT_LT(different, ofTorus / 200);
}

// Also inside a closed ball, of which no back face would be seen if it had no holes.
TEST_F(IdBufferTest, SeesThroughHolesAsTheRayDoes) {
    const scene::Scene scene = testing::perforatedScene();
    const auto snapshot = testing::snapshot(scene);
    gl::SceneBuffers buffers;
    buffers.update(snapshot);
    const trace::ExactVisibility judge(snapshot);
    scene::Scene whole = scene;
    for (scene::Object& object : whole.objects)
        object.partMaterials[0] = 0;
    const trace::ExactVisibility wholeJudge(testing::snapshot(whole));
    ASSERT_TRUE(scene.objects[2].mesh->outward);
    const ivec2 size(200, 150);
    gl::IdBuffer idBuffer;
    idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, size), size);
    const std::vector<std::uint32_t> ids = idBuffer.read();
    int surfaces = 0, through = 0, insideOfBall = 0, different = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const dvec2 pixel = dvec2(x, y) + 0.5;
            const auto hit = judge.eyeHit(scene.camera, pixel, size);
            const auto wholeHit = wholeJudge.eyeHit(scene.camera, pixel, size);
            const std::uint32_t expected =
                hit ? static_cast<std::uint32_t>(buffers.triangleBase(hit->object)) + hit->triangle
                    : gl::IdBuffer::kNone;
            different += ids[static_cast<std::size_t>(y * size.x + x)] != expected;
            surfaces += bool(hit);
            const bool passed = wholeHit && (!hit || hit->distance > wholeHit->distance);
            through += passed;
            insideOfBall += passed && hit && hit->object == 2;
        }
    EXPECT_GT(surfaces, 5000);
    EXPECT_GT(through, 2000);
    EXPECT_GT(insideOfBall, 200);
    EXPECT_LT(different, surfaces / 200) << "at borders of holes, too, the rasteriser rounds";
}

} // namespace
} // namespace shadowlab
