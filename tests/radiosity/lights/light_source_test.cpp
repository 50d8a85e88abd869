// What lights send to points and patches with nothing in between, against closed forms and against sums.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/light_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "techniques/radiosity/lights/solid_angle.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "tests/radiosity/lights/lights.h"
#include "tests/radiosity/quasirandom.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kPi = glm::pi<double>();

TEST(SolidAngle, OfASquareAndFromManyPlaces) {
    const Polygon square{{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    // A face of a cube from its middle: a sixth of all; 4 asin(sin^2 a) for the half angles a of a square pyramid.
    EXPECT_NEAR(solidAngle(square, {0, 1, 0}), 4 * kPi / 6, 1e-14);
    EXPECT_NEAR(solidAngle(square, {0, -1, 0}), -4 * kPi / 6, 1e-14);
    const double far = std::atan(1e-6);
    EXPECT_NEAR(solidAngle(square, {0, 1e6, 0}) / (4 * std::asin(std::pow(std::sin(far), 2))), 1, 1e-12);
    EXPECT_NEAR(solidAngle(square, {0.3, 1e-9, 0.2}), 2 * kPi, 1e-7);
    EXPECT_EQ(solidAngle(square, {3, 0, 0.2}), 0);
    // Differences of large coordinates: a product of the corners themselves would leave 4 digits of this.
    const dvec3 eye(300, 400, 500);
    double sum = 0;
    const Polygon small{{0, 0, 1e-3}, {1e-3, 0, 1e-3}, {1e-3, 0, 0}, {0, 0, 0}};
    sum = solidAngle(small, eye);
    EXPECT_NEAR(sum / (1e-6 * 400 / std::pow(glm::length(eye), 3)), 1,
                1e-5); // of a small thing, to its size over distance
    const Polygon half{{0, 0, 1e-3}, {5e-4, 0, 1e-3}, {5e-4, 0, 0}, {0, 0, 0}},
        rest{{5e-4, 0, 1e-3}, {1e-3, 0, 1e-3}, {1e-3, 0, 0}, {5e-4, 0, 0}};
    EXPECT_NEAR((solidAngle(half, eye) + solidAngle(rest, eye)) / sum, 1, 1e-9);
}

TEST(LightSource, PointsAgainstClosedForms) {
    const Room room(squareScene(2), 10);
    const dvec3 up(0, 1, 0), here(0.0);
    ASSERT_EQ(room.patches.size(), 1u);
    const auto at = [&](const scene::Light& light) { return sourceOf(light, room).irradiance(here, up); };
    EXPECT_NEAR(at(pointLight({3, 4, 0})), pointLight({}).intensity * 0.8 / 25, 1e-12);
    EXPECT_NEAR(at(directionalLight({3, -4, 0})), directionalLight({0, -1, 0}).intensity * 0.8, 1e-12);
    EXPECT_EQ(at(directionalLight({3, 4, 0})), 0);
    // dA to a rectangle 1 x 1 a metre above its middle; the printed digits. Shining up, it brings nothing.
    EXPECT_NEAR(at(rectLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 1)), kPi * .239456470461, 1e-11);
    EXPECT_EQ(at(rectLight({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 1)), 0);
    // Perpendicular to it, from its foot line on; what lies below the horizon is cut off.
    EXPECT_NEAR(at(rectLight({-1, 0.5, 0.5}, {0, 1, 0}, {0, 0, 1}, 1)), kPi * .0557341970026, 1e-11);
    EXPECT_NEAR(at(rectLight({-1, 0, 0.5}, {0, 2, 0}, {0, 0, 1}, 1)), kPi * .0557341970026, 1e-11);
    EXPECT_NEAR(at(sphereLight({0, 2, 0}, 1, 1)), kPi * .25, 1e-12);
    EXPECT_NEAR(at(sphereLight({std::sqrt(3.0), 1, 0}, 1, 1)), kPi * .125, 1e-12);
    EXPECT_EQ(at(sphereLight({0, -2, 0}, 1, 1)), 0);
    EXPECT_EQ(at(sphereLight({0, 0.5, 0}, 1, 1)), 0) << "from within a sphere none of it is seen";
}

/// Spheres that the horizon cuts, against a fine sum over the cone of directions.
TEST(LightSource, SpheresThatTheHorizonCuts) {
    const Room room(squareScene(2), 10);
    const dvec3 up(0, 1, 0);
    int compared = 0;
    for (const double distance : {1.05, 1.5, 4.0})
        for (const double height : {-0.99, -0.6, -0.1, 0.0, 0.3, 0.8, 0.99}) {
            const double aside = std::sqrt(distance * distance - height * height);
            const LightSource source = sourceOf(sphereLight({aside, height, 0}, 1, 1), room);
            constexpr int kAcross = 400, kAround = 400;
            double sum = 0;
            for (int i = 0; i < kAcross; ++i)
                for (int j = 0; j < kAround; ++j)
                    sum += source.line(dvec3(0.0), up, (i + 0.5) / kAcross, (j + 0.5) / kAround).weight;
            const double truth = 2 * kPi * sum / (kAcross * kAround); // midpoints, of a function with a kink
            EXPECT_NEAR(source.irradiance(dvec3(0.0), up), truth, 2e-5 * kPi) << distance << ' ' << height;
            ++compared;
        }
    EXPECT_EQ(compared, 21);
    // No jump where the horizon begins to cut it, and where nothing is left.
    const auto at = [&](double height) {
        return sourceOf(sphereLight({1.5, height, 0}, 1, 1), room).irradiance(dvec3(0.0), up);
    };
    EXPECT_NEAR(at(1 - 1e-9) / at(1 + 1e-9), 1, 1e-7);
    EXPECT_NEAR(at(-1 + 1e-9), 0, 1e-7);
}

/// Means over patches against sums over their points, with nothing in between.
TEST(LightSource, MeansOverPatches) {
    scene::Scene scene = squareScene(2);
    addObject(scene, triangleSoup({{1.5, 0.2, 0}, {2.5, -0.1, 0.3}, {2, 1, 0.8}}));
    const Room room(scene, 10);
    ASSERT_EQ(room.patches.size(), 2u);
    int compared = 0, lit = 0, cut = 0;
    for (const scene::Light& light :
         {pointLight({0.4, 1.5, 0.7}), directionalLight({0.3, -1, -0.2}),
          rectLight({0.1, 1.5, 0.2}, {0.6, 0.1, 0}, {0, 0.2, 0.7}, 3), sphereLight({0.3, 1.2, -0.4}, 0.5, 3),
          sphereLight({0.3, 0.2, -1.9}, 0.5, 3), spotLight({0.4, 1.5, 0.7}, {0.3, -1, -0.5}, 60, 20),
          spotLight({0.4, 1.5, 0.7}, {0.3, -1, -0.5}, 60, 0), spotLight({0.4, 9, 0.7}, {0.1, -1, -0.1}, 60, 5)})
        for (const Patch& patch : room.patches) {
            const LightSource source = sourceOf(light, room);
            double sum = 0, weights = 0;
            constexpr int kPoints = 200000;
            for (int i = 0; i < kPoints; ++i) {
                const auto x = quasirandom4(i);
                const Place place = placeIn(patch.polygon, x[0], x[1]);
                sum += place.weight * source.irradiance(place.point, patch.normal);
                weights += place.weight;
            }
            // Sums are right to 1e-4 but where the edge of a cone goes through; of a sphere that the patch's plane cuts, the mean
            // itself is a sum, of 256 points.
            const bool isCut = light.type == scene::LightType::sphere &&
                               std::abs(patch.plane().height(light.positionWorld - room.originWorld)) < light.radius;
            const double mean = source.meanIrradiance(patch);
            const double tolerance = isCut ? 1e-2 : light.type == scene::LightType::spot ? 2e-3 : 2e-4;
            EXPECT_NEAR(mean, sum / weights, tolerance * mean) << compared;
            lit += mean > 1e-3;
            cut += isCut;
            ++compared;
        }
    EXPECT_EQ(compared, 16);
    EXPECT_GT(lit, 12);
    EXPECT_EQ(cut, 2);
}

} // namespace
} // namespace shadowlab::radiosity
