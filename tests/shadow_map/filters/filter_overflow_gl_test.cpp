// Where numbers end: exponentials overflow, in the moments of filters that average them.
//   M14 overflow      ExponentialsOverflowWhereTheirFormatEnds and SumsOverflowBeforeTheirTermsDo (naive: exponent-limit=false),
//                     WithItsLimitNothingOverflows, EveryMomentOfEveryBuiltInSceneIsANumber
//       in a picture  InfinitiesLoseTheShadow (naive: the same)
//       one depth     BehindOneDepthTheFilterIsTheExponential
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/filters/moment_texels.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using shadow_map::MomentMaker;
using testing::FilledMap;
using testing::FilterParams;
using testing::LightShares;
using testing::ShadowMapSlot;
using Kind = shadow_map::FilterKind;
using Format = FilterParams::MomentFormat;
using OverflowTest = testing::GlTest;

const Kind kVsm = shadow_map::filterNamed("vsm"), kEsm = shadow_map::filterNamed("esm"),
           kEvsm = shadow_map::filterNamed("evsm"), kMsm = shadow_map::filterNamed("msm");
const Kind kMomentKinds[] = {kVsm, kEsm, kEvsm, kMsm};

int notNumbers(const std::vector<vec4>& texels) {
    int count = 0;
    for (const vec4& texel : texels)
        for (int i = 0; i < 4; ++i)
            count += !std::isfinite(texel[i]);
    return count;
}

/// A map in which everything is as far away as it can be: z = 1, where exp(c z) is largest.
class FarEnd {
public:
    std::vector<vec4> texels(const FilterParams& params) { return testing::momentTexels(maker_, far_, params); }
    int notNumbers(const FilterParams& params) { return shadowlab::notNumbers(texels(params)); }
    static constexpr int kSide = 8;

private:
    FilledMap far_ = testing::filledMap(kSide, [](int, int) { return 1.0; });
    MomentMaker maker_;
};

/// An exponential filter with this exponent, and nothing that would save it; the average is of one texel.
FilterParams unlimited(Kind kind, Format format, double exponent) {
    FilterParams params;
    params.kind = kind;
    params.momentFormat = format;
    params.esmExponent = params.evsmExponent = params.evsmNegative = exponent;
    params.esmLogarithms = false;
    params.exponentLimit = false;
    params.blurRadius = 0;
    return params;
}

// ln(3.4028e38) = 88.7228 and ln(65504) = 11.0899; evsm squares, so half of that. Beyond its end a format holds infinity, or,
// of drivers that round toward zero (llvmpipe, 16 bits), its largest number whatever the exponential is.
TEST_F(OverflowTest, ExponentialsOverflowWhereTheirFormatEnds) {
    FarEnd end;
    // How much what is stored, of evsm the square, differs from what it should be, as a share of that.
    const auto error = [&](Kind kind, Format format, double exponent) {
        const int channel = kind == kEvsm ? 1 : 0;
        double largest = 0;
        for (const vec4& texel : end.texels(unlimited(kind, format, exponent)))
            largest = std::max(largest, std::abs(texel[channel] / std::exp((channel + 1) * exponent) - 1));
        return largest;
    };
    struct End {
        Kind kind;
        Format format;
        double finite, infinite;
    };
    for (const End& e : {End{kEsm, Format::float32, 88.7, 88.8}, End{kEsm, Format::float16, 11.08, 11.1},
                         End{kEvsm, Format::float32, 44.36, 44.4}, End{kEvsm, Format::float16, 5.54, 5.55}}) {
        // 16 bits have eleven digits, and moments are stored twice; 32 bits lose more in the exponent than in storing.
        EXPECT_LE(error(e.kind, e.format, e.finite), 2.0 / 2048) << e.finite;
        EXPECT_GE(error(e.kind, e.format, e.infinite), 0.005) << e.infinite;
        EXPECT_GE(error(e.kind, e.format, 2 * e.infinite), 0.99) << e.infinite;
        const int notNumbers = end.notNumbers(unlimited(e.kind, e.format, e.infinite));
        EXPECT_TRUE(notNumbers > 0 || e.format == Format::float16) << e.infinite;
    }
}

TEST_F(OverflowTest, WithItsLimitNothingOverflows) {
    FarEnd end;
    for (const Kind kind : {kEsm, kEvsm})
        for (const Format format : {Format::float32, Format::float16})
            for (const int blurRadius : {0, 1, 7, 31})
                for (const bool logarithms : {false, true}) {
                    FilterParams params = unlimited(kind, format, 400);
                    params.exponentLimit = true;
                    params.esmLogarithms = logarithms;
                    params.blurRadius = blurRadius;
                    EXPECT_EQ(end.notNumbers(params), 0) << int(kind) << " " << int(format) << " " << blurRadius;
                }
    FilterParams logarithms = unlimited(kEsm, Format::float16, 400);
    logarithms.esmLogarithms = true; // 400 itself is far from the end of either format
    EXPECT_EQ(end.notNumbers(logarithms), 0);
}

// In a kernel three exponentials are added before they are divided by three: the limit has to leave room for that.
TEST_F(OverflowTest, SumsOverflowBeforeTheirTermsDo) {
    FarEnd end;
    FilterParams params = unlimited(kEsm, Format::float32, 88.7);
    params.blurRadius = 1;
    EXPECT_GT(end.notNumbers(params), 0);
    params.exponentLimit = true;
    EXPECT_EQ(end.notNumbers(params), 0);
}

// What becomes of a picture then: infinity times nothing is no share of light.
TEST_F(OverflowTest, InfinitiesLoseTheShadow) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::directionalLight({0.5, -1, 0.25})};
    const testing::JudgedPicture judged(testing::snapshot(scene), {160, 120}, 0, testing::kTiePx);
    const auto wrong = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> all = {"filter=esm", "esm-logarithms=false"};
        all.insert(all.end(), settings.begin(), settings.end());
        return judged.differing(
            testing::renderVisibility(judged.snapshot(), "shadow-map", all, judged.size(), judged.light()));
    };
    const int limited = wrong({}), unlimitedWrong = wrong({"exponent-limit=false"});
    std::cout << "wrong pixels: " << limited << ", without a limit " << unlimitedWrong << "\n";
    EXPECT_LT(limited, judged.size().x); // along edges, where a map is coarse
    EXPECT_GT(unlimitedWrong, 500);
}

// Behind a caster at one depth z there is one exponential to average, exp(c z): what is seen at depth d is exp(-c (d - z)), which
// goes to black within a few times 1/c of the map's range. A picture of a ramp shows it at all depths.
TEST_F(OverflowTest, BehindOneDepthTheFilterIsTheExponential) {
    constexpr ivec2 kSize{128, 96};
    constexpr double kPlate = 2, kEye = 8;
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::directionalLight({0, -1, 0}));
    testing::addObject(scene, scene::makeQuad({10, 10}), testing::translation({0, kPlate, 0}));
    // The ramp rises from the floor to just below the plate; the eye's near plane cuts the plate away.
    const dvec3 a(-3, 0.01, 2), b(3, kPlate - 0.01, 2), c(3, kPlate - 0.01, -2), d(-3, 0.01, -2);
    testing::addObject(scene, testing::triangleSoup({a, b, c, a, c, d}));
    constexpr std::size_t kRamp = 2;
    scene.camera.positionWorld = {0, kEye, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, -1};
    scene.camera.near = kEye - kPlate + 1e-3;
    scene.camera.fovYDegrees = 50;
    const testing::JudgedPicture judged(testing::snapshot(scene), kSize, 0, testing::kTiePx);
    const shadow_map::LightMaps maps =
        testing::sceneMaps(scene, scene.lights[0], 256, 2, {.fit = shadow_map::ProjectionParams::Fit::scene}, true);
    const auto shareOfRange = [&](double height) {
        return (maps.originWorld.y - height - maps.nearest) / (maps.farthest - maps.nearest);
    };
    ShadowMapSlot slot(judged.snapshot());
    for (const auto& [exponent, logarithms] :
         {std::pair{200.0, true}, {400.0, true}, {40.0, true}, {400.0, false}, {40.0, false}, {5.0, false}}) {
        FilterParams params;
        params.kind = kEsm;
        params.esmExponent = exponent;
        params.esmLogarithms = logarithms;
        const double used = shadow_map::exponents(params).esm;
        const LightShares shares =
            slot.shares({"filter=esm", "esm-exponent=" + std::to_string(exponent),
                         logarithms ? "esm-logarithms=true" : "esm-logarithms=false", "bleed-reduction=0",
                         "bias-mode=none", "depth-format=32f", "fit=scene", "resolution=256"},
                        kSize);
        double largest = 0;
        int between = 0, compared = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                if (!judged.hit(x, y) || judged.hit(x, y)->object != kRamp) continue;
                const double behind = shareOfRange(judged.hit(x, y)->positionWorld.y) - shareOfRange(kPlate);
                const double exact = std::min(1.0, std::exp(-used * behind));
                largest = std::max(largest, std::abs(testing::asNumber(shares.at(x, y)) - exact));
                between += exact > 0.01 && exact < 0.99;
                ++compared;
            }
        std::cout << "c = " << used << (logarithms ? " (logarithms)" : "") << ": " << largest << ", between " << between
                  << "\n";
        EXPECT_GT(compared, 4000);
        EXPECT_GT(between, 50);
        EXPECT_LE(largest, 1e-3) << used; // c z is 400 at most: of a float that large, 3e-5 is lost
    }
}

TEST_F(OverflowTest, EveryMomentOfEveryBuiltInSceneIsANumber) {
    MomentMaker maker;
    const auto root = context::assetsRoot();
    int scenes = 0, textures = 0;
    std::size_t texels = 0;
    for (const std::string& name : scene::builtInScenes(root)) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        ++scenes;
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
            const FilledMap drawn = testing::drawnMap(snapshot, light, 256);
            if (drawn.maps.layers() == 0) continue;
            for (const Kind kind : kMomentKinds)
                for (const Format format : {Format::float32, Format::float16}) {
                    FilterParams params;
                    params.kind = kind;
                    params.momentFormat = format;
                    const std::vector<vec4> moments = testing::momentTexels(maker, drawn, params);
                    EXPECT_EQ(notNumbers(moments), 0) << name << ", light " << light << ", filter " << int(kind);
                    ++textures;
                    texels += moments.size();
                }
        }
    }
    std::cout << scenes << " scenes, " << textures << " textures, " << texels << " texels\n";
    EXPECT_GE(scenes, 9);
    EXPECT_GE(textures, 8 * scenes);
}

} // namespace
} // namespace shadowlab
