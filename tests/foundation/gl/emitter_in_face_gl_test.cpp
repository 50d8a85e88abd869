// An emitter that lies in a face is seen whole: no pixel of the face within it, for the rasteriser and for rays alike.
// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/support/area_lights.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using EmitterInFaceTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};

/// A ceiling of 4 x 4 m in the plane of a lamp of 1 x 1 m, which shines to `towardWorld`.
scene::Scene ceiling(const dmat4& turn, bool shinesDown) {
    scene::Scene scene;
    scene.materials.emplace_back();
    testing::addObject(scene, scene::makeQuad({4, 4}),
                       turn * glm::rotate(dmat4(1), glm::radians(180.0), dvec3(1, 0, 0)));
    const dvec3 u = transformDirection(turn, dvec3(1, 0, 0)), v = transformDirection(turn, dvec3(0, 0, 1));
    scene.lights = {testing::rectLight(dvec3(turn[3]), shinesDown ? u : v, shinesDown ? v : u)};
    scene::addEmitterSurfaces(scene);
    return scene;
}

/// Eyes below the ceiling: straight up, aslant, at a grazing angle, near and far.
std::vector<dvec3> eyes() {
    return {{0.3, -2, 0.1}, {2, -2, 1},    {0.4, -0.3, 0.2}, {5, -0.4, 3},
            {9, -0.08, 2},  {30, -20, 11}, {0.02, -40, 0.03}};
}

/// By the plane of the lamp alone: does the pixel show a place within it? Nothing within a hundredth of a pixel of its edge.
std::optional<bool> showsLamp(const scene::Scene& scene, const dmat4& turn, int x, int y) {
    const auto within = [&](const dvec2& pixel) {
        const dvec3 direction = scene::rayDirectionWorld(scene.camera, pixel, kSize);
        const dmat4 back = glm::inverse(turn);
        const dvec3 from = transformPoint(back, scene.camera.positionWorld), way = transformDirection(back, direction);
        const dvec3 at = from - from.y / way.y * way;
        return -from.y / way.y > 0 && std::abs(at.x) < 0.5 && std::abs(at.z) < 0.5;
    };
    const dvec2 centre = dvec2(x, y) + 0.5;
    const bool answer = within(centre);
    for (const dvec2& off : {dvec2(0.01, 0), dvec2(-0.01, 0), dvec2(0, 0.01), dvec2(0, -0.01)})
        if (within(centre + off) != answer) return std::nullopt;
    return answer;
}

TEST_F(EmitterInFaceTest, IsSeenWholeFromItsFrontAndNotAtAllFromBehind) {
    const dmat4 aslant = testing::translation({103.3, -7.7, 51.9}) *
                         glm::rotate(glm::rotate(dmat4(1), 0.6, dvec3(1, 0, 0)), 0.4, dvec3(0, 1, 0.3));
    int pictures = 0, whole = 0;
    for (const dmat4& turn : {testing::translation({0, 2.5, 0}), aslant})
        for (const bool shinesDown : {true, false})
            for (const dvec3& eye : eyes()) {
                scene::Scene scene = ceiling(turn, shinesDown);
                scene.camera.positionWorld = transformPoint(turn, eye);
                scene.camera.targetWorld = transformPoint(turn, dvec3(0.05, 0, 0.02));
                scene.camera.fovYDegrees = glm::length(eye) > 20  ? 4
                                           : glm::length(eye) > 8 ? 2
                                                                  : 40; // far ones look through a long lens
                const auto snapshot = testing::snapshot(scene);
                gl::SceneBuffers buffers;
                buffers.update(snapshot);
                gl::IdBuffer idBuffer;
                idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, kSize), kSize);
                const std::vector<std::uint32_t> ids = idBuffer.read();
                const trace::SceneTracer tracer = testing::tracerOf(snapshot);
                const trace::ExactVisibility judge(snapshot);
                const trace::EyeRays rays = tracer.eyeRays(scene.camera, kSize);
                std::vector<trace::SurfacePoint> points(ids.size());
                tracer.eyePoints(rays, {0, 0}, kSize, dvec2(0.5), points);
                int wrongOnCard = 0, wrongRays = 0, wrongJudge = 0, lamp = 0;
                for (int y = 0; y < kSize.y; ++y)
                    for (int x = 0; x < kSize.x; ++x) {
                        const auto expected = showsLamp(scene, turn, x, y);
                        if (!expected) continue;
                        const std::size_t i = static_cast<std::size_t>(y * kSize.x + x);
                        const bool isLamp = *expected && shinesDown;
                        lamp += isLamp;
                        wrongOnCard += (ids[i] == 2 || ids[i] == 3) != isLamp;
                        wrongRays += (points[i].primitive == 2 || points[i].primitive == 3) != isLamp;
                        const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize);
                        wrongJudge += (hit && hit->object == 1) != isLamp;
                    }
                EXPECT_EQ(wrongOnCard, 0) << eye.x << " " << eye.y << (shinesDown ? "" : ", from behind");
                EXPECT_EQ(wrongRays, 0) << eye.x << " " << eye.y << (shinesDown ? "" : ", from behind");
                EXPECT_EQ(wrongJudge, 0) << eye.x << " " << eye.y << (shinesDown ? "" : ", from behind");
                ++pictures;
                whole += lamp > 30;
            }
    EXPECT_EQ(pictures, 28);
    EXPECT_EQ(whole, 14) << "the lamp should be large enough to be seen in every picture from its front";
}

} // namespace
} // namespace shadowlab
