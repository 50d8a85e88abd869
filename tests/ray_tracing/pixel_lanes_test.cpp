// Pixels in lanes against the formulas that shade one point at a time (scene/query/shading.h), with every kind of light and by every
// kernel that this processor can run.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/ray_tracing/lanes/pixel_lanes.h"

namespace shadowlab::ray_tracing {
namespace {

std::vector<const LaneKernels*> allKernels() {
    std::vector<const LaneKernels*> kernels{&kGenericLaneKernels};
    if (const LaneKernels* avx2 = avx2LaneKernels()) kernels.push_back(avx2);
    return kernels;
}

struct Point {
    dvec3 positionWorld, normalWorld; ///< the normal unit, on any side
    scene::Material material;
    bool isLit;
    bool mayTurn = true; ///< false: the normal is on the side that is seen, whatever its own sign toward the eye
};

Point randomPoint(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1), axis(-1, 1);
    const auto vector = [&] { return dvec3(axis(random), axis(random), axis(random)); };
    Point point{3.0 * vector(), glm::normalize(vector()), {}, share(random) < 0.8, share(random) < 0.7};
    point.material.diffuse = vec3(share(random), share(random), share(random));
    if (share(random) < 0.5) {
        point.material.specular = vec3(static_cast<float>(share(random)));
        point.material.shininess = static_cast<float>(std::exp(7 * share(random)));
    }
    return point;
}

std::vector<scene::Light> lightsOfAllKinds() {
    scene::Light point, sun, spot, soft, rect;
    point.positionWorld = {0.5, 4.5, 0.3};
    sun.type = scene::LightType::directional;
    sun.directionWorld = glm::normalize(dvec3(0.2, -1, 0.4));
    spot.type = soft.type = scene::LightType::spot;
    spot.positionWorld = soft.positionWorld = {1, 6, 0};
    spot.directionWorld = soft.directionWorld = glm::normalize(dvec3(-0.1, -1, 0.1));
    spot.coneDegrees = soft.coneDegrees = 60;
    soft.edgeDegrees = 12;
    rect.type = scene::LightType::rect;
    rect.positionWorld = {0, 5, 0};
    rect.directionWorld = {0, -1, 0};
    for (scene::Light* light : {&point, &sun, &spot, &soft, &rect}) {
        light->intensity = 20;
        light->color = {1, 0.8f, 0.6f};
    }
    return {point, sun, spot, soft, rect};
}

/// Radiance of one light, in double, with the gate that belongs to visibility.
dvec3 expected(const Point& point, const scene::Light& light, const dvec3& eyeWorld) {
    const dvec3 toEyeWorld = glm::normalize(eyeWorld - point.positionWorld);
    const dvec3 normalWorld = point.mayTurn && glm::dot(point.normalWorld, toEyeWorld) < 0 ? -point.normalWorld : point.normalWorld;
    if (!point.isLit) return dvec3(0.0);
    return scene::irradiance(light, point.positionWorld, normalWorld) *
           scene::reflectance(point.material, normalWorld, scene::towardLightWorld(light, point.positionWorld), toEyeWorld);
}

void fill(PixelLanes& pixels, const std::vector<Point>& points, const dvec3& eyeWorld) {
    pixels.count = points.size();
    pixels.anySpecular = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& point = points[i];
        const vec3 position(point.positionWorld - eyeWorld), normal(2.5 * point.normalWorld); // of any length
        for (int c = 0; c < 3; ++c) {
            pixels.positionEye[c][i] = position[c];
            pixels.normalWorld[c][i] = normal[c];
            pixels.diffuse[c][i] = point.material.diffuse[c];
            pixels.specular[c][i] = point.material.specular[c];
            pixels.radiance[c][i] = 0.125f; // with lights off
        }
        pixels.shininess[i] = point.material.shininess;
        pixels.isLit[i] = point.isLit ? 1.0f : 0.0f;
        pixels.mayTurn[i] = point.mayTurn ? 1.0f : 0.0f;
    }
}

TEST(PixelLanesTest, ShadeAsOnePointAtATimeIsShaded) {
    std::mt19937 random(7);
    const dvec3 eyeWorld(0.4, 2.0, 9.0);
    for (const LaneKernels* kernels : allKernels()) {
        int compared = 0, bright = 0, dark = 0, highlights = 0;
        for (const scene::Light& light : lightsOfAllKinds())
            for (int round = 0; round < 40; ++round) {
                std::vector<Point> points;
                for (std::size_t i = 0; i < kLanes - static_cast<std::size_t>(round % 9); ++i)
                    points.push_back(randomPoint(random));
                PixelLanes pixels{};
                fill(pixels, points, eyeWorld);
                kernels->turnToEye(pixels);
                addLight(*kernels, pixels, laneLight(light, eyeWorld));
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const dvec3 wanted = 0.125 + expected(points[i], light, eyeWorld);
                    const double most = std::max({wanted.r, wanted.g, wanted.b});
                    ++compared;
                    bright += most > 0.126 ? 1 : 0;
                    dark += most == 0.125 ? 1 : 0;
                    highlights += points[i].isLit && points[i].material.specular.r > 0 ? 1 : 0;
                    for (int c = 0; c < 3; ++c)
                        // A twentieth of a level of 255 where a level is narrowest in radiance, and a float's digits: a power of a
                        // thousand multiplies the rounding of its cosine by a thousand.
                        EXPECT_NEAR(pixels.radiance[c][i], wanted[c], 1.5e-5 + 3e-4 * (wanted[c] - 0.125))
                            << kernels->name << ", light " << static_cast<int>(light.type) << ", pixel " << i;
                }
            }
        EXPECT_GE(compared, 11'000) << kernels->name;
        EXPECT_GE(bright, 3'000) << kernels->name;
        EXPECT_GE(dark, 2'000) << kernels->name;
        EXPECT_GE(highlights, 3'000) << kernels->name;
    }
}

// At the light itself there is no direction toward it, and so no number: nothing is added there, nor where a pixel is not lit.
TEST(PixelLanesTest, NothingComesFromALightAtThePointItself) {
    for (const LaneKernels* kernels : allKernels()) {
        scene::Light light;
        light.positionWorld = {1, 2, 3};
        light.intensity = 5;
        std::vector<Point> points(2, Point{light.positionWorld, dvec3(0, 1, 0), {}, true});
        points[1].positionWorld = {1, 1, 3};
        points[1].isLit = false;
        PixelLanes pixels{};
        fill(pixels, points, dvec3(0.0, 5.0, 5.0));
        kernels->turnToEye(pixels);
        addLight(*kernels, pixels, laneLight(light, dvec3(0.0, 5.0, 5.0)));
        EXPECT_EQ(pixels.radiance[0][0], 0.125f) << kernels->name;
        EXPECT_EQ(pixels.radiance[0][1], 0.125f) << kernels->name;
    }
}

// The polynomial is off by a 2800th of a level at most, so that it rounds to another level next to a half alone: one value in a
// thousand here, and then to the next level.
TEST(PixelLanesTest, EncodedAsTheStandardSays) {
    for (const LaneKernels* kernels : allKernels()) {
        int compared = 0, different = 0;
        for (int first = -64; first < 70'000; first += static_cast<int>(kLanes)) {
            PixelLanes pixels{};
            pixels.count = kLanes;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const float value = static_cast<float>(first + static_cast<int>(i)) / 65'535.0f; // below 0 and beyond 1 as well
                pixels.radiance[0][i] = value / 2;
                pixels.radiance[1][i] = (1 - value) / 2;
                pixels.radiance[2][i] = value * value / 2;
            }
            std::vector<image::Color8> colors(kLanes);
            encode(*kernels, pixels, 2, colors);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const image::Color8 wanted =
                    image::encoded(2.0f * vec3(pixels.radiance[0][i], pixels.radiance[1][i], pixels.radiance[2][i]));
                ++compared;
                different += colors[i] == wanted ? 0 : 1;
                EXPECT_EQ(colors[i].a, 255);
                EXPECT_LE(std::abs(colors[i].r - wanted.r), 1);
                EXPECT_LE(std::abs(colors[i].g - wanted.g), 1);
                EXPECT_LE(std::abs(colors[i].b - wanted.b), 1);
            }
        }
        EXPECT_GE(compared, 70'000);
        EXPECT_LE(different, compared / 333) << kernels->name << ": three channels of one in a thousand";
    }
}

} // namespace
} // namespace shadowlab::ray_tracing
