// Percentage-closer soft shadows held against penumbrae that are known in closed form: a straight edge over a plane, under a
// square, a ball and the sun.
//   M16 width of the penumbra  ASquareLight, AtAnyHeight: within 5 % of the true one
//                              naive: pcf, whose kernel knows no heights: AFixedKernelHasOneWidth
//       a blocker that slants  ASlantingBlockerIsTakenForANearerOne: the method's limit
//       too narrow a kernel    WhatIsWiderThanTheWidestKernelIsCutOff; naive: widest=0.05
// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>

#include <glm/gtc/constants.hpp>

#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using PcssTest = testing::GlTest;
using Visibility = std::function<double(double x)>; ///< along the floor, the edge being above x = 0

constexpr double kLightHeight = 4;
constexpr double kPixelsPerMetre = 40;
constexpr ivec2 kSize{160, 24};

/// Four metres of the floor, x from -2 to 2, under a blocker over x < 0 whose edge is straight and `height` above the floor;
/// to the left it rises by `slant`. The sun needs a large one. From a lamp it is the same picture at all heights, so the maps
/// are alike.
scene::Scene edgeOverFloor(const scene::Light& light, double height, double slant = 0) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(light);
    const double far = light.type == scene::LightType::directional ? 3 : kLightHeight - height;
    const dvec3 a(0, height, -far), b(0, height, far), up(-far, slant * far, 0);
    testing::addObject(scene, testing::triangleSoup({a, b, b + up, a, b + up, a + up}));
    scene.camera = testing::PlaneView{{0, 0}, kPixelsPerMetre, kSize}.camera();
    return scene;
}

/// One metre by one, shining down.
scene::Light squareLight() {
    scene::Light light = testing::pointLight({0, kLightHeight, 0});
    light.type = scene::LightType::rect;
    return light;
}

scene::Light ball(double radius) {
    scene::Light light = testing::pointLight({0, kLightHeight, 0});
    light.type = scene::LightType::sphere;
    light.radius = radius;
    return light;
}

/// The share of the square beyond the edge: the ray from x through the edge at that height meets the lamp at x'.
Visibility underSquare(double height) {
    return [=](double x) { return glm::clamp(0.5 + x * (kLightHeight - height) / height, 0.0, 1.0); };
}

/// The share of a disc beyond a straight line at `u` from its middle, in radii.
double discBeyond(double u) {
    u = glm::clamp(u, -1.0, 1.0);
    return 0.5 + (u * std::sqrt(1 - u * u) + std::asin(u)) / glm::pi<double>();
}

/// The sun straight above: a disc of that half width at a distance of one metre.
Visibility underSun(double radius, double height) {
    return [=](double x) { return discBeyond(x / (radius * height)); };
}

/// The irradiance of a ball that an edge along z covers in part, of what it would be without. Lambert's integral around what is
/// seen of the ball's cap of directions: an arc of its rim, and an arc in the plane of point and edge.
Visibility underBall(double radius, double height) {
    return [=](double x) {
        const dvec3 normal(0, 1, 0), offset(-x, kLightHeight, 0), a = glm::normalize(offset);
        const double sine = radius / glm::length(offset), cosine = std::sqrt(1 - sine * sine);
        const dvec3 m = glm::normalize(dvec3(height, x, 0)); // of that plane, toward what is seen
        const double s = glm::dot(m, a);
        if (std::abs(s) >= sine) return s > 0 ? 1.0 : 0.0;
        const dvec3 u = glm::normalize(m - s * a), v = glm::cross(a, u);
        const double phi = std::acos(glm::clamp(-cosine * s / (sine * std::sqrt(1 - s * s)), -1.0, 1.0));
        const auto rim = [&](double angle) { return cosine * a + sine * (std::cos(angle) * u + std::sin(angle) * v); };
        const dvec3 first = rim(phi), last = rim(-phi), across = glm::cross(first, last);
        const double arc = std::atan2(glm::length(across), glm::dot(first, last));
        const dvec3 sum =
            2 * phi * sine * sine * a - 2 * sine * cosine * std::sin(phi) * u + arc * glm::normalize(across);
        return glm::dot(normal, sum) / (2 * glm::pi<double>()) / (sine * sine * glm::dot(normal, a));
    };
}

double xOf(int column) { return (column + 0.5 - 0.5 * kSize.x) / kPixelsPerMetre; }

// The closed form of the ball against numbers that were found by other means.
TEST(PcssTruth, ABallBehindAnEdge) {
    const Visibility ball = underBall(0.5, 2);
    for (const auto& [x, visible] :
         {std::pair{-0.5, 0.0030578889}, {-0.3, 0.14523928}, {0.1, 0.626629}, {0.3, 0.85476072}})
        EXPECT_NEAR(ball(x), visible, 1e-6);
    EXPECT_EQ(ball(-0.517), 0);
    EXPECT_EQ(ball(0.517), 1);
}

/// Of the straight line through what is between a fifth and four fifths lit (least squares), the way from 0 to 1. Of a square's
/// penumbra that is the width itself; a disc's is a curve that is nearly straight there.
double penumbraWidth(const std::vector<double>& visibility) {
    double n = 0, sumX = 0, sumV = 0, sumXX = 0, sumXV = 0;
    for (int column = 0; column < kSize.x; ++column) {
        const double x = xOf(column), v = visibility[static_cast<std::size_t>(column)];
        if (v < 0.2 || v > 0.8) continue;
        n += 1, sumX += x, sumV += v, sumXX += x * x, sumXV += x * v;
    }
    EXPECT_GE(n, 6) << "too narrow to be measured";
    return (n * sumXX - sumX * sumX) / (n * sumXV - sumX * sumV);
}

struct Penumbra {
    double width = 0; ///< of the true one: 1 is right
    double rmse = 0;  ///< of single pixels, |x| < 1
    int lit = 0, dark = 0, between = 0;
};
std::ostream& operator<<(std::ostream& stream, const Penumbra& p) {
    return stream << "width " << p.width << " of the true one, RMSE " << p.rmse << " (" << p.lit << " px lit, "
                  << p.dark << " dark, " << p.between << " between)";
}

Penumbra measure(const scene::Scene& scene, const Visibility& truth, const std::vector<std::string>& settings) {
    const judge::Grid<float> image = testing::ShadowMapSlot(testing::snapshot(scene)).shares(settings, kSize, 0);
    std::vector<double> means, truths;
    Penumbra result;
    double squares = 0;
    int compared = 0;
    for (int column = 0; column < kSize.x; ++column) {
        const double x = xOf(column), right = truth(x);
        double sum = 0;
        for (int row = 0; row < kSize.y; ++row) {
            const double v = image.at(column, row);
            sum += v;
            result.lit += v == 1, result.dark += v == 0, result.between += v > 0 && v < 1;
            if (std::abs(x) >= 1) continue;
            squares += (v - right) * (v - right);
            ++compared;
        }
        means.push_back(sum / kSize.y);
        truths.push_back(right);
    }
    EXPECT_EQ(compared, 80 * kSize.y);
    result.width = penumbraWidth(means) / penumbraWidth(truths);
    result.rmse = std::sqrt(squares / compared);
    return result;
}

// fit=scene: the map holds the whole floor, so it is known how much of it a kernel is. A lamp's sees tangents from -1.25 to
// 1.25 of it, and with guard bands of a quarter on both sides 5 at most. The widest penumbra here is 3 m on the floor: its
// kernels reach 1.5 m = tangents of 0.375 to each side, a tenth of the map, and up to a half more where the map's camera looks
// aslant. The sun's reach less.
std::vector<std::string> pcss(int resolution, int samples) {
    const std::string n = std::to_string(samples);
    return {"filter=pcss",  "fit=scene",           "widest=0.25", "resolution=" + std::to_string(resolution),
            "samples=" + n, "blocker-samples=" + n};
}

constexpr double kTolerance = 0.05; // of the width: more than noise and texels cost, less than anybody sees
constexpr double kHeights[] = {1, 2, 3};

// M16. RMSE of single pixels. Of points spread over a square all but those in the strip that the edge cuts are counted right:
// about sqrt(n) of n points are near the edge, and wrong by half of themselves at random: 0.5 n^(1/4) / n, 0.022 for 64
// points and 0.008 for 256. (At random altogether it would be 0.5 / sqrt(n), 0.063 and 0.031.)
TEST_F(PcssTest, ASquareLight) {
    for (const int resolution : {512, 1024, 2048})
        for (const int samples : {64, 256}) {
            const Penumbra p = measure(edgeOverFloor(squareLight(), 2), underSquare(2), pcss(resolution, samples));
            std::cout << resolution << " texels, " << samples << " samples: " << p << "\n";
            EXPECT_NEAR(p.width, 1, kTolerance);
            EXPECT_LT(p.rmse, samples == 64 ? 0.022 : 0.008);
            EXPECT_GT(p.lit, 500);
            EXPECT_GT(p.dark, 500);
            EXPECT_GT(p.between, 500);
        }
}

struct Case {
    const char* name;
    scene::Light light;
    std::function<Visibility(double height)> truth;
};

// M16. The penumbra grows with the height of the edge: by height / (4 m - height) under a lamp, in proportion under the sun. Its
// radius is the half width at a distance of one metre. Of the ball PCSS takes the disc that faces the point, which is 3 %
// narrower than what is seen of it here.
TEST_F(PcssTest, AtAnyHeight) {
    const Case cases[] = {
        {"square", squareLight(), underSquare},
        {"ball", ball(0.5), [](double height) { return underBall(0.5, height); }},
        {"sun", testing::directionalLight({0, -1, 0}), [](double height) { return underSun(0.25, height); }}};
    for (const Case& c : cases)
        for (const double height : kHeights) {
            std::vector<std::string> settings = pcss(1024, 256);
            settings.emplace_back("light-radius=0.25"); // of the sun alone: the others have their own size
            const Penumbra p = measure(edgeOverFloor(c.light, height), c.truth(height), settings);
            std::cout << c.name << ", height " << height << ": " << p << "\n";
            EXPECT_NEAR(p.width, 1, kTolerance) << c.name << " " << height;
            // Toward the ends of a wide penumbra the ball's disc is turned away from the edge's plane, by up to 20 degrees.
            EXPECT_LT(p.rmse, 0.02) << c.name << " " << height;
            EXPECT_GT(p.lit, 400);
            EXPECT_GT(p.dark, 400);
            EXPECT_GT(p.between, 200);
        }
}

// The same texels for all heights, and a kernel that would be right for the one in the middle: 15 x 15 of 0.066 m.
TEST_F(PcssTest, AFixedKernelHasOneWidth) {
    std::vector<double> widths; // in metres
    int right = 0;
    for (const double height : kHeights) {
        const double metres = height / (kLightHeight - height);
        const Penumbra p = measure(edgeOverFloor(squareLight(), height), underSquare(height),
                                   {"filter=pcf", "pcf-radius=7", "fit=scene", "resolution=128"});
        std::cout << "pcf, height " << height << ": " << p << "\n";
        widths.push_back(p.width * metres);
        right += std::abs(p.width - 1) <= kTolerance;
    }
    EXPECT_LE(right, 1);
    EXPECT_NEAR(widths[0], widths[1], 0.02 * widths[1]);
    EXPECT_NEAR(widths[2], widths[1], 0.02 * widths[1]);
}

// What is seen of the light past an edge does not depend on where the rest of the blocker is; but the search takes its mean
// distance, which is nearer to the light. So the penumbra comes out too wide.
TEST_F(PcssTest, ASlantingBlockerIsTakenForANearerOne) {
    const auto slanting = [](double slant) {
        const Penumbra p = measure(edgeOverFloor(squareLight(), 2, slant), underSquare(2), pcss(1024, 256));
        std::cout << "rising by " << slant << ": " << p << "\n";
        return p;
    };
    const Penumbra level = slanting(0), little = slanting(0.25), much = slanting(0.5);
    EXPECT_GT(little.rmse, 2 * level.rmse);
    EXPECT_GT(much.rmse, little.rmse);
    EXPECT_GT(much.width, 1 + kTolerance);
}

// At a height of 3 m a kernel has to reach a tenth to a sixth of the map. What may be wider changes nothing; what has to be
// narrower is the same shape, smaller, and so is the penumbra.
TEST_F(PcssTest, WhatIsWiderThanTheWidestKernelIsCutOff) {
    const auto withWidest = [](const char* widest) {
        std::vector<std::string> settings = pcss(1024, 256);
        settings.emplace_back(widest);
        const Penumbra p = measure(edgeOverFloor(squareLight(), 3), underSquare(3), settings);
        std::cout << widest << ": " << p << "\n";
        return p;
    };
    for (const char* enough : {"widest=0.2", "widest=0.4"})
        EXPECT_LT(withWidest(enough).rmse, 0.008);
    const Penumbra cut = withWidest("widest=0.05");
    EXPECT_GT(cut.rmse, 0.1);
    EXPECT_GT(cut.lit + cut.dark, 2000) << "most of the penumbra is lost";
}

} // namespace
} // namespace shadowlab
