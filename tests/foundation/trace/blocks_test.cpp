// Blocks of rays against single rays: the same triangle, the same point on it to the last bit, the same answer of every
// light, for every ray; with eight lanes and without.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

struct Counts {
    long points = 0, background = 0, turnedAway = 0, shadowed = 0, lit = 0, different = 0;
};

bool same(const SurfacePoint& a, const SurfacePoint& b) {
    return a.primitive == b.primitive && (!a || (a.eyeOnFront == b.eyeOnFront && a.weights == b.weights));
}

std::vector<const BlockKernels*> allKernels() {
    std::vector<const BlockKernels*> kernels{&kGenericBlockKernels};
    if (const BlockKernels* avx2 = avx2BlockKernels()) kernels.push_back(avx2);
    return kernels;
}

/// Every pixel and every light of a scene.
Counts compare(const scene::Scene& scene, ivec2 size, dvec2 within = dvec2(0.5)) {
    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<SurfacePoint> alone(count), together(count);
    for (std::size_t i = 0; i < count; ++i)
        alone[i] = tracer.eyePoint(rays, dvec2(int(i) % size.x, int(i) / size.x) + within);
    Counts counts;
    for (const BlockKernels* kernels : allKernels()) {
        tracer.useBlockKernels(*kernels);
        tracer.eyePoints(rays, {0, 0}, size, within, together);
        for (std::size_t i = 0; i < count; ++i) {
            counts.different += !same(alone[i], together[i]);
            ++(alone[i] ? counts.points : counts.background);
        }
        for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light)
            // In blocks as a technique asks, and all at once, when a chunk has points from far apart.
            for (const int side : {SceneTracer::kBlock, size.x})
                for (int y = 0; y < size.y; y += side)
                    for (int x = 0; x < size.x; x += side) {
                        std::vector<SurfacePoint> points;
                        for (int j = y; j < std::min(size.y, y + side); ++j)
                            for (int i = x; i < std::min(size.x, x + side); ++i)
                                points.push_back(alone[static_cast<std::size_t>(j * size.x + i)]);
                        std::vector<Visibility> answers(points.size());
                        tracer.visibilities(points, light, answers);
                        for (std::size_t i = 0; i < points.size(); ++i) {
                            const Visibility expected = tracer.visibility(points[i], light);
                            counts.different += answers[i] != expected;
                            counts.turnedAway += expected == Visibility::turnedAway;
                            counts.shadowed += expected == Visibility::shadowed;
                            counts.lit += expected == Visibility::lit;
                        }
                    }
    }
    return counts;
}

void expectSame(const Counts& counts, long leastOfEach, const std::string& what) {
    EXPECT_EQ(counts.different, 0) << what;
    EXPECT_GT(counts.points, leastOfEach) << what;
    EXPECT_GT(counts.shadowed, leastOfEach) << what;
    EXPECT_GT(counts.lit, leastOfEach) << what;
}

Counts& operator+=(Counts& sum, const Counts& more) {
    sum.points += more.points;
    sum.background += more.background;
    sum.turnedAway += more.turnedAway;
    sum.shadowed += more.shadowed;
    sum.lit += more.lit;
    sum.different += more.different;
    return sum;
}

TEST(Blocks, HardScenes) {
    for (const bool directional : {false, true})
        for (const HardClass hardClass : kHardClasses) {
            Counts sum;
            for (int i = 0; i < longRun(40) * 20; ++i)
                sum += compare(hardScene(hardClass, static_cast<unsigned>(i), directional), {61, 45});
            expectSame(sum, hardClass == HardClass::lightInMesh ? 50 : 500,
                       toText(hardClass) + (directional ? ", directional" : ", point"));
        }
}

TEST(Blocks, EveryKindOfLightFarFromTheWorldsOrigin) {
    for (const double offset : {0.0, 1e6}) {
        const scene::Scene scene = everyKindOfLight();
        const scene::Scene there = moved(scene, dvec3(offset, -offset, offset));
        expectSame(compare(there, {101, 75}), 2000, std::to_string(offset));
        expectSame(compare(there, {16, 12}, {0, 0}), 50, "corners of pixels");
    }
}

TEST(Blocks, CamerasOfEveryDirectionAndWidth) {
    Random random(5);
    Counts sum;
    for (int i = 0; i < longRun(50) * 60; ++i) {
        scene::Scene scene = simpleScene();
        scene.camera.positionWorld = onSphere(random) * number(random, 1, 6);
        scene.camera.targetWorld = inCube(random, 0.5);
        scene.camera.upWorld = onSphere(random);
        scene.camera.fovYDegrees = i % 3 == 0 ? 165 : number(random, 5, 120);
        scene.camera.near = i % 4 == 0 ? number(random, 0.5, 4) : 0.05;
        sum += compare(scene, {33, 27});
    }
    scene::Scene scene = simpleScene(); // along the axes, where directions have zeros
    for (const dvec3& at : {dvec3(0, 1, 6), dvec3(6, 1, 0), dvec3(0, 1, -6)}) {
        scene.camera.positionWorld = at;
        scene.camera.targetWorld = {0, 1, 0};
        sum += compare(scene, {31, 31});
    }
    expectSame(sum, 2000, "cameras");
}

// What no float can settle: equal triangles, needles, points, coplanar sheets, details of a micrometre at a kilometre.
TEST(Blocks, MeshesThatFloatCannotSettle) {
    const std::pair<const char*, Triangles> meshes[] = {
        {"degenerate", degenerate(1)}, {"fans", fans(2)},   {"soup", soup(300, 1, 0.5, 3)},
        {"far", farDetails(4)},        {"ball", sphere(4)}, {"ring", torus(0.8, 0.3, 60, 30)}};
    for (const auto& [name, triangles] : meshes) {
        std::vector<dvec3> corners;
        for (const Triangle& t : triangles)
            corners.insert(corners.end(), {t.a, t.b, t.c});
        scene::Scene scene = floorScene();
        addObject(scene, triangleSoup(corners), translation({0, 1, 0}));
        addObject(scene, scene::makeQuad({10, 10})); // the floor again
        scene.lights = {pointLight({1, 5, 2}), directionalLight({0.3, -1, 0.2}), pointLight({0.1, 1.05, 0.2})};
        Counts sum = compare(scene, {61, 45});
        scene.camera.positionWorld = {0.5, 1.3, 1};
        scene.camera.near = 1e-3;
        sum += compare(scene, {61, 45});
        expectSame(sum, 500, name);
    }
    scene::Scene scene = floorScene();
    std::vector<dvec3> corners;
    for (const Triangle& t : soup(200, 1e-4, 1e-4, 6))
        corners.insert(corners.end(), {t.a, t.b, t.c});
    const dvec3 there(1000, -19, 3);
    addObject(scene, triangleSoup(corners), translation(there));
    scene.camera.positionWorld = there + dvec3(1e-4, 1e-4, 3e-4);
    scene.camera.targetWorld = there;
    scene.camera.near = 1e-7;
    scene.lights = {pointLight(there + dvec3(3e-4, 8e-4, 1e-4))};
    expectSame(compare(scene, {61, 45}), 500, "details far away");
}

// What may fall into a hole is decided ray by ray. Behind one sheet, and behind so many that a block has no room for all
// doubts.
TEST(Blocks, ThroughHoles) {
    scene::Scene scene = perforatedScene();
    expectSame(compare(scene, {101, 75}), 2000, "a few");
    for (int i = 0; i < 24; ++i) {
        addObject(scene, withRepeats(scene::makeQuad({4, 4}), vec2(3.5f + 0.1f * static_cast<float>(i))),
                  translation({0, 1.9 + 0.02 * i, 0}));
        perforate(scene, scene.objects.size() - 1, {"#......", ".......", "......."});
    }
    scene.camera.positionWorld = {0.3, 4, 2};
    expectSame(compare(scene, {101, 75}), 2000, "many");
}

TEST(Blocks, NothingToHitAndNoNumbers) {
    scene::Scene empty = floorScene();
    empty.objects.clear();
    const Counts none = compare(empty, {9, 9});
    EXPECT_EQ(none.different, 0);
    EXPECT_GT(none.background, 50);
    scene::Scene broken = simpleScene();
    broken.camera.positionWorld.x = std::numeric_limits<double>::quiet_NaN();
    const Counts noNumber = compare(broken, {9, 9});
    EXPECT_EQ(noNumber.different, 0);
    EXPECT_EQ(noNumber.points, 0);
}

// Told the right triangles, the rays end there; told wrong ones, or none, they are traced.
TEST(Blocks, OfTrianglesThatAreToldTheRaysFindTheirPoints) {
    const scene::Scene scene = simpleScene();
    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    const ivec2 size{83, 61};
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    std::vector<SurfacePoint> traced(83 * 61), told(traced.size());
    tracer.eyePoints(rays, {0, 0}, size, dvec2(0.5), traced);
    std::vector<std::uint32_t> primitives;
    for (std::size_t i = 0; i < traced.size(); ++i) {
        const std::uint32_t wrong = i % 2 ? kNoPrimitive : 0xfffffff0u;
        primitives.push_back(i % 3 ? traced[i].primitive : wrong);
    }
    for (const BlockKernels* kernels : allKernels()) {
        tracer.useBlockKernels(*kernels);
        tracer.eyePointsOn(primitives, rays, {0, 0}, size, dvec2(0.5), told);
        long hits = 0;
        for (std::size_t i = 0; i < traced.size(); ++i) {
            ASSERT_TRUE(same(traced[i], told[i])) << i;
            hits += bool(told[i]);
        }
        EXPECT_GT(hits, 2000);
    }
}

// A triangle that a shadow ray leaves out is missed by nobody as long as others lie behind it. Here each of thousands is the
// only one between its own piece of the floor and the sun, by construction: no other tracer is asked.
TEST(Blocks, EachOfThousandsOfTrianglesBlocksItsOwnRays) {
    constexpr int kSide = 60; // triangles in a row, in cells of 0.1 m; the floor has 12 m
    constexpr double kCell = 0.1;
    scene::Scene scene = floorScene();
    scene::Mesh mesh;
    mesh.positionsMesh.reserve(3 * kSide * kSide);
    const auto corner = [](int i) { return static_cast<float>((i - kSide / 2) * kCell); };
    for (int i = 0; i < kSide * kSide; ++i) {
        const float x = corner(i % kSide), z = corner(i / kSide), half = 0.02f;
        const auto first = static_cast<std::uint32_t>(mesh.positionsMesh.size());
        for (const vec3& position : {vec3(x - half, 1, z - half), vec3(x + half, 1, z - half), vec3(x, 1, z + half)}) {
            mesh.positionsMesh.push_back(position);
            mesh.normalsMesh.emplace_back(0, 1, 0);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    addObject(scene, std::move(mesh));
    // Half a cell aside: what is under a triangle, seen from the eye far above, is never in its shadow's way.
    scene.lights = {directionalLight({kCell / 2, -1, kCell / 2})};
    scene.camera.positionWorld = {0, 5000, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, -1};
    const ivec2 size(960, 960); // 8 pixels a quarter of a cell and more
    scene.camera.fovYDegrees = 2 * glm::degrees(std::atan(3.0 / 5000));
    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    std::vector<SurfacePoint> shadowed, lit;
    for (int i = 0; i < kSide * kSide; ++i) {
        const dvec2 place(corner(i % kSide), corner(i / kSide));
        for (const auto& [points, shift] :
             {std::pair(&shadowed, dvec2(kCell / 2)), std::pair(&lit, dvec2(kCell / 2, 0))}) {
            const dvec2 pixel = (place + shift + 3.0) / 6.0 * dvec2(size);
            if (pixel.x < 1 || pixel.y < 1 || pixel.x > size.x - 1 || pixel.y > size.y - 1) continue;
            points->push_back(tracer.eyePoint(rays, pixel));
            ASSERT_TRUE(points->back());
            ASSERT_EQ(tracer.world().objects[points->back().primitive], 0u) << "the floor";
        }
    }
    EXPECT_GT(shadowed.size(), 3000u);
    for (const auto& [points, wanted] :
         {std::pair(&shadowed, Visibility::shadowed), std::pair(&lit, Visibility::lit)}) {
        for (const SurfacePoint& point : *points)
            ASSERT_EQ(tracer.visibility(point, 0), wanted);
        for (const BlockKernels* kernels : allKernels()) {
            tracer.useBlockKernels(*kernels);
            std::vector<Visibility> answers(points->size());
            tracer.visibilities(*points, 0, answers);
            EXPECT_EQ(std::ranges::count(answers, wanted), static_cast<std::ptrdiff_t>(points->size()));
        }
    }
}

} // namespace
} // namespace shadowlab::trace
