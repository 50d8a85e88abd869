// Soft shadows by samples: unbiased, and with errors that fall as they must, in penumbrae that are known in closed form.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/ray_tracing/sampling/light_shares.h"
#include "tests/ray_tracing/tree_of.h"
#include "tests/support/area_lights.h"
#include "tests/support/half_plane.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::TracedScene;
using Spread = SamplePattern::Spread;

/// The half plane x < 0 at a height of 2 over a floor, under a light at a height of 4.
scene::Scene halfPlaneUnder(const scene::Light& light) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({8, 16}), testing::translation({-4, 2, 0}));
    scene.lights.push_back(light);
    return scene;
}

struct Floor {
    const TracedScene& traced;
    [[nodiscard]] trace::SurfacePoint at(double x) const {
        return traced.tracer().nextPoint(traced.centred({x, 1, 0}), trace::kNoPrimitive, dvec3(0, -1, 0));
    }
    /// E / (pi L), by the rays of a pixel's trees.
    [[nodiscard]] double irradiance(double x, const SamplePattern& pattern, ivec2 pixel) const {
        TreeSettings settings;
        settings.areaLights = AreaLights::sampled;
        double sum = 0;
        RayTree tree;
        for (int i = 0; i < pattern.count; ++i) {
            const SampleNumbers numbers(pattern, pixel, static_cast<std::uint32_t>(i));
            tree.trace({traced.surfaces(), trace::MovingScene(traced.tracer()), 0, &numbers}, settings,
                       traced.centred({x, 1, 0}), {0, -1, 0}, at(x), {});
            sum += tree.lightsOf(tree.root())[0].intensity.x;
        }
        const double radiance = traced.surfaces().scene().lights[0].intensity, diffuse = 0.8f; // of the floor
        return sum / pattern.count / radiance / diffuse;
    }
    [[nodiscard]] double exactIrradiance(double x) const {
        const trace::AreaVisibility area(traced.tracer(), 0);
        const trace::SurfacePoint point = at(x);
        const dvec3 up(0, 1, 0);
        trace::AreaIrradiance found;
        area.irradiances({&point, 1}, {&up, 1}, {&found, 1});
        return found.irradiance;
    }
    [[nodiscard]] double share(double x, const SamplePattern& pattern, ivec2 pixel) const {
        const trace::MovingScene atRest(traced.tracer());
        return sampledShare({traced.surfaces(), atRest}, at(x), {0, 1, 0}, 0, pattern, pixel);
    }
};

const double kPlaces[] = {-0.375, -0.25, -0.125, 0, 0.125, 0.25, 0.375};
constexpr double kFormFactors[] = {.002270713415, .004689270598, .007201447076, .009744382526,
                                   .0122508382,   .01465417515,  .01689331114};

TEST(SoftLight, SamplesAreUnbiased) {
    int compared = 0;
    double largest = 0;
    for (const scene::Light& light : {testing::squareLight({0, 4, 0}), testing::sphereLight({0, 4, 0}, 0.5)}) {
        const TracedScene traced(halfPlaneUnder(light));
        const Floor floor{traced};
        for (const Spread spread : {Spread::random, Spread::jittered, Spread::lowDiscrepancy})
            for (std::size_t place = 0; place < std::size(kPlaces); ++place) {
                const double exact = floor.exactIrradiance(kPlaces[place]);
                if (light.type == scene::LightType::rect) {
                    EXPECT_NEAR(exact, kFormFactors[place], 1e-11); // of 10 digits
                }
                constexpr int kSeeds = 64;
                double sum = 0, squares = 0;
                for (int seed = 0; seed < kSeeds; ++seed) {
                    const double found = floor.irradiance(kPlaces[place], {16, spread, 1, seed}, {3, 5});
                    sum += found, squares += found * found;
                }
                const double mean = sum / kSeeds;
                const double deviation = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
                const double z = (mean - exact) / deviation;
                EXPECT_LT(std::abs(z), 3) << kPlaces[place];
                largest = std::max(largest, std::abs(z));
                ++compared;
            }
    }
    EXPECT_EQ(compared, 42);
    EXPECT_GT(largest, 1); // chance was there
    // The classical fault counts every place of the light alike. It is off by 0.0076 of the light here, which 64 x 16 samples do
    // not show, but 64 x 1024 do.
    const TracedScene traced(halfPlaneUnder(testing::squareLight({0, 4, 0})));
    double share = 0;
    for (int seed = 0; seed < 64; ++seed)
        share += Floor{traced}.share(0.25, {1024, Spread::jittered, 1, seed}, {3, 5}) / 64;
    EXPECT_NEAR(share, 0.75, 0.001);                                 // of area, as the stage `visibility` says
    EXPECT_GT(std::abs(share - .01465417515 / .01934344575), 0.006); // of irradiance, as the picture has it
}

TEST(SoftLight, ErrorsFallAsTheyMust) {
    const std::vector<int> counts{4, 16, 64, 256};
    for (const scene::Light& light : {testing::squareLight({0, 4, 0}), testing::sphereLight({0, 4, 0}, 0.5)}) {
        const TracedScene traced(halfPlaneUnder(light));
        const Floor floor{traced};
        // Nowhere does the edge's shadow on the light fall on the border of cells: there jittering makes no error at all.
        constexpr double kBetween[] = {-0.37, -0.21, -0.09, 0.03, 0.17, 0.29, 0.41};
        std::vector<double> exact;
        for (const double place : kBetween)
            exact.push_back(floor.exactIrradiance(place));
        const auto rms = [&](int count, Spread spread) {
            double squares = 0;
            constexpr int pixels = 700; // they know a root mean square to 2.7 %, a slope over four of them to 0.02
            for (int pixel = 0; pixel < pixels; ++pixel) {
                const std::size_t place = static_cast<std::size_t>(pixel) % std::size(kBetween);
                squares +=
                    std::pow(floor.irradiance(kBetween[place], {count, spread, 1, 2}, {pixel, 0}) - exact[place], 2);
            }
            return std::sqrt(squares / pixels);
        };
        std::vector<double> random, jittered;
        for (const int count : counts) {
            random.push_back(rms(count, Spread::random));
            jittered.push_back(rms(count, Spread::jittered));
            EXPECT_LT(jittered.back(), random.back());
        }
        EXPECT_NEAR(testing::logSlope(counts, random), -0.5, 0.05);
        EXPECT_NEAR(testing::logSlope(counts, jittered), -0.75, 0.07);
    }
}

TEST(SoftLight, UmbraAndFullLightAreExactWithAnyNumberOfSamples) {
    const TracedScene traced(halfPlaneUnder(testing::squareLight({0, 4, 0})));
    const Floor floor{traced};
    for (const int count : {2, 4, 9, 100})
        for (const double beyond : {0.5001, 0.7, 2.0}) {
            EXPECT_EQ(floor.share(-beyond, {count, Spread::jittered, 1, 0}, {1, 1}), 0);
            EXPECT_EQ(floor.share(beyond, {count, Spread::jittered, 1, 0}, {1, 1}), 1);
        }
}

} // namespace
} // namespace shadowlab::ray_tracing
