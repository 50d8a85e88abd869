// The visible share of lights with an area: against closed forms, against rays, and where it is delicate.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/area_visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/area_lights.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using testing::rectLight, testing::sphereLight, testing::surfacePointAt, testing::tracerOf, testing::triangleSoup;

// Shares are sums of products of double; places are known to 1e-7, in which meshes are stored, unless they are powers of two.
constexpr double kRounding = 1e-12, kFloat = 1e-6;

// Pieces behind holes are asked with 1024 rays for the whole light: four standard deviations of as many random ones.
constexpr double kSampled = 4 * 0.5 / 32;

scene::Snapshot with(scene::Scene scene, scene::Light light) {
    scene.lights = {std::move(light)};
    return testing::snapshot(std::move(scene));
}

/// Two triangles, seen from both sides alike.
scene::Mesh sheet(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    return triangleSoup({a, b, c, a, c, d});
}

double shareAt(const scene::Snapshot& snapshot, const dvec3& positionWorld) {
    const SceneTracer tracer = tracerOf(snapshot);
    return AreaVisibility(tracer, 0).share(surfacePointAt(tracer, 0, positionWorld));
}

// A panel of 1 x 1 at height 4, a half-plane x < 0 at half the height: from (x, 0, 0) all of it is seen where its own x is
// larger than -x, so the share is 1/2 + x.
TEST(AreaVisibility, HalfPlaneUnderARect) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, sheet({-64, 2, -64}, {0, 2, -64}, {0, 2, 64}, {-64, 2, 64}));
    const auto snapshot = with(scene, rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}));
    for (const double x : {-0.75, -0.5, -0.375, -0.25, -0.125, 0.0, 0.125, 0.25, 0.375, 0.5, 1.0})
        EXPECT_NEAR(shareAt(snapshot, {x, 0, 0}), std::clamp(0.5 + x, 0.0, 1.0), kRounding) << x;
}

// A square parallel to the panel: from the floor it is a square on the panel, magnified by the ratio of the heights.
TEST(AreaVisibility, SquareParallelToARect) {
    const double light = 4, height = 1.5, half = 0.25, centre = 0.125, magnified = light / height;
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({2 * half, 2 * half}), testing::translation({centre, height, -centre}));
    const auto snapshot = with(scene, rectLight({0, light, 0}, {1, 0, 0}, {0, 0, 1}));
    const SceneTracer tracer = tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    std::mt19937 numbers(1);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    const auto overlap = [&](double middle) {
        const double upper = std::min(0.5, middle + magnified * half),
                     lower = std::max(-0.5, middle - magnified * half);
        return std::max(0.0, upper - lower);
    };
    int partly = 0;
    for (int i = 0; i < 2000; ++i) {
        const SurfacePoint point = surfacePointAt(tracer, 0, {place(numbers), 0, place(numbers)});
        const dvec3 p = tracer.positionWorld(point);
        const double covered = overlap(p.x + magnified * (centre - p.x)) * overlap(p.z + magnified * (-centre - p.z));
        EXPECT_NEAR(area.share(point), 1 - covered, kRounding) << p.x << ' ' << p.z;
        partly += covered > 0 && covered < 1;
    }
    EXPECT_GT(partly, 200);
}

// A ball at height 4, a half-plane with its edge at x = 0 and height 2. The plane through the point and the edge cuts a
// segment off the disc that the point sees; its distance from the disc's middle, in radii, is k.
TEST(AreaVisibility, EdgeBeforeASphere) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, sheet({-64, 2, -64}, {0, 2, -64}, {0, 2, 64}, {-64, 2, 64}));
    const auto snapshot = with(scene, sphereLight({0, 4, 0}, 0.5));
    int partly = 0;
    for (double x = -0.6; x < 0.61; x += 0.05) {
        const double distance = std::hypot(x, 4), sine = 0.5 / distance;
        const dvec3 toLight = dvec3(-x, 4, 0) / distance, toEdge = glm::normalize(dvec3(-x, 2, 0));
        const double s = toLight.x * toEdge.y - toLight.y * toEdge.x; // positive: the middle is seen
        const double k = std::clamp(s / std::sqrt(1 - s * s) * std::sqrt(1 - sine * sine) / sine, -1.0, 1.0);
        const double expected = 1 - (std::acos(k) - k * std::sqrt(1 - k * k)) / M_PI;
        const double found = shareAt(snapshot, {x, 0, 0});
        EXPECT_NEAR(found, expected, kRounding) << x;
        partly += expected > 0 && expected < 1;
    }
    EXPECT_GT(partly, 15);
    // Where the penumbra ends: x = 2 tan(asin(1/4)) to either side.
    EXPECT_EQ(shareAt(snapshot, {-0.517, 0, 0}), 0);
    EXPECT_NEAR(shareAt(snapshot, {0.517, 0, 0}), 1, kRounding);
}

// An eclipse seen from the axis: discs about one middle, so the share is one minus the ratio of their areas. The ball is a
// mesh of 256 segments, whose outline is that polygon.
TEST(AreaVisibility, BallBeforeASphere) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(0.5, 256), testing::translation({0, 5, 0}));
    const auto snapshot = with(scene, sphereLight({0, 8, 0}, 1));
    const double ball = 0.5 * 0.5 / (25 - 0.25), light = 1.0 / (64 - 1); // squares of the tangents
    const double polygon = 256 / (2 * M_PI) * std::sin(2 * M_PI / 256);
    EXPECT_NEAR(shareAt(snapshot, {0, 0, 0}), 1 - polygon * ball / light, 2e-5);
}

TEST(AreaVisibility, NothingBelowTheHorizon) {
    // An upright panel whose middle is 0.25 above the floor: a quarter of it is below. The floor casts no shadow.
    scene::Scene scene = testing::floorScene();
    scene.objects[0].castsShadow = false;
    const scene::Light panel = rectLight({-2, 0.25, 0}, {0, 0, 1}, {0, -1, 0});
    EXPECT_NEAR(shareAt(with(scene, panel), {1, 0, 0.5}), 0.75, kRounding);
    // The same where the floor's other triangle casts: it lies in the plane, and hides nothing above.
    scene.objects[0].castsShadow = true;
    EXPECT_NEAR(shareAt(with(scene, panel), {1, 0, 0.5}), 0.75, kRounding);
    // From behind it nothing is seen, nor where its middle is below the floor, although a part is above.
    EXPECT_EQ(shareAt(with(scene, panel), {-3, 0, 0.5}), 0);
    EXPECT_EQ(shareAt(with(scene, rectLight({-2, -0.25, 0}, {0, 0, 1}, {0, -1, 0})), {1, 0, 0.5}), 0);
    // Half a ball is below the horizon.
    EXPECT_NEAR(shareAt(with(scene, sphereLight({-2, 1e-9, 0}, 0.5)), {1, 0, 0.5}), 0.5, kFloat);
    // Who receives no shadow sees all of it.
    scene.objects[0].receivesShadow = false;
    EXPECT_EQ(shareAt(with(scene, panel), {1, 0, 0.5}), 1);
}

// A wall of height 2 that stands on the floor along x = 0; a panel straight above. At a distance p before it the wall hides of
// the panel, at height 4, what lies at x < -p: what it hides is 1/2 - p. The point at its foot lies in its plane, touches it,
// and is in nobody's shadow.
TEST(AreaVisibility, FootOfAWall) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, sheet({0, 0, -4}, {0, 0, 4}, {0, 2, 4}, {0, 2, -4}));
    const auto snapshot = with(scene, rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}));
    for (const double p : {0.25, 1e-2, 1e-4, 1e-6, 1e-8}) {
        EXPECT_NEAR(shareAt(snapshot, {p, 0, 0.5}), 0.5 + p, 1e-9) << p;
        EXPECT_NEAR(shareAt(snapshot, {-p, 0, 0.5}), 0.5 + p, 1e-9) << p;
    }
    EXPECT_EQ(shareAt(snapshot, {0, 0, 0.5}), 1);
}

TEST(AreaVisibility, ALightInAHoleOfTheCeilingAndABladeThroughIt) {
    // Exactly in the plane of a ceiling that casts: touched, not hidden.
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, sheet({-4, 4, -4}, {4, 4, -4}, {4, 4, 4}, {-4, 4, 4}));
    EXPECT_NEAR(shareAt(with(scene, rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1})), {0.5, 0, 0.25}), 1, kRounding);
    // A blade that comes through the panel from above, to 1/4 below it, at x = 1/8. From (-1, 0, 0) its tip hides what lies
    // between 1/8 and where the line over the tip meets the panel: -1 + 9/8 * 4 / 3.75 = 1/5.
    scene = testing::floorScene();
    testing::addObject(scene, sheet({0.125, 3.75, -4}, {0.125, 3.75, 4}, {0.125, 6, 4}, {0.125, 6, -4}));
    EXPECT_NEAR(shareAt(with(scene, rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1})), {-1, 0, 0.25}), 1 - 0.075, 1e-9);
}

/// Differences between shares and what rays find, over points of all surfaces that see some of the light.
struct Difference {
    int compared = 0, partly = 0;
    double sum = 0, largestSigma = 0;
};

void compareWithRays(const scene::Snapshot& snapshot, int wanted, Difference& difference, double alike = 1e-10) {
    constexpr int kSide = 64;
    const SceneTracer tracer = tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    const EyeRays rays = tracer.eyeRays(snapshot->camera, ivec2(1000));
    std::mt19937 numbers(7);
    std::uniform_real_distribution<double> pixel(0, 1000);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 200 * wanted && static_cast<int>(points.size()) < wanted; ++i) {
        const SurfacePoint point = tracer.eyePoint(rays, {pixel(numbers), pixel(numbers)});
        if (!point || !tracer.facesLight(point, 0) || !tracer.objectOf(point).receivesShadow) continue;
        const double share = area.share(point);
        if (share > 0 && share < 1)
            ++difference.partly;
        else if (i % 8 != 0)
            continue; // mostly points in penumbras
        points.push_back(point);
    }
    // Asked together, so that parting and searching for all at once is judged, too.
    std::vector<AreaShare> shares(points.size());
    area.shares(points, {}, shares);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(shares[i].visible, area.share(points[i]), alike);
        const double sampled = testing::sampledShare(tracer, points[i], 0, kSide), share = shares[i].visible;
        // Random rays would differ by that much; jittered ones stay below. The second: what one ray in a thousand tells.
        const double sigma = std::max(std::sqrt(share * (1 - share)) / kSide, 1e-3);
        difference.largestSigma = std::max(difference.largestSigma, std::abs(sampled - share) / sigma);
        EXPECT_LT(std::abs(sampled - share), 4 * sigma) << share << ' ' << i;
        difference.sum += sampled - share;
        ++difference.compared;
    }
}

TEST(AreaVisibility, RaysAgreeInRandomScenes) {
    for (const bool sphere : {false, true}) {
        Difference difference;
        for (const testing::HardClass hardClass : testing::kHardClasses) {
            for (unsigned number = 0; number < 3; ++number) {
                scene::Scene scene = testing::hardScene(hardClass, number, false);
                const dvec3 centre = scene.lights[0].positionWorld;
                compareWithRays(with(std::move(scene), sphere ? sphereLight(centre, 0.3)
                                                              : rectLight(centre, {0.9, 0.1, 0.2}, {-0.2, 0.1, 0.7})),
                                20, difference);
            }
        }
        std::cout << (sphere ? "sphere" : "rect") << ": " << difference.compared << " points, " << difference.partly
                  << " in penumbras, mean " << difference.sum / difference.compared << ", at most "
                  << difference.largestSigma << " sigma\n";
        EXPECT_GT(difference.partly, 100);
        // Of so many rays in all, the mean is right to 1e-4 at worst.
        EXPECT_LT(std::abs(difference.sum / difference.compared), 1e-3);
    }
}

TEST(AreaVisibility, RaysAgreeAmongClosedMeshes) {
    for (const scene::Light& light :
         {rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5}), sphereLight({2, 4, 2.5}, 0.6), sphereLight({0, 0.2, 1.5}, 0.7)}) { // the last is sunk into the ground and a ball
        Difference difference;
        compareWithRays(with(testing::simpleScene(), light), 60, difference);
        EXPECT_GT(difference.partly, 20);
        std::cout << scene::toText(light.type) << ": " << difference.partly << " in penumbras, at most "
                  << difference.largestSigma << " sigma\n";
    }
}

TEST(AreaVisibility, RaysAgreeThroughHoles) {
    for (const scene::Light& light : {rectLight({1, 5, 2.5}, {1, 0, 0}, {0, 0, 1}), sphereLight({1, 5, 2.5}, 0.6)}) {
        Difference difference;
        compareWithRays(with(testing::perforatedScene(), light), 16, difference, kSampled);
        EXPECT_GT(difference.partly, 8);
    }
}

// A point that moves on its triangle sees as much more or less as was said, at most.
TEST(AreaVisibility, ChangesAsLittleAsItSays) {
    int compared = 0, bounded = 0, changed = 0;
    // The last is sunk into the ground.
    for (const scene::Light& light : {rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5}), sphereLight({2, 4, 2.5}, 0.6), sphereLight({0, 0.2, 1.5}, 0.7)})
        for (const bool soup : {false, true}) {
            const auto snapshot =
                with(soup ? testing::hardScene(testing::HardClass::soup, 3, false) : testing::simpleScene(), light);
            const SceneTracer tracer = tracerOf(snapshot);
            const AreaVisibility area(tracer, 0);
            const EyeRays rays = tracer.eyeRays(snapshot->camera, ivec2(1000));
            std::mt19937 numbers(11);
            std::uniform_real_distribution<double> pixel(0, 1000), step(-1, 1);
            for (int i = 0; i < 4000; ++i) {
                const dvec2 at(pixel(numbers), pixel(numbers));
                const SurfacePoint here = tracer.eyePoint(rays, at);
                const SurfacePoint there = tracer.eyePoint(rays, at + dvec2(step(numbers), step(numbers)));
                if (!here || here.primitive != there.primitive || !tracer.facesLight(here, 0)) continue;
                const double move = glm::length(tracer.positionCentred(here) - tracer.positionCentred(there));
                AreaShare share;
                area.shares({&here, 1}, {&move, 1}, {&share, 1});
                const double after = area.share(there);
                EXPECT_LE(std::abs(after - share.visible), share.change + kRounding) << i << ' ' << move;
                ++compared;
                bounded += share.change < 0.1;
                changed += after != share.visible;
            }
        }
    std::cout << compared << " moves, " << bounded << " with a small bound, " << changed << " with a change\n";
    EXPECT_GT(compared, 5000);
    EXPECT_GT(bounded, compared / 2);
    EXPECT_GT(changed, compared / 10);
}

} // namespace
} // namespace shadowlab::trace
