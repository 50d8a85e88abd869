// The alias-free shadow map against closed forms, against a map that asks a regular grid, and what it says about itself.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/shadow_map/irregular/alias_free.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

using namespace shadowlab::testing;
using trace::SceneTracer;
using trace::SurfacePoint;
using trace::Visibility;

SceneTracer tracerOf(scene::Scene scene) {
    SceneTracer tracer;
    tracer.advance(snapshot(std::move(scene)), std::chrono::steady_clock::time_point::max());
    return tracer;
}

std::vector<SurfacePoint> seenBy(const SceneTracer& tracer, ivec2 size) {
    const trace::EyeRays rays = tracer.eyeRays(tracer.scene().camera, size);
    std::vector<SurfacePoint> points(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    tracer.eyePoints(rays, {0, 0}, size, dvec2(0.5), points);
    return points;
}

/// Points all over the floor, which is the first object, seen from above.
std::vector<SurfacePoint> onFloor(const SceneTracer& tracer, int count) {
    Random random(7);
    std::vector<SurfacePoint> points;
    const std::uint32_t triangles = tracer.world().firstOfObject[1];
    for (int i = 0; i < count; ++i) {
        dvec2 weights(number(random, 0, 1), number(random, 0, 1));
        if (weights.x + weights.y > 1) weights = 1.0 - weights;
        const auto primitive = static_cast<std::uint32_t>(random() % triangles);
        const trace::Triangle& t = tracer.world().triangles[primitive];
        points.push_back({primitive, glm::cross(t.b - t.a, t.c - t.a).y > 0, weights});
    }
    return points;
}

/// A square of that half side, level, above the floor; the shadow's middle and half side by the intercept theorem.
void expectSquare(scene::Light light, double halfSide, double height, dvec2 middle, double half) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeQuad(dvec2(2 * halfSide)), translation({0, height, 0}));
    scene.lights = {std::move(light)};
    const SceneTracer tracer = tracerOf(std::move(scene));
    const std::vector<SurfacePoint> points = onFloor(tracer, 200'000);
    std::vector<Visibility> answers(points.size());
    aliasFreeVisibilities(tracer, points, 0, answers);
    long shadowed = 0, lit = 0, wrong = 0, onBorder = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const dvec3 at = tracer.positionWorld(points[i]);
        const double beyond = std::max(std::abs(at.x - middle.x), std::abs(at.z - middle.y)) - half;
        if (std::abs(beyond) < 1e-9) { // the closed form's own rounding
            ++onBorder;
            continue;
        }
        ++(beyond < 0 ? shadowed : lit);
        wrong += answers[i] != (beyond < 0 ? Visibility::shadowed : Visibility::lit);
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(shadowed, 1500);
    EXPECT_GT(lit, 100'000);
    EXPECT_LT(onBorder, 10);
}

TEST(AliasFreeShapes, ShadowOfASquareParallelToTheFloor) {
    // The light 4 above the floor, the square at 1: larger by 4/3, and moved away from the light's foot by a third of it.
    expectSquare(pointLight({0.3, 4, -0.2}), 0.5, 1, {-0.1, 0.2 / 3}, 2.0 / 3);
    // The square at 3: larger by 4.
    expectSquare(pointLight({0.3, 4, -0.2}), 0.25, 3, {-0.9, 0.6}, 1);
    // The sun leaves its size, and moves it.
    expectSquare(directionalLight({1, -2, 0.5}), 0.75, 2, {1, 0.5}, 0.75);
}

/// The classical map, as far as it matters here: light depths at the middles of a regular grid in the light's plane, each of
/// which speaks for all that lies in its cell. Of the sun.
class RegularMap {
public:
    RegularMap(const SceneTracer& tracer, const LightPlane& plane, const PlaneRect& rect, int side)
        : plane_(plane), rect_(rect), side_(side) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const dvec2 place = rect.lower + (rect.upper - rect.lower) * (dvec2(x, y) + 0.5) / double(side);
                trace::Ray ray; // from beyond the scene, the way the light goes
                ray.originCentred = plane.positionCentred(dvec3(place, kBeyond));
                ray.directionCentred = -glm::transpose(plane.planeFromCentred)[2];
                const trace::RayHit hit =
                    tracer.bvh().closest(ray, [&](std::uint32_t p) { return tracer.blockers(0)[p] != 0; });
                nearness_.push_back(hit ? kBeyond - hit.t : -kBeyond);
            }
    }
    [[nodiscard]] bool isShadowed(const dvec3& positionCentred) const {
        const dvec3 place = plane_.place(positionCentred);
        const ivec2 cell = glm::clamp(ivec2((dvec2(place) - rect_.lower) / (rect_.upper - rect_.lower) * double(side_)),
                                      ivec2(0), ivec2(side_ - 1));
        constexpr double kBias = 0.2; // ample: this test is not about acne
        return nearness_[static_cast<std::size_t>(cell.y * side_ + cell.x)] > place.z + kBias;
    }

private:
    static constexpr double kBeyond = 1000;
    LightPlane plane_;
    PlaneRect rect_;
    int side_;
    std::vector<double> nearness_;
};

// Wires a millimetre thick, over a map of as many cells as there are buckets: most run between the middles of its cells.
TEST(AliasFreeShapes, ThinCastersThatARegularGridMisses) {
    scene::Scene scene = floorScene();
    constexpr int kWires = 60;
    std::vector<dvec3> corners;
    for (int i = 0; i < kWires; ++i) {
        const double x = -3 + 6.0 * i / kWires, thick = 0.001;
        corners.insert(corners.end(), {{x, 1.5, -4}, {x + thick, 1.5, -4}, {x + 0.03, 1.5, 4}});
    }
    addObject(scene, triangleSoup(corners));
    scene.lights = {directionalLight({0.2, -1, 0.1})};
    const SceneTracer tracer = tracerOf(std::move(scene));
    std::vector<SurfacePoint> points = onFloor(tracer, 300'000);
    std::vector<Visibility> answers(points.size());
    AliasFreeRecord record;
    aliasFreeVisibilities(tracer, points, 0, answers, &record);
    PlaneRect rect;
    for (const AliasFreeRecord::Bucket& bucket : record.buckets)
        rect.include(bucket.rect);
    const int side = static_cast<int>(std::lround(std::sqrt(double(record.buckets.size()))));
    const RegularMap regular(tracer, record.planes[0], rect, side);
    long shadowed = 0, different = 0, regularMissed = 0, regularInvented = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Visibility truth = tracer.visibility(points[i], 0);
        different += answers[i] != truth;
        shadowed += truth == Visibility::shadowed;
        const bool dark = regular.isShadowed(tracer.positionCentred(points[i]));
        regularMissed += truth == Visibility::shadowed && !dark;
        regularInvented += truth == Visibility::lit && dark;
    }
    EXPECT_EQ(different, 0);
    EXPECT_GT(shadowed, 500);
    EXPECT_GT(regularMissed, shadowed * 9 / 10) << "the case would prove nothing";
    EXPECT_GT(regularInvented, 100) << "where it does meet a wire, a whole cell is dark";
}

TEST(AliasFreeShapes, TheRecordCountsWhatWasAsked) {
    scene::Scene scene = simpleScene();
    scene.lights = {pointLight({3, 14, 6}), pointLight({0.2, 1.2, 0.4}), directionalLight({0.3, -1, 0.2})};
    const SceneTracer tracer = tracerOf(std::move(scene));
    const std::vector<SurfacePoint> points = seenBy(tracer, {160, 120});
    for (int light = 0; light < 3; ++light) {
        std::vector<Visibility> answers(points.size());
        AliasFreeRecord record;
        aliasFreeVisibilities(tracer, points, light, answers, &record);
        EXPECT_EQ(record.planes.size(), light == 1 ? 6u : 1u) << "a light amid all looks to all sides";
        std::uint64_t samples = 0, lit = 0, overlaps = 0;
        for (const AliasFreeRecord::Bucket& bucket : record.buckets) {
            EXPECT_LE(bucket.samples, 64u);
            EXPECT_FALSE(bucket.rect.isEmpty());
            samples += bucket.samples;
            lit += bucket.lit;
            overlaps += bucket.triangles;
        }
        EXPECT_EQ(samples, record.samples);
        EXPECT_EQ(overlaps, record.overlaps);
        EXPECT_GT(overlaps, 300u);
        const auto count = [&](Visibility wanted) {
            return static_cast<std::uint64_t>(std::ranges::count(answers, wanted));
        };
        EXPECT_EQ(lit, count(Visibility::lit));
        EXPECT_EQ(samples - lit, count(Visibility::shadowed));
        // Where a bucket is said to lie, there its samples lie, and no others.
        for (const AliasFreeRecord::Bucket& bucket : record.buckets) {
            const LightPlane& plane = record.planes[static_cast<std::size_t>(bucket.plane)];
            const dvec2 slack = 1e-6 * (1.0 + glm::abs(bucket.rect.lower) + glm::abs(bucket.rect.upper)); // of floats
            std::uint32_t within = 0, certainlyWithin = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (answers[i] != Visibility::lit && answers[i] != Visibility::shadowed) continue;
                const dvec3 along = plane.alongAxes(tracer.positionCentred(points[i]));
                if (!plane.parallel && along.z < std::max(std::abs(along.x), std::abs(along.y))) continue;
                const dvec2 place(plane.place(tracer.positionCentred(points[i])));
                const dvec2 inward = glm::min(place - bucket.rect.lower, bucket.rect.upper - place);
                within += inward.x >= -slack.x && inward.y >= -slack.y;
                certainlyWithin += inward.x > slack.x && inward.y > slack.y;
            }
            EXPECT_GE(within, bucket.samples);
            EXPECT_LE(certainlyWithin, bucket.samples);
        }
    }
}

TEST(AliasFreeShapes, PlacesLeadBackToThePoints) {
    const std::vector<LightPlanes> lights = {LightPlanes::one(directionalLight({0.3, -1, 0.2}), {1, 2, 3}, {}),
                                             LightPlanes::one(pointLight({2, 5, 3}), {1, 2, 3}, {1, 2, 1}),
                                             LightPlanes::cube(pointLight({2, 5, 3}), {1, 2, 3})};
    Random random(9);
    int placed = 0;
    for (const LightPlanes& planes : lights)
        for (int i = 0; i < 500; ++i) {
            const dvec3 positionCentred = 10.0 * inCube(random, 1);
            const int index = planes.planeOf(positionCentred);
            if (index < 0) continue; // beside the one plane
            const LightPlane& plane = planes.all()[static_cast<std::size_t>(index)];
            const dvec3 place = plane.place(positionCentred);
            EXPECT_LT(glm::length(plane.positionCentred(place) - positionCentred), 1e-12);
            if (!plane.parallel) {
                EXPECT_GT(place.z, 0);
                EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), planes.all().size() == 6 ? 1 : kWidestPlane);
            }
            ++placed;
        }
    EXPECT_GT(placed, 1100);
    EXPECT_LT(placed, 1500) << "one plane does not see all around";
}

TEST(AliasFreeShapes, SameForAnyNumberOfThreads) {
    scene::Scene scene = simpleScene();
    scene.lights = {pointLight({3, 14, 6}), pointLight({0.2, 1.2, 0.4}), directionalLight({0.3, -1, 0.2})};
    const SceneTracer tracer = tracerOf(std::move(scene));
    const std::vector<SurfacePoint> points = seenBy(tracer, {400, 300});
    for (int light = 0; light < 3; ++light) {
        std::vector<Visibility> alone(points.size()), several(points.size());
        AliasFreeRecord ofOne, ofSeveral;
        aliasFreeVisibilities(tracer, points, light, alone, &ofOne, 1);
        for (const int threads : {2, 3, 7}) {
            aliasFreeVisibilities(tracer, points, light, several, &ofSeveral, threads);
            EXPECT_EQ(alone, several);
            EXPECT_EQ(ofOne.askedExactly, ofSeveral.askedExactly);
            ASSERT_EQ(ofOne.buckets.size(), ofSeveral.buckets.size());
            for (std::size_t b = 0; b < ofOne.buckets.size(); ++b) {
                EXPECT_EQ(ofOne.buckets[b].triangles, ofSeveral.buckets[b].triangles);
                EXPECT_EQ(ofOne.buckets[b].lit, ofSeveral.buckets[b].lit);
                EXPECT_EQ(ofOne.buckets[b].rect.lower, ofSeveral.buckets[b].rect.lower);
            }
        }
    }
}

// What double knows of a triangle goes by the size of the scene, not by how far away the lamp is.
TEST(AliasFreeShapes, AFarLampLeavesFewPairsOpen) {
    scene::Scene scene = simpleScene();
    scene.lights = {pointLight(1000.0 * glm::normalize(dvec3(2, 5, 3)))};
    const SceneTracer tracer = tracerOf(std::move(scene));
    const std::vector<SurfacePoint> points = seenBy(tracer, {400, 300});
    std::vector<Visibility> answers(points.size());
    AliasFreeRecord record;
    aliasFreeVisibilities(tracer, points, 0, answers, &record);
    EXPECT_GT(record.samples, 50'000u);
    EXPECT_LT(record.askedExactly, record.samples / 100);
}

// Where the eye looks closely, the light is asked more: nobody gets a bucket for himself, and none gets very many.
TEST(AliasFreeShapes, BucketsFollowTheEye) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeQuad({2e4, 2e4}));
    scene.camera.positionWorld = {0, 1.7, 0};
    scene.camera.targetWorld = {0, 1.7, -10};
    scene.lights = {directionalLight({0.3, -1, 0.2})};
    const SceneTracer tracer = tracerOf(std::move(scene));
    const std::vector<SurfacePoint> points = seenBy(tracer, {640, 480});
    std::vector<Visibility> answers(points.size());
    AliasFreeRecord record;
    aliasFreeVisibilities(tracer, points, 0, answers, &record);
    ASSERT_GT(record.samples, 100'000u);
    double smallest = 1e30, largest = 0;
    std::size_t full = 0;
    for (const AliasFreeRecord::Bucket& bucket : record.buckets) {
        const dvec2 size = bucket.rect.upper - bucket.rect.lower;
        smallest = std::min(smallest, size.x * size.y);
        largest = std::max(largest, size.x * size.y);
        full += bucket.samples == 64;
    }
    EXPECT_GT(full, record.buckets.size() * 9 / 10);
    EXPECT_GT(largest, 1e6 * smallest) << "square metres, from the horizon to the eye's feet";
}

} // namespace
} // namespace shadowlab::shadow_map
