// What a filter may make of comparisons: an average of them, and nothing else. On a plane under a light straight above, and
// with a pixel for every texel, that can be counted.
//   M25 a constant stays a constant  WhereAllTexelsAgreeSoDoesTheFilter
//                                    naive: exponents that overflow; moments of 16 bits
//   M26 the mean is kept             PcfIsTheBlurredHardMap, ComparisonsKeepTheMean
//                                    naive: vsm, a bound and no mean
// SPDX-License-Identifier: MIT
#include <cmath>

#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using FilterAveragesTest = testing::GlTest;

constexpr int kTexels = 128;                      ///< along a side of the hard map
constexpr ivec2 kSize{kTexels + 64};              ///< wider than any map here
constexpr double kPerMetre = (kTexels - 1) / 2.0; ///< texels, and pixels

// A map has as many texels for what casts as it has along a side, less a guard band of the kernel's radius and half a texel on
// both sides (fit.cpp). So with as many more for the band, texels are the same in all of them.
std::string resolutionFor(int guardTexels) { return "resolution=" + std::to_string(kTexels + 2 * guardTexels); }

/// Slivers and corners, two metres square, a metre above the floor; the sun straight above. The middle of each pixel lies
/// `beside` texels beside the middle of a texel.
scene::Scene slivers(double beside) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, testing::triangleSoup({{-1, 1, -1},
                                                     {1, 1, -0.8},
                                                     {-0.9, 1, 0.1},
                                                     {1, 1, -0.5},
                                                     {0.97, 1, 1},
                                                     {-0.4, 1, 0.6},
                                                     {-1, 1, 1},
                                                     {-0.95, 1, 0.2},
                                                     {0.6, 1, 0.99}}));
    scene.lights.push_back(testing::directionalLight({0, -1, 0}));
    scene.camera = testing::PlaneView{dvec2(beside / kPerMetre), kPerMetre, kSize}.camera();
    return scene;
}

class Averages {
public:
    explicit Averages(double beside = 0) : slot_(testing::snapshot(slivers(beside))) {}
    judge::Grid<float> image(std::vector<std::string> settings, int guardTexels) {
        settings.insert(settings.end(), {"fit=scene", resolutionFor(guardTexels)});
        return slot_.shares(settings, kSize, 0);
    }

private:
    testing::ShadowMapSlot slot_;
};

double meanOf(const judge::Grid<float>& image) {
    double sum = 0;
    for (const float v : image.values)
        sum += v;
    return sum / static_cast<double>(image.values.size());
}

/// What is beyond the picture's edge is lit.
judge::Grid<float> blurred(const judge::Grid<float>& hard, int radius) {
    judge::Grid<float> result(hard.width, hard.height);
    const int width = 2 * radius + 1;
    for (int y = 0; y < hard.height; ++y)
        for (int x = 0; x < hard.width; ++x) {
            int lit = width * width;
            for (int v = std::max(y - radius, 0); v <= std::min(y + radius, hard.height - 1); ++v)
                for (int u = std::max(x - radius, 0); u <= std::min(x + radius, hard.width - 1); ++u)
                    lit -= hard.at(u, v) == 0;
            result.at(x, y) = static_cast<float>(lit) / static_cast<float>(width * width);
        }
    return result;
}

// M26, pixel by pixel, and M24 for a radius of 0. The same whether each texel is looked up, or several at once.
TEST_F(FilterAveragesTest, PcfIsTheBlurredHardMap) {
    Averages averages;
    const judge::Grid<float> hard = averages.image({"filter=hard"}, 0);
    for (const int radius : {0, 1, 2, 7})
        for (const char* mode : {"receiver-plane", "slope-scaled"}) {
            const auto pcf = averages.image(
                {"filter=pcf", std::string("bias-mode=") + mode, "pcf-radius=" + std::to_string(radius)}, radius);
            const judge::Grid<float> right = blurred(hard, radius);
            float largest = 0;
            int between = 0;
            for (std::size_t i = 0; i < pcf.values.size(); ++i) {
                largest = std::max(largest, std::abs(pcf.values[i] - right.values[i]));
                between += right.values[i] > 0 && right.values[i] < 1;
            }
            EXPECT_LT(largest, 1e-6) << radius << " " << mode; // float quotients
            EXPECT_GE(between, 1500 * radius);
        }
}

// M26, also where pixels are no texels' middles: then hw2x2 has weights of 9, 3, 3 and 1 sixteenths.
TEST_F(FilterAveragesTest, ComparisonsKeepTheMean) {
    for (const double beside : {0.0, 0.25}) {
        Averages averages(beside);
        const double hard = meanOf(averages.image({"filter=hard"}, 0));
        const auto difference = [&](const std::vector<std::string>& settings, int guard) {
            return meanOf(averages.image(settings, guard)) - hard;
        };
        EXPECT_GT(hard, 0.2);
        EXPECT_LT(hard, 0.8);
        const double rounding = 1e-6; // of float sums
        EXPECT_NEAR(difference({"filter=hw2x2"}, 1), 0, rounding);
        EXPECT_NEAR(difference({"filter=pcf", "pcf-radius=1"}, 1), 0, rounding);
        EXPECT_NEAR(difference({"filter=pcf", "pcf-radius=6"}, 6), 0, rounding);
        EXPECT_NEAR(difference({"filter=disc", "disc-radius=3", "noise=none"}, 3), 0, rounding);
        // Turned by chance in each texel, the discs of 5000 pixels near edges are wrong by about 0.1 each, up or down:
        // 0.1 * sqrt(5000) / 36864 = 2e-4.
        for (const char* noise : {"noise=texel", "noise=pixel"})
            EXPECT_NEAR(difference({"filter=disc", "disc-radius=3", noise}, 3), 0, 2e-4) << noise;
        // Not so a bound on what is lit that only parallel surfaces reach, less what is cut off it against bleeding.
        EXPECT_LT(difference({"filter=vsm", "blur-radius=2"}, 3), -1e-3);
    }
}

/// Range of the visibility where all texels within the kernel's reach are lit, and where none is.
struct Constants {
    float leastLit = 1, mostDark = 0;
    int lit = 0, dark = 0, outside = 0; ///< of 0..1, in the whole picture
};
std::ostream& operator<<(std::ostream& stream, const Constants& c) {
    return stream << c.lit << " lit, at least " << c.leastLit << "; " << c.dark << " dark, at most " << c.mostDark;
}

TEST_F(FilterAveragesTest, WhereAllTexelsAgreeSoDoesTheFilter) {
    Averages averages;
    constexpr int kReach = 3; // texels: none of the kernels is wider
    const judge::Grid<float> around = blurred(averages.image({"filter=hard"}, 0), kReach);
    const auto constants = [&](const std::vector<std::string>& settings) {
        const judge::Grid<float> image = averages.image(settings, kReach);
        Constants c;
        for (std::size_t i = 0; i < image.values.size(); ++i) {
            const float v = image.values[i];
            c.outside += !(v >= 0 && v <= 1); // or not a number
            if (around.values[i] == 1) ++c.lit, c.leastLit = std::min(c.leastLit, v);
            if (around.values[i] == 0) ++c.dark, c.mostDark = std::max(c.mostDark, v);
        }
        std::cout << settings[0] << " " << settings.back() << ": " << c << "\n";
        EXPECT_GT(c.lit, 5000);
        EXPECT_GT(c.dark, 5000);
        return c;
    };
    for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
             {"filter=hard"}, {"filter=hw2x2"}, {"filter=pcf", "pcf-radius=3"}, {"filter=disc", "disc-radius=3"}}) {
        const Constants c = constants(settings);
        EXPECT_EQ(c.outside, 0);
        EXPECT_EQ(c.leastLit, 1);
        EXPECT_EQ(c.mostDark, 0);
    }
    // Averaged moments of equal depths are those moments but for rounding, of which msm takes differences.
    for (const char* filter : {"vsm", "esm", "evsm", "msm"})
        for (const char* mipmaps : {"mipmaps=false", "mipmaps=true"}) {
            const Constants c = constants({std::string("filter=") + filter, "blur-radius=2", mipmaps});
            EXPECT_EQ(c.outside, 0);
            EXPECT_GT(c.leastLit, 1 - 1e-5);
            EXPECT_LT(c.mostDark, 1e-5);
        }
    // Naive: exp(200 z) is infinite, and infinity times zero no number; and what 16 bits round off 200 z is seen.
    EXPECT_LT(constants({"filter=esm", "blur-radius=2", "esm-logarithms=false", "exponent-limit=false"}).leastLit, 0.5);
    EXPECT_LT(constants({"filter=esm", "blur-radius=2", "moment-format=16f"}).leastLit, 0.95);
}

} // namespace
} // namespace shadowlab
