// White furnaces: in a room of even radiance everything has that radiance, whatever chance decides. And rooms that are bright on
// one side only, where the answer is known and chance does decide: its errors are distributed as they must be.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/ray_tracing/sampling/lobe.h"
#include "tests/ray_tracing/tree_of.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::addMaterial;
using testing::addObject;
using testing::TracedScene;

TreeSettings chanceSettings(int depth) {
    TreeSettings settings{.depth = depth};
    settings.gloss = settings.translucency = settings.interreflection = true;
    return settings;
}

/// A tree of a ray, for the given sample.
dvec3 intensity(const TracedScene& traced, const TreeSettings& settings, const dvec3& fromWorld, const dvec3& u,
                const SampleNumbers& numbers) {
    const dvec3 from = traced.centred(fromWorld);
    const trace::SurfacePoint first = traced.tracer().nextPoint(from, trace::kNoPrimitive, u);
    if (!first) return dvec3(traced.surfaces().scene().background);
    RayTree tree;
    tree.trace({traced.surfaces(), trace::MovingScene(traced.tracer()), 0, &numbers}, settings, from, u, first,
               traced.surfaces().mediaAround(from));
    return tree.root().intensity;
}

SampleNumbers sampleOf(int pixel, int i, int count) {
    return {{count, SamplePattern::Spread::random, 1, 11}, {pixel, 0}, static_cast<std::uint32_t>(i)};
}

scene::Scene withBackground(float radiance) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.background = vec3(radiance);
    return scene;
}

TEST(WhiteFurnace, ABallOfAnySurfaceCannotBeSeen) {
    // Mirrors, glass, rough ones of both kinds, and Lambert's reflector, all of which give back what they receive.
    struct Case {
        const char* name;
        double reflectivity, transparency, glossDegrees, translucencyDegrees;
        float diffuse;
    };
    int compared = 0;
    for (const Case& c : {Case{"gloss 5", 1, 0, 5, 0, 0}, Case{"gloss 60", 1, 0, 60, 0, 0},
                          Case{"gloss 90", 1, 0, 90, 0, 0}, Case{"translucency 20", 0, 1, 0, 20, 0},
                          Case{"rough glass", 0.1, 0.9, 15, 40, 0}, Case{"Lambert", 0, 0, 0, 0, 1}}) {
        scene::Scene scene = withBackground(1);
        const std::uint32_t material = addMaterial(scene, c.reflectivity, c.transparency);
        scene.materials[material].glossDegrees = c.glossDegrees;
        scene.materials[material].translucencyDegrees = c.translucencyDegrees;
        scene.materials[material].diffuse = vec3(c.diffuse);
        addObject(scene, scene::makeSphere(1, 32), material, dmat4(1.0));
        const TracedScene traced(scene);
        TreeSettings settings = chanceSettings(12);
        for (int i = 0; i < 300; ++i) {
            const SampleNumbers numbers = sampleOf(i, i, 300);
            const dvec2 at = 1.9 * (numbers.pair(Purpose::pixel) - 0.5); // also at the rim
            if (glm::length(at) > 0.97) continue;
            const dvec3 seen = intensity(traced, settings, {at, 3}, {0, 0, -1}, numbers);
            // Weights add up to 1 at every surface: only rounding is left. A ray deeper than 12 has the background's 1 as well.
            EXPECT_NEAR(seen.x, 1, 1e-12) << c.name << " " << i;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
    // What a lobe loses below the surface is seen: the classical fault.
    scene::Scene scene = withBackground(1);
    const std::uint32_t rough = addMaterial(scene, 1, 0);
    scene.materials[rough].glossDegrees = 60;
    addObject(scene, scene::makeQuad({10, 10}), rough, dmat4(1.0));
    const TracedScene traced(scene);
    TreeSettings cut = chanceSettings(2);
    cut.wholeLobes = false;
    double sum = 0;
    constexpr int kRays = 20000;
    const double tilt = glm::radians(70.0);
    for (int i = 0; i < kRays; ++i)
        sum += intensity(traced, cut, {-std::sin(tilt), std::cos(tilt), 0}, {std::sin(tilt), -std::cos(tilt), 0},
                         sampleOf(0, i, kRays))
                   .x;
    const double left = (1 + std::cos(tilt)) / 2; // of Lambert's lobe, tilted by 70 degrees
    EXPECT_NEAR(sum / kRays, left, 4 * std::sqrt(left * (1 - left) / kRays));
    EXPECT_LT(sum / kRays, 0.75);
}

TEST(WhiteFurnace, ARoomThatShinesAndReflectsHasTheSumOfAllBounces) {
    // Emission E, reflectance rho, down to depth k: E (1 + rho + ... + rho^k), exactly, for every ray is worth the same.
    for (const auto& [emission, rho] : {std::pair(0.5f, 0.5f), std::pair(0.1f, 0.9f)}) {
        scene::Scene scene = withBackground(0);
        const std::uint32_t wall = addMaterial(scene, 0, 0, 1.5, 0, emission);
        scene.materials[wall].diffuse = vec3(rho);
        addObject(scene, scene::makeBox({2, 2, 2}), wall, dmat4(1.0));
        const TracedScene traced(scene);
        TreeSettings settings = chanceSettings(16);
        double sum = 0;
        for (int k = 0; k <= 16; ++k)
            sum += emission * std::pow(static_cast<double>(rho), k);
        for (int i = 0; i < 200; ++i) {
            const SampleNumbers numbers = sampleOf(i, i, 200);
            const dvec3 u = lobeDirection({0, 1, 0}, 0, numbers.pair(Purpose::pixel));
            EXPECT_NEAR(intensity(traced, settings, {0.1, 0.2, -0.3}, u, numbers).x, sum, 1e-7); // colours are float
        }
        EXPECT_NEAR(sum, emission / (1 - rho), rho < 0.6f ? 1e-5 : 0.2);
    }
}

/// The mean of many samples, its standard error, and how many rays the samples took.
struct MeanOfPaths {
    double mean = 0, error = 0, rays = 0;
};

MeanOfPaths meanOfPaths(const TracedScene& traced, const TreeSettings& settings, const dvec3& fromWorld, int count) {
    double sum = 0, squares = 0, rays = 0;
    const dvec3 from = traced.centred(fromWorld);
    for (int i = 0; i < count; ++i) {
        const SampleNumbers numbers = sampleOf(i, i, count);
        const dvec3 u = lobeDirection({0, 1, 0}, 0, numbers.pair(Purpose::pixel));
        RayTree tree;
        tree.trace({traced.surfaces(), trace::MovingScene(traced.tracer()), 0, &numbers}, settings, from, u,
                   traced.tracer().nextPoint(from, trace::kNoPrimitive, u), traced.surfaces().mediaAround(from));
        const double seen = tree.root().intensity.x;
        sum += seen;
        squares += seen * seen;
        rays += static_cast<double>(tree.nodes().size());
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count), rays / count};
}

// Emission 1 - rho: every bounce together gives 1. A path that ends at a depth loses rho^(depth + 1) of it; one that ends by chance
// loses nothing on average, in a dark room as in a bright one.
TEST(WhiteFurnace, RussianRouletteLosesNothing) {
    for (const double rho : {0.5, 0.9, 0.99}) {
        scene::Scene scene = withBackground(0);
        const std::uint32_t wall = addMaterial(scene, 0, 0, 1.5, 0, static_cast<float>(1 - rho));
        scene.materials[wall].diffuse = vec3(static_cast<float>(rho));
        addObject(scene, scene::makeBox({2, 2, 2}), wall, dmat4(1.0));
        const TracedScene traced(scene);
        TreeSettings settings = chanceSettings(10);
        settings.roulette = true;
        const MeanOfPaths paths = meanOfPaths(traced, settings, {0.1, 0.2, -0.3}, 12000);
        EXPECT_NEAR(paths.mean, 1, 4 * paths.error) << rho; // of a normal distribution one in 16,000 lies farther off
        EXPECT_LT(paths.error, 0.01) << "else the line above proves little";
        EXPECT_LT(paths.rays, 2 / (1 - rho) + std::log(0.5) / std::log(rho)) << "paths end";
        settings.roulette = false;
        EXPECT_NEAR(meanOfPaths(traced, settings, {0.1, 0.2, -0.3}, 50).mean, 1 - std::pow(rho, 11), 1e-3) << "the fault";
    }
}

// Glass splits every ray in two. With chance, the rays of a path stay few, and what they find stays right.
TEST(WhiteFurnace, RussianRouletteKeepsTheRaysOfGlassFew) {
    scene::Scene scene = withBackground(0);
    const std::uint32_t wall = addMaterial(scene, 0, 0, 1.5, 0, 0.1f);
    scene.materials[wall].diffuse = vec3(0.9f);
    addObject(scene, scene::makeBox({4, 4, 4}), wall, dmat4(1.0));
    const std::uint32_t glass = addMaterial(scene, 0.1, 0.9, 1.5);
    for (const double x : {-0.8, 0.8})
        addObject(scene, scene::makeSphere(0.7, 16), glass, testing::translation({x, 0, 0}));
    const TracedScene traced(scene);
    TreeSettings settings = chanceSettings(16);
    const MeanOfPaths all = meanOfPaths(traced, settings, {0, 1.2, 0}, 20);
    settings.roulette = true;
    const MeanOfPaths some = meanOfPaths(traced, settings, {0, 1.2, 0}, 6000);
    EXPECT_NEAR(some.mean, 1, 4 * some.error);
    EXPECT_LT(some.error, 0.01);
    EXPECT_LT(some.rays, 60);
    EXPECT_GT(all.rays, 3 * some.rays) << "each ray split at each surface, to the maximum depth";
}

// Nothing is absorbed, so no path would ever end by what it carries.
TEST(WhiteFurnace, RussianRouletteEndsPathsBetweenPerfectMirrors) {
    scene::Scene scene = withBackground(0);
    const std::uint32_t mirror = addMaterial(scene, 1, 0);
    addObject(scene, scene::makeBox({2, 2, 2}), mirror, dmat4(1.0));
    TreeSettings settings = chanceSettings(10);
    settings.roulette = true;
    const MeanOfPaths paths = meanOfPaths(TracedScene(scene), settings, {0.1, 0.2, -0.3}, 500);
    EXPECT_LT(paths.rays, 300); // 16 levels, and 100 more on average
    EXPECT_EQ(paths.mean, 0);
}

/// One horizon bright, the other dark: a huge wall that shines stands close to the point, at that angle.
struct HalfBright {
    const char* name;
    double reflectivity, transparency, glossDegrees, translucencyDegrees;
    float diffuse;
    double expected; ///< of a radiance of 1
};

TEST(WhiteFurnace, ErrorsByChanceAreDistributedAsTheyMustBe) {
    // The half x > 0 of all directions is bright. Rays come straight down on a surface at the origin: lobes stand upright, and by
    // symmetry one half of each is bright. Every sample is 0 or 1, so the mean of n of them has a standard deviation of
    // 1 / (2 sqrt(n)); z-scores of many pixels must be those of a normal distribution.
    constexpr int kPixels = 400, kSamples = 256;
    int tests = 0;
    for (const HalfBright& c : {HalfBright{"Lambert", 0, 0, 0, 0, 1, 0.5}, HalfBright{"gloss", 1, 0, 30, 0, 0, 0.5},
                                HalfBright{"translucency", 0, 1, 0, 30, 0, 0.5}}) {
        scene::Scene scene = withBackground(0);
        const std::uint32_t material = addMaterial(scene, c.reflectivity, c.transparency, 1.0);
        scene.materials[material].glossDegrees = c.glossDegrees;
        scene.materials[material].translucencyDegrees = c.translucencyDegrees;
        scene.materials[material].diffuse = vec3(c.diffuse);
        addObject(scene, scene::makeQuad({0.5, 0.5}), material, dmat4(1.0)); // a sheet
        // A quarter of a huge shell: everything with x > 0 but for a slit at the edge that is 1e-6 of the half-space.
        const double far = 1e6;
        const std::uint32_t bright = addMaterial(scene, 0, 0, 1.5, 0, 1);
        addObject(scene,
                  testing::triangleSoup(
                      {{1, -far, -far}, {1, far, -far}, {1, far, far}, {1, -far, -far}, {1, far, far}, {1, -far, far}}),
                  bright, dmat4(1.0));
        const TracedScene traced(scene);
        TreeSettings settings = chanceSettings(2);
        settings.fresnel = Fresnel::constant;
        std::vector<double> scores;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            double sum = 0;
            for (int i = 0; i < kSamples; ++i)
                sum += intensity(traced, settings, {0, 1, 0}, {0, -1, 0}, sampleOf(pixel, i, kSamples)).x;
            scores.push_back((sum / kSamples - c.expected) * 2 * std::sqrt(kSamples));
        }
        double mean = 0, squares = 0, largest = 0;
        for (const double z : scores) {
            mean += z / kPixels;
            squares += z * z / kPixels;
            largest = std::max(largest, std::abs(z));
        }
        EXPECT_LT(std::abs(mean), 4 / std::sqrt(kPixels)) << c.name;     // four standard deviations
        EXPECT_NEAR(squares, 1, 4 * std::sqrt(2.0 / kPixels)) << c.name; // of chi-square / n
        EXPECT_LT(largest, 4.2) << c.name; // Bonferroni: one in a hundred for the largest of 400
        EXPECT_GT(largest, 2.0) << c.name; // and chance was there
        const auto within = std::ranges::count_if(scores, [](double z) { return std::abs(z) < 1; });
        EXPECT_NEAR(static_cast<double>(within) / kPixels, 0.683, 4 * std::sqrt(0.683 * 0.317 / kPixels) + 0.05)
            << c.name; // the mean of 256 has steps of an eighth of a standard deviation
        ++tests;
    }
    EXPECT_EQ(tests, 3);
}

} // namespace
} // namespace shadowlab::ray_tracing
