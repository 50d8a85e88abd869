// What the probe says the filters pcss, vsm, esm, evsm and msm read and decide, against the picture: for pixels taken by chance, in
// several scenes. Bounds are computed anew here from the numbers that the probe says were read, each moved by what rounding may
// have done to it on a graphics card; the picture must lie between the least and the greatest.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/probed/map_probe.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/map_margin.h"
#include "tests/support/probed_picture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::ProbedPicture;
using FilterProbeTest = testing::GlTest;

constexpr ivec2 kSize{96, 72};
constexpr int kPixels = 500; ///< of each picture, taken by chance; of the lit ones only some are asked:
constexpr unsigned kLitKept = 10;

// Half a step of the picture's 8 bits, and a little for the sums of shares.
constexpr double kGreyStep = 0.6 / 255;
// Float positions are off by 2^-21 of their distance, and z, from -1 to 1, is twice that in units of the map's range, which here is
// at least a third of the distance: 3e-6.
constexpr double kDepthError = 3e-6;
// Of sums of up to nine numbers twice, and of an interpolation: some ten roundings of 2^-24.
constexpr double kSumError = 10.0 / (1 << 24);

struct Interval {
    double low = 0, high = 1;
    [[nodiscard]] double width() const { return high - low; }
};

/// Cantelli's bound at the corners of a box around the numbers, less the light that bleeds.
Interval cantelli(double x, double mean, double variance, double least, double xError, double varianceError,
                  double reduction) {
    Interval result{1, 0};
    for (const double dx : {-xError, 0.0, xError})
        for (const double dv : {-varianceError, 0.0, varianceError}) {
            const double v = std::max(variance + dv, least), beyond = x + dx - mean;
            const double share = beyond <= 0 ? 1 : v / (v + beyond * beyond);
            const double shown = glm::clamp((share - reduction) / (1 - reduction), 0.0, 1.0);
            result = {std::min(result.low, shown), std::max(result.high, shown)};
        }
    return result;
}

struct Result {
    int compared = 0, tight = 0, between = 0, unclear = 0, dark = 0;
    double largest = 0; ///< deviation of the picture from the probe where the interval is narrow
};

double readOf(const MapProbe::Moments& moments, std::string_view name) {
    for (const auto& [known, value] : moments.read)
        if (known == name) return value;
    ADD_FAILURE() << "nothing is called " << name;
    return 0;
}

Interval allowed(const std::string& filter, const MapProbe::Moments& m, double sumError) {
    constexpr double kReduction = 0.1, kDeviation = 2e-4; // the parameters' defaults
    if (m.read.empty()) return {1, 1};
    const double z = m.depth;
    if (filter == "esm") {
        const double c = 200,
                     exact = std::min(std::exp(readOf(m, "log of the mean of exp(c d)") - c * (z + 1) / 2), 1.0);
        const double error = std::exp(c * (kDepthError + sumError)) - 1;
        return {exact * (1 - error), std::min(exact * (1 + error), 1.0)};
    }
    if (filter == "vsm") {
        const double mean = readOf(m, "mean of d"), square = readOf(m, "mean of d^2");
        return cantelli(z, mean, square - mean * mean, kDeviation * kDeviation, kDepthError + sumError,
                        4 * sumError * std::max(square, mean * mean) +
                            2 * kDepthError * std::sqrt(std::max(square - mean * mean, 0.0)),
                        kReduction);
    }
    if (filter == "evsm") {
        Interval result{1, 1};
        const double c = 40;
        for (const double sign : {1.0, -1.0}) {
            const double x = sign * std::exp(sign * c * z);
            const double mean = readOf(m, sign > 0 ? "mean of exp(c d)" : "mean of -exp(-c d)"),
                         square = readOf(m, sign > 0 ? "mean of exp(c d)^2" : "mean of exp(-c d)^2");
            const double relative = c * (kDepthError + sumError), least = std::pow(kDeviation * c * x, 2);
            const Interval one = cantelli(x, mean, square - mean * mean, least, relative * std::abs(x),
                                          4 * relative * std::max(square, mean * mean), kReduction);
            result = {std::min(result.low, one.low), std::min(result.high, one.high)};
        }
        return result;
    }
    // msm: the weights of three depths that have these moments, by Cramer's rule, over the corners of a box.
    const dvec4 moments(readOf(m, "mean of d"), readOf(m, "mean of d^2"), readOf(m, "mean of d^3"),
                        readOf(m, "mean of d^4"));
    constexpr double kShare = 1e-6;
    Interval result{1, 0};
    for (int corner = 0; corner < 81; ++corner) {
        dvec4 moved = moments;
        for (int i = 0, digits = corner; i < 4; ++i, digits /= 3)
            moved[i] += (digits % 3 - 1) * 0.5 * sumError;
        for (const double dz : {-kDepthError, 0.0, kDepthError}) {
            const double d = z + dz;
            const dvec4 b = glm::mix(moved, dvec4(0, 0.375, 0, 0.375), kShare);
            const dmat3 a(dvec3(1, b.x, b.y), dvec3(b.x, b.y, b.z), dvec3(b.y, b.z, b.w));
            const double whole = glm::determinant(a);
            const dvec3 right(1, d, d * d);
            dvec3 q;
            for (int i = 0; i < 3; ++i) {
                dmat3 replaced = a;
                replaced[i] = right;
                q[i] = glm::determinant(replaced) / whole;
            }
            const double root = std::sqrt(std::max(q.y * q.y - 4 * q.z * q.x, 0.0));
            const double sum = q.y + std::copysign(root, q.y), one = glm::clamp(-0.5 * sum / q.z, -1e6, 1e6),
                         other = -2 * q.x / sum;
            const double nearer = std::min(one, other), farther = std::max(one, other);
            double lit = 1;
            if (d > nearer && d <= farther)
                lit = 1 - (b.y - b.x * (d + farther) + d * farther) / ((nearer - d) * (nearer - farther));
            if (d > farther) lit = (b.y - b.x * (nearer + farther) + nearer * farther) / ((d - nearer) * (d - farther));
            const double shown = glm::clamp((lit / (1 - kShare) - kReduction) / (1 - kReduction), 0.0, 1.0);
            result = {std::min(result.low, shown), std::max(result.high, shown)};
        }
    }
    return result;
}

/// A pixel by chance; none where it is lit and not one of the few such that are kept.
std::optional<ivec2> somePixel(const ProbedPicture& picture, std::mt19937& random) {
    const ivec2 pixel(static_cast<int>(random() % static_cast<unsigned>(kSize.x)),
                      static_cast<int>(random() % static_cast<unsigned>(kSize.y)));
    const bool isKept = random() % kLitKept == 0;
    if (picture.visibility().grey(pixel.x, pixel.y) == 255 && !isKept) return std::nullopt;
    return pixel;
}

/// Does the eye see the same triangle all around the pixel's centre, as far as the rasteriser's grid may move it?
bool isClear(const trace::ExactVisibility& judge, const scene::Scene& scene, ivec2 pixel) {
    const auto middle = judge.eyeHit(scene.camera, dvec2(pixel) + 0.5, kSize);
    for (const dvec2 aside : {dvec2(-1, -1), dvec2(1, -1), dvec2(-1, 1), dvec2(1, 1)}) {
        const auto hit = judge.eyeHit(scene.camera, dvec2(pixel) + 0.5 + aside / 256.0, kSize);
        if (!hit || !middle || hit->object != middle->object || hit->triangle != middle->triangle) return false;
    }
    return true;
}

/// Some scenes of boxes and balls, made by chance, each with a light of another kind.
std::vector<scene::Snapshot> scenes(bool withArea) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<scene::Snapshot> all;
    for (int i = 0; i < 3; ++i) {
        scene::Scene scene = testing::floorScene();
        for (int j = 0; j < 9; ++j) {
            const dvec3 at(4 * share(random) - 2, 0.4 + 1.2 * share(random), 4 * share(random) - 2);
            const double size = 0.3 + 0.5 * share(random);
            if (j % 2 == 0)
                testing::addObject(scene, scene::makeBox(dvec3(size)), testing::translation(at));
            else
                testing::addObject(scene, scene::makeSphere(0.6 * size, 24), testing::translation(at));
        }
        scene::Light light = testing::pointLight({2 + share(random), 5, 3 * share(random)});
        if (withArea && i != 1) {
            light.type = i == 0 ? scene::LightType::rect : scene::LightType::sphere;
            light.edgeUWorld = {0.8, 0, 0};
            light.edgeVWorld = {0, 0, -0.6};
            if (glm::cross(light.edgeUWorld, light.edgeVWorld).y > 0) light.edgeVWorld = -light.edgeVWorld;
            light.radius = 0.4;
        } else if (i == 1) {
            light = testing::directionalLight({0.5, -1, 0.3});
        }
        scene.lights = {light};
        all.push_back(testing::snapshot(std::move(scene)));
    }
    return all;
}

TEST_F(FilterProbeTest, WhatMomentsDecideIsWhatIsDrawn) {
    for (const auto& [filter, settings] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"vsm", {}}, {"vsm", {"moment-format=16f"}}, {"esm", {}}, {"evsm", {}}, {"msm", {}}}) {
        std::mt19937 random(5);
        Result all;
        for (const scene::Snapshot& scene : scenes(false)) {
            const trace::ExactVisibility judge(scene);
            const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(*scene);
            std::vector<std::string> full = settings;
            full.push_back("filter=" + filter);
            full.emplace_back("resolution=150");
            ProbedPicture picture(scene, "shadow-map", full, kSize);
            std::map<int, testing::EdgeTexels> edges;
            for (int i = 0; i < kPixels; ++i) {
                const std::optional<ivec2> chosen = somePixel(picture, random);
                if (!chosen) continue;
                const ivec2 pixel = *chosen;
                const Probe probe = picture.probe(pixel.x, pixel.y);
                if (!probe.decision || !probe.find<MapProbe>() || !probe.find<MapProbe>()->moments || probe.decision->isTurnedAway) continue;
                // A texel at an edge may have been given another surface: all nine around and the next ones are averaged.
                const testing::EdgeTexels& near =
                    edges.try_emplace(probe.find<MapProbe>()->layer, triangles, *probe.find<MapProbe>()).first->second;
                bool isUnclear = !isClear(judge, *scene, pixel);
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx)
                        isUnclear = isUnclear || near(probe.find<MapProbe>()->texel + ivec2(dx, dy));
                if (isUnclear) {
                    ++all.unclear;
                    continue;
                }
                // Halves have 11 bits; both passes round to them, and their squares once more.
                const double sumError = settings.empty() ? kSumError : 4.0 / (1 << 11);
                const Interval range = allowed(filter, *probe.find<MapProbe>()->moments, sumError);
                const double drawn = picture.visibility().grey(pixel.x, pixel.y) / 255.0;
                ++all.compared;
                all.dark += drawn < 0.5;
                all.between += drawn > 0.02 && drawn < 0.98;
                EXPECT_GE(drawn, range.low - kGreyStep) << filter << " " << pixel.x << "," << pixel.y;
                EXPECT_LE(drawn, range.high + kGreyStep) << filter << " " << pixel.x << "," << pixel.y;
                EXPECT_GE(probe.decision->visibility, range.low - 1e-6) << filter;
                EXPECT_LE(probe.decision->visibility, range.high + 1e-6) << filter;
                if (range.width() > 0.02) continue;
                ++all.tight;
                all.largest = std::max(all.largest, std::abs(drawn - probe.decision->visibility));
            }
        }
        std::cout << filter << (settings.empty() ? "" : ", 16f") << ": " << all.compared << " pixels, " << all.dark
                  << " dark, " << all.between << " between; rounding leaves less than 0.02 open for " << all.tight
                  << ", largest deviation there " << all.largest << "; left out at edges " << all.unclear << "\n";
        EXPECT_GT(all.compared, 60);
        EXPECT_GT(all.dark, 10);
        EXPECT_GT(all.between, 2) << "or a plain comparison would do as well";
        if (settings.empty()) {
            EXPECT_GT(all.tight, all.compared * 3 / 4) << filter;
        }
    }
}

// The search and the comparisons that follow from it: where no look is in doubt the kernel is known, and each comparison is as in
// a plain filter.
TEST_F(FilterProbeTest, SoftShadowsAreWhatIsDrawnWhereNothingIsInDoubt) {
    std::mt19937 random(9);
    int compared = 0, certain = 0, soft = 0, dark = 0, blocked = 0, turned = 0;
    double largest = 0;
    for (const scene::Snapshot& scene : scenes(true))
        for (const std::vector<std::string>& settings :
             {std::vector<std::string>{"light-radius=0.1"}, {"light-radius=0.1", "samples=40", "noise=none"}}) {
            const trace::ExactVisibility judge(scene);
            const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(*scene);
            std::vector<std::string> full = settings;
            full.emplace_back("filter=pcss");
            full.emplace_back("resolution=150");
            ProbedPicture picture(scene, "shadow-map", full, kSize);
            std::map<int, testing::EdgeTexels> edges;
            for (int i = 0; i < kPixels; ++i) {
                const std::optional<ivec2> chosen = somePixel(picture, random);
                if (!chosen) continue;
                const ivec2 pixel = *chosen;
                const Probe probe = picture.probe(pixel.x, pixel.y);
                if (!probe.decision || !probe.find<MapProbe>() || probe.decision->isTurnedAway) continue;
                if (!isClear(judge, *scene, pixel)) continue;
                ASSERT_TRUE(probe.find<MapProbe>()->search);
                const testing::MapMargin margin(
                    *probe.find<MapProbe>(), edges.try_emplace(probe.find<MapProbe>()->layer, triangles, *probe.find<MapProbe>()).first->second);
                const double drawn = picture.visibility().grey(pixel.x, pixel.y) / 255.0;
                ++compared;
                dark += drawn < 0.5;
                soft += drawn > 0.02 && drawn < 0.98;
                blocked += probe.find<MapProbe>()->search->found > 0;
                const testing::PossibleAnswer looks = margin.of(probe.find<MapProbe>()->search->looks);
                const testing::PossibleAnswer taps = margin.of(probe.find<MapProbe>()->taps);
                if (!looks.isCertain()) {
                    turned += std::abs(drawn - probe.decision->visibility) > kGreyStep;
                    continue; // another look, another mean, another kernel
                }
                // A search that finds nothing makes no comparison, and says lit.
                const double low = probe.find<MapProbe>()->search->found ? taps.low : 1,
                             high = probe.find<MapProbe>()->search->found ? taps.high : 1;
                EXPECT_GE(drawn, low - kGreyStep) << pixel.x << "," << pixel.y;
                EXPECT_LE(drawn, high + kGreyStep) << pixel.x << "," << pixel.y;
                if (!taps.isCertain()) continue;
                ++certain;
                largest = std::max(largest, std::abs(drawn - probe.decision->visibility));
            }
        }
    std::cout << compared << " pixels, " << blocked << " with blockers, " << soft << " in the penumbra, " << dark
              << " dark; " << certain << " without doubt, largest deviation " << largest << "; of those in doubt "
              << turned << " came out otherwise\n";
    EXPECT_GT(compared, 250);
    EXPECT_GT(soft, 20);
    EXPECT_GT(certain, compared / 2);
    EXPECT_LE(largest, kGreyStep);
}

// What penumbra.frag draws is d_r - d_b and w: the probe's numbers, of pixels taken by chance.
TEST_F(FilterProbeTest, TheSearchFindsWhatTheStageShows) {
    std::mt19937 random(3);
    int compared = 0, agree = 0;
    for (const scene::Snapshot& scene : scenes(true)) {
        ProbedPicture distance(scene, "shadow-map", {"filter=pcss", "light-radius=0.1", "resolution=150"}, kSize,
                               "blocker-search");
        ProbedPicture width(scene, "shadow-map", {"filter=pcss", "light-radius=0.1", "resolution=150"}, kSize,
                            "penumbra-width");
        for (int i = 0; i < kPixels; ++i) {
            const std::optional<ivec2> chosen = somePixel(distance, random);
            if (!chosen) continue;
            const ivec2 pixel = *chosen;
            const Probe probe = distance.probe(pixel.x, pixel.y);
            const vec4 drawn = distance.texel(pixel.x, pixel.y), drawnWidth = width.texel(pixel.x, pixel.y);
            if (!probe.find<MapProbe>() || !probe.find<MapProbe>()->search || probe.find<MapProbe>()->search->found == 0 || drawn.g < 0.5f) continue;
            const MapProbe::BlockerSearch& search = *probe.find<MapProbe>()->search;
            ++compared;
            // Differences of distances of some metres: 2^-21 of these; and one look in 16 that falls the other way moves the mean.
            agree += std::abs(static_cast<double>(drawn.r) - (search.receiverMetres - search.blockerMetres)) < 1e-4 &&
                     std::abs(static_cast<double>(drawnWidth.r) - search.penumbraMetres) < 1e-4;
        }
    }
    std::cout << agree << " of " << compared << " searches agree with the stages\n";
    EXPECT_GT(compared, 40);
    EXPECT_GE(agree, compared * 95 / 100) << "a look in doubt changes the mean: seldom";
}

} // namespace
} // namespace shadowlab
