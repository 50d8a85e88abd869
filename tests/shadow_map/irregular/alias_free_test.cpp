// The alias-free shadow map against shadow rays: the same answer for every point, of every kind of light, with no point
// excused.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/alias_free.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

using namespace shadowlab::testing;
using trace::SceneTracer;
using trace::SurfacePoint;
using trace::Visibility;

struct Counts {
    long points = 0, background = 0, turnedAway = 0, shadowed = 0, lit = 0, different = 0;
    Counts& operator+=(const Counts& more) {
        points += more.points;
        background += more.background;
        turnedAway += more.turnedAway;
        shadowed += more.shadowed;
        lit += more.lit;
        different += more.different;
        return *this;
    }
};

void expectSame(const Counts& counts, long leastOfEach, const std::string& what) {
    EXPECT_EQ(counts.different, 0) << what;
    EXPECT_GT(counts.shadowed, leastOfEach) << what;
    EXPECT_GT(counts.lit, leastOfEach) << what;
}

std::vector<SurfacePoint> seenBy(const SceneTracer& tracer, ivec2 size) {
    const trace::EyeRays rays = tracer.eyeRays(tracer.scene().camera, size);
    std::vector<SurfacePoint> points(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    tracer.eyePoints(rays, {0, 0}, size, dvec2(0.5), points);
    return points;
}

/// Points all over the triangles, many of them on edges and corners, where others meet; seen from either side.
std::vector<SurfacePoint> scattered(const SceneTracer& tracer, int count, Random& random) {
    std::vector<SurfacePoint> points;
    const std::size_t triangles = tracer.world().triangles.size();
    for (int i = 0; i < count; ++i) {
        SurfacePoint point;
        point.primitive = static_cast<std::uint32_t>(random() % triangles);
        point.eyeOnFront = random() % 2 == 0;
        const double a = number(random, 0, 1), b = number(random, 0, 1) * (1 - a);
        const dvec2 places[] = {{a, b}, {a, b}, {a, 0}, {0, a}, {a, 1 - a}, {0.5, 0.5}, {1, 0}, {0, 0}};
        point.weights = places[random() % std::size(places)];
        points.push_back(point);
    }
    points.emplace_back(); // and one that is none
    return points;
}

Counts compare(const SceneTracer& tracer, std::span<const SurfacePoint> points) {
    Counts counts;
    for (int light = 0; light < static_cast<int>(tracer.scene().lights.size()); ++light) {
        std::vector<Visibility> answers(points.size());
        aliasFreeVisibilities(tracer, points, light, answers);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Visibility expected = tracer.visibility(points[i], light);
            counts.different += answers[i] != expected;
            counts.background += expected == Visibility::noSurface;
            counts.turnedAway += expected == Visibility::turnedAway;
            counts.shadowed += expected == Visibility::shadowed;
            counts.lit += expected == Visibility::lit;
            ++counts.points;
        }
    }
    return counts;
}

/// What the camera sees, and as many points from everywhere.
Counts compare(const scene::Scene& scene, ivec2 size) {
    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    std::vector<SurfacePoint> points = seenBy(tracer, size);
    Counts counts = compare(tracer, points);
    Random random(points.size());
    return counts += compare(tracer, scattered(tracer, size.x * size.y, random));
}

std::vector<dvec3> cornersOf(const Triangles& triangles) {
    std::vector<dvec3> corners;
    for (const trace::Triangle& t : triangles)
        corners.insert(corners.end(), {t.a, t.b, t.c});
    return corners;
}

TEST(AliasFree, SimpleScene) { expectSame(compare(simpleScene(), {320, 240}), 5000, "simple scene"); }

TEST(AliasFree, HardScenes) {
    for (const bool directional : {false, true})
        for (const HardClass hardClass : kHardClasses) {
            Counts sum;
            for (int i = 0; i < longRun(40) * 20; ++i)
                sum += compare(hardScene(hardClass, static_cast<unsigned>(i), directional), {61, 45});
            expectSame(sum, 500, toText(hardClass) + (directional ? ", directional" : ", point"));
        }
}

TEST(AliasFree, EveryKindOfLightFarFromTheWorldsOrigin) {
    for (const double offset : {0.0, 1e6}) {
        scene::Scene scene = everyKindOfLight();
        scene.lights.push_back(directionalLight({1, 0, 0})); // along the floor
        scene.lights.push_back(pointLight({0.2, 0, 0.3}));   // on the floor
        expectSame(compare(moved(scene, dvec3(offset, -offset, offset)), {131, 97}), 5000, std::to_string(offset));
    }
}

TEST(AliasFree, SoupsWithTheLightAmidThem) {
    Random random(11);
    Counts sum;
    for (int i = 0; i < longRun(40) * 12; ++i) {
        scene::Scene scene = floorScene();
        addObject(scene, triangleSoup(cornersOf(soup(400, 1.5, i % 2 ? 0.3 : 1.2, static_cast<unsigned>(i)))),
                  translation({0, 1.5, 0}));
        scene.lights = {pointLight(inCube(random, 1) + dvec3(0, 1.5, 0)), pointLight(10.0 * onSphere(random)),
                        directionalLight(onSphere(random))};
        sum += compare(scene, {91, 67});
    }
    expectSame(sum, 5000, "soups");
}

// What no float can settle: equal triangles, needles, points, coplanar sheets, details of a micrometre at a kilometre.
TEST(AliasFree, MeshesThatFloatCannotSettle) {
    const std::pair<const char*, Triangles> meshes[] = {
        {"degenerate", degenerate(1)}, {"fans", fans(2)},   {"soup", soup(300, 1, 0.5, 3)},
        {"far", farDetails(4)},        {"ball", sphere(4)}, {"ring", torus(0.8, 0.3, 60, 30)}};
    for (const auto& [name, triangles] : meshes) {
        scene::Scene scene = floorScene();
        addObject(scene, triangleSoup(cornersOf(triangles)), translation({0, 1, 0}));
        addObject(scene, scene::makeQuad({10, 10})); // the floor again
        scene.lights = {pointLight({1, 5, 2}), directionalLight({0.3, -1, 0.2}), pointLight({0.1, 1.05, 0.2})};
        expectSame(compare(scene, {91, 67}), 500, name);
    }
}

TEST(AliasFree, ALightInThePlaneOfTriangles) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({1, 1, 1}), translation({0, 0.5, 0}));
    addObject(scene, scene::makeBox({1, 0.25, 1}), translation({1.5, 1.125, 0.25}));
    // In the planes of faces, of an edge, and in a corner; along a face; and a hair's breadth beside each.
    for (const dvec3& at : {dvec3(0.5, 3, 0.25), dvec3(3, 1, 0.25), dvec3(0.5, 4, 0.5), dvec3(0.5, 1, 0.5)})
        for (const double aside : {0.0, 1e-15, 1e-12, 1e-9, 1e-6})
            scene.lights.push_back(pointLight(at + aside * dvec3(1, 2, 3)));
    for (const double aside : {0.0, 1e-15, 1e-12, 1e-9, 1e-6})
        scene.lights.push_back(directionalLight({aside, -1, aside}));
    expectSame(compare(scene, {101, 75}), 5000, "planes");
}

TEST(AliasFree, CastersThatReachBehindTheLight) {
    Random random(3);
    Counts sum;
    for (int i = 0; i < longRun(40) * 30; ++i) {
        scene::Scene scene = floorScene();
        const dvec3 light(number(random, -1, 1), number(random, 0.5, 3), number(random, -1, 1));
        std::vector<dvec3> corners; // large ones that pass the light closely, on all sides
        for (int t = 0; t < 3; ++t) {
            const dvec3 beside = light + std::pow(10.0, number(random, -16, 0)) * onSphere(random);
            const dvec3 along = onSphere(random), across = onSphere(random);
            corners.insert(corners.end(), {beside + 20.0 * along, beside - 30.0 * along, beside + 0.2 * across});
        }
        addObject(scene, triangleSoup(corners));
        addObject(scene, scene::makeSphere(0.4, 16), translation({0.5, 0.5, 0}));
        scene.lights = {pointLight(light)};
        sum += compare(scene, {61, 45});
    }
    expectSame(sum, 5000, "behind the light");
}

// A floor to the horizon: nearly all samples are within a millionth of the plane.
TEST(AliasFree, AFloorToTheHorizon) {
    scene::Scene scene = simpleScene();
    addObject(scene, scene::makeQuad({1e5, 1e5}), translation({0, -0.01, 0}));
    scene.camera.targetWorld = {0, 2.5, 0};
    scene.lights = {pointLight({2, 5, 3}), pointLight({0, 1e6, 1e5}), directionalLight({1, -0.3, 0.2})};
    expectSame(compare(scene, {160, 120}), 2000, "horizon");
}

TEST(AliasFree, ScenesOfEverySize) {
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
        scene::Scene scene = simpleScene();
        dmat4 larger(scale);
        larger[3][3] = 1;
        for (scene::Object& object : scene.objects)
            object.worldFromObject = larger * object.worldFromObject;
        scene.camera.positionWorld *= scale;
        scene.camera.near *= scale;
        scene.lights = {pointLight(scale * dvec3(2, 5, 3)), directionalLight({0.4, -1, 0.3}),
                        pointLight(scale * dvec3(0.4, 1.5, 0.2))};
        expectSame(compare(scene, {131, 97}), 3000, std::to_string(scale));
    }
}

TEST(AliasFree, NothingThere) {
    scene::Scene scene = floorScene();
    scene.lights = {pointLight({0, 3, 0}), directionalLight({0, -1, 0.1})};
    const Counts floorAlone = compare(scene, {40, 30}); // nothing casts a shadow on it
    EXPECT_EQ(floorAlone.different, 0);
    EXPECT_EQ(floorAlone.shadowed, 0);
    EXPECT_GT(floorAlone.lit, 1000);

    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    std::vector<Visibility> answers(100, Visibility::lit);
    aliasFreeVisibilities(tracer, std::vector<SurfacePoint>(100), 0, answers);
    EXPECT_EQ(std::ranges::count(answers, Visibility::noSurface), 100) << "all background";
    aliasFreeVisibilities(tracer, {}, 1, {});

    scene.objects.clear();
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    std::ranges::fill(answers, Visibility::lit);
    aliasFreeVisibilities(tracer, std::vector<SurfacePoint>(100), 0, answers);
    EXPECT_EQ(std::ranges::count(answers, Visibility::noSurface), 100) << "no object at all";
}

// Nothing can be sorted, or cut in two.
TEST(AliasFree, ThousandsOfPointsInOnePlace) {
    SceneTracer tracer;
    scene::Scene scene = simpleScene();
    scene.lights.push_back(directionalLight({0.3, -1, 0.2}));
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    const std::vector<SurfacePoint> seen = seenBy(tracer, {61, 45});
    Counts sum;
    for (std::size_t i = 0; i < seen.size(); i += 40)
        sum += compare(tracer, std::vector<SurfacePoint>(5000, seen[i]));
    expectSame(sum, 20'000, "one place");
}

TEST(AliasFree, APointInTheLightItself) {
    scene::Scene scene = simpleScene();
    SceneTracer tracer;
    tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
    const std::vector<SurfacePoint> points = seenBy(tracer, {61, 45});
    for (std::size_t i = 500; i < points.size(); i += 400) {
        if (!points[i]) continue;
        scene.lights.push_back(pointLight(tracer.positionWorld(points[i])));
    }
    ASSERT_GT(scene.lights.size(), 3u);
    expectSame(compare(scene, {61, 45}), 500, "in the light");
}

} // namespace
} // namespace shadowlab::shadow_map
