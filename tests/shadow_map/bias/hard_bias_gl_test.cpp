// Hard cases of bias: too little of it and a lit surface shadows itself (acne); too much, and shadows come away from what
// casts them (peter-panning). Both must hold at once, with the defaults.
//   M1 acne           FloorAloneIsLitAtEveryElevation, NoKindOfMapShadowsTheFloor;
//                     naive: WithoutBiasTheFloorShadowsItself, AConstantIsRightForOneElevationOnly
//   M2 peter-panning  ShadowsBeginAtTheContact, ASheetLosesNoMoreThanItsBias;
//                     naive: TheConstantThatCuresGrazingLightLosesTheContact
//   M3 thin casters   ThinCastersKeepTheirShadow; naive: TheSameConstantLosesASheetNearTheFloor
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iomanip>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::JudgedPicture;
using testing::TruthComparison;
using HardBiasTest = testing::GlTest;

constexpr ivec2 kSize{256, 192};
const std::vector<std::string> kBiasModes = {"none",           "constant",   "slope-scaled", "normal-offset",
                                             "receiver-plane", "dual-depth", "adaptive"};

std::string resolutionSetting(int resolution) { return "resolution=" + std::to_string(resolution); }

/// A sun so many degrees above the horizon that shines toward +x, turned about the vertical.
scene::Light sunAt(double elevationDegrees, double azimuthDegrees = 0) {
    const double elevation = glm::radians(elevationDegrees), azimuth = glm::radians(azimuthDegrees);
    return testing::directionalLight(
        {std::cos(elevation) * std::cos(azimuth), -std::sin(elevation), std::cos(elevation) * std::sin(azimuth)});
}

JudgedPicture floorUnder(const scene::Light& light) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(light);
    return {testing::snapshot(scene), kSize, 0, testing::kTiePx};
}

TruthComparison compare(const JudgedPicture& judged, const std::vector<std::string>& settings) {
    return judged.compare(testing::renderVisibility(judged.snapshot(), "shadow-map", settings, judged.size(), 0));
}

// M1. cull=false: a floor alone shadows nothing, and without it there would be no map to be wrong.
TEST_F(HardBiasTest, FloorAloneIsLitAtEveryElevation) {
    for (const double elevation : {1.0, 5.0, 10.0, 30.0, 60.0, 90.0})
        for (const double azimuth : {0.0, 33.0}) { // along a side of the map, and aslant
            const JudgedPicture judged = floorUnder(sunAt(elevation, azimuth));
            for (const int resolution : {512, 1024, 2048, 4096})
                for (const char* filter : {"filter=hard", "filter=pcf"}) {
                    const TruthComparison sum = compare(judged, {"cull=false", resolutionSetting(resolution), filter});
                    EXPECT_GT(sum.lit, 15000); // all-lit: there is nothing that could cast a shadow
                    EXPECT_EQ(sum.wrong(), 0)
                        << elevation << " degrees, " << resolution << ", " << filter << ": " << sum;
                }
        }
}

// M1, for maps of other kinds, and for all modes that adapt to the slope: cascades, a warped map, and lamps beside the floor
// and high above it. Of a perspective map the texels are skewed, and depths are compared along its axis, not along rays.
TEST_F(HardBiasTest, NoKindOfMapShadowsTheFloor) {
    const auto expectLit = [](const scene::Light& light, const std::vector<std::string>& maps) {
        const JudgedPicture judged = floorUnder(light);
        for (const char* mode : {"slope-scaled", "normal-offset", "receiver-plane"})
            for (const char* filter : {"filter=hard", "pcf-radius=2"}) {
                std::vector<std::string> settings = maps;
                settings.insert(settings.end(), {std::string("bias-mode=") + mode, filter, "cull=false"});
                const TruthComparison sum = compare(judged, settings);
                EXPECT_GT(sum.lit, 15000);
                EXPECT_EQ(sum.wrong(), 0) << maps[0] << " " << mode << " " << filter << ", " << light.name << " at "
                                          << light.positionWorld.y << ": " << sum;
            }
    };
    for (const double elevation : {1.0, 10.0, 60.0}) {
        expectLit(sunAt(elevation, 33), {"cascades=4", "resolution=512"});
        expectLit(sunAt(elevation, 33), {"warp=lispsm", "resolution=512"});
    }
    for (const double height : {0.3, 3.0, 8.7})
        expectLit(testing::pointLight({-2, height, 3.5}), {"resolution=512"});
}

TEST_F(HardBiasTest, WithoutBiasTheFloorShadowsItself) {
    for (const double elevation : {5.0, 30.0}) {
        const TruthComparison none =
            compare(floorUnder(sunAt(elevation)), {"cull=false", "resolution=512", "filter=hard", "bias-mode=none"});
        EXPECT_GT(none.falseShadow, none.lit / 4) << none; // half of each texel is nearer than its centre
    }
}

// What a single comparison needs on a plane is half a texel times the tangent of the light's angle to its normal: 0.5 at
// 45 degrees, 5.7 texels when the light is 5 degrees above the floor, and up to sqrt(2) times that aslant.
const double kConstantAt45 = 0.75, kConstantAt85 = 6.0;

std::vector<std::string> constantBias(double texels) {
    return {"bias-mode=constant", "filter=hard", "constant-bias=" + std::to_string(texels)};
}

TEST_F(HardBiasTest, AConstantIsRightForOneElevationOnly) {
    const auto wrongAt = [](double elevation, double texels) {
        std::vector<std::string> settings = constantBias(texels);
        settings.insert(settings.end(), {"cull=false", "resolution=512"});
        return compare(floorUnder(sunAt(elevation)), settings).falseShadow;
    };
    EXPECT_EQ(wrongAt(45, kConstantAt45), 0);
    EXPECT_GT(wrongAt(5, kConstantAt45), 5000);
    EXPECT_EQ(wrongAt(5, kConstantAt85), 0);
}

/// A caster that stands on the floor, its back face in the plane x = 0, a sun 45 degrees above the horizon that throws its
/// shadow toward +x, and the eye close to where that begins. Four small posts far away make the map as wide as the floor.
class Contact {
public:
    enum class Side { dark, lit };
    /// Looks at the contact from its dark side, where x > 0, or at that of the front face from the lit one.
    Contact(double thickness, Side side)
        : judged_(testing::snapshot(standing(thickness, side)), kSize, 0, testing::kTiePx) {}

    struct Gap {
        double texels = 0;   ///< how far behind the contact the floor is still lit
        int falseShadow = 0; ///< on the lit side, in pixels
        int lit = 0, shadowed = 0;
    };
    [[nodiscard]] Gap gap(int resolution, std::vector<std::string> settings = {}) const {
        const double texel = texelMetres(resolution);
        // fit=scene: a map whose texels are known. cull=false: the floor is in it.
        settings.insert(settings.end(), {"fit=scene", "cull=false", resolutionSetting(resolution)});
        const auto image = testing::renderVisibility(judged_.snapshot(), "shadow-map", settings, kSize, 0);
        Gap gap;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                if (!judged_.hit(x, y) || judged_.hit(x, y)->object != 0) continue;
                const dvec3 at = judged_.hit(x, y)->positionWorld;
                const bool lit = image.grey(x, y) > 127;
                const bool shadowed = judged_.truth(x, y) == trace::Visibility::shadowed;
                gap.lit += !shadowed, gap.shadowed += shadowed;
                // Away from the caster's sides, where the shadow has an edge that may be a texel off.
                if (std::abs(at.z) > 0.4) continue;
                if (shadowed && lit) gap.texels = std::max(gap.texels, at.x / texel);
                gap.falseShadow += !shadowed && !lit;
            }
        return gap;
    }

private:
    static scene::Scene standing(double thickness, Side side) {
        scene::Scene scene = testing::floorScene();
        scene.lights.push_back(sunAt(45));
        testing::addObject(scene, scene::makeBox({thickness, 1, 1}), testing::translation({-0.5 * thickness, 0.5, 0}));
        for (const dvec2 corner : {dvec2(-4.8, -4.8), dvec2(4.8, -4.8), dvec2(-4.8, 4.8), dvec2(4.8, 4.8)})
            testing::addObject(scene, scene::makeBox({0.2, 0.2, 0.2}), testing::translation({corner.x, 0.1, corner.y}));
        const double out = side == Side::dark ? 1 : -1, face = side == Side::dark ? 0 : -thickness;
        scene.camera.positionWorld = {face + 0.6 * out, 1.2, 0};
        scene.camera.targetWorld = {face + 0.1 * out, 0, 0};
        scene.camera.fovYDegrees = 15;
        return scene;
    }
    [[nodiscard]] double texelMetres(int resolution) const {
        const scene::Scene& scene = *judged_.snapshot();
        const shadow_map::LightMaps maps = testing::sceneMaps(scene, scene.lights[0], resolution, 1);
        return 2.0 / (maps.lightClipFromLightView[0][0][0] * resolution);
    }

    JudgedPicture judged_;
};

const double kCube = 1, kThinWall = 0.02, kSheet = 0.001;

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// M2. Behind a cube the first thing that light meets is far above the contact; a wall as thin as a texel is the harder case.
// One texel: CASES' criterion for both. At the same time nothing before the contact may be dark.
TEST_F(HardBiasTest, ShadowsBeginAtTheContact) {
    for (const double thickness : {kCube, kThinWall}) {
        const Contact dark(thickness, Contact::Side::dark), lit(thickness, Contact::Side::lit);
        for (const int resolution : {512, 1024, 2048, 4096}) {
            const Contact::Gap behind = dark.gap(resolution), before = lit.gap(resolution);
            EXPECT_GT(behind.shadowed, 5000);
            EXPECT_LE(behind.texels, 1) << thickness << " m at " << resolution;
            EXPECT_GT(before.lit, 5000);
            EXPECT_EQ(before.falseShadow, 0) << thickness << " m at " << resolution;
        }
    }
}

// A sheet without thickness is the worst there is: all of the bias is gap. A kernel needs one texel of slope more than a single
// comparison (depth_pass.cpp says why), so a single comparison keeps within a texel, and the default within two.
TEST_F(HardBiasTest, ASheetLosesNoMoreThanItsBias) {
    const Contact sheet(kSheet, Contact::Side::dark);
    for (const int resolution : {512, 2048}) {
        EXPECT_LE(sheet.gap(resolution, {"filter=hard"}).texels, 1) << resolution;
        EXPECT_LE(sheet.gap(resolution).texels, 2) << resolution;
    }
}

TEST_F(HardBiasTest, TheConstantThatCuresGrazingLightLosesTheContact) {
    // The gap is bias * sin(45 degrees), less what the wall is thick: 6 * 0.71 = 4.2 texels for a sheet.
    const std::vector<std::string> settings = constantBias(kConstantAt85);
    EXPECT_GT(Contact(kSheet, Contact::Side::dark).gap(512, settings).texels, 3);
    EXPECT_GT(Contact(kThinWall, Contact::Side::dark).gap(512, settings).texels, 2);
}

// Nothing is asserted of the other modes; this is the table to choose from. What has no gap has faults of another kind. Where
// the centre of a point's texel lies on the wall's lit face, adaptive compares with the floor's plane behind that, and finds
// the wall before it. And the middle that dual-depth stores is too near in a sheet.
TEST_F(HardBiasTest, TableOfModes) {
    const JudgedPicture grazing = floorUnder(sunAt(5, 33));
    struct Caster {
        const char* name;
        Contact dark, lit;
    };
    const Caster casters[] = {{"cube", {kCube, Contact::Side::dark}, {kCube, Contact::Side::lit}},
                              {"wall .02", {kThinWall, Contact::Side::dark}, {kThinWall, Contact::Side::lit}},
                              {"sheet .001", {kSheet, Contact::Side::dark}, {kSheet, Contact::Side::lit}}};
    std::cout << "At 512 texels. Acne: false shadow px on a floor under a sun at 5 degrees. Under one at 45 degrees: "
                 "gap behind "
                 "the contact in texels,\nand in brackets false shadow px before it.\n"
              << std::setw(20) << "" << std::setw(8) << "acne";
    for (const Caster& caster : casters)
        std::cout << std::setw(16) << caster.name;
    for (const std::string filter : {"hard", "pcf"})
        for (const std::string& mode : kBiasModes) {
            const std::vector<std::string> settings = {"filter=" + filter, "bias-mode=" + mode};
            std::cout << "\n"
                      << std::setw(5) << filter << std::setw(15) << mode << std::setw(8)
                      << compare(grazing, joined(settings, {"cull=false", "resolution=512"})).falseShadow;
            for (const Caster& caster : casters) {
                const Contact::Gap behind = caster.dark.gap(512, settings), before = caster.lit.gap(512, settings);
                std::cout << std::setw(8) << std::fixed << std::setprecision(2) << behind.texels << " (" << std::setw(5)
                          << before.falseShadow << ")";
                EXPECT_GT(behind.shadowed, 5000);
                EXPECT_GT(before.lit, 5000);
            }
        }
    std::cout << std::endl;
}

/// A square sheet of that thickness over the floor, and a triangle of one side only, turned either way.
scene::Scene thinCasters() {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(sunAt(45));
    testing::addObject(scene, scene::makeBox({1, kSheet, 1}), testing::translation({-2, 1, 0}));
    const dvec3 a(0, 1, -0.5), b(1, 1, -0.5), c(0.5, 1.2, 0.5), aside(-0.5, 0, 1.5);
    testing::addObject(scene, testing::triangleSoup({a, b, c}));
    testing::addObject(scene, testing::triangleSoup({a + aside, c + aside, b + aside}));
    return scene;
}

// M3. Only the shadow is asked for: of a sheet thinner than a texel's slope the middle that dual-depth stores is too near, and
// the sheet itself shows acne. A single comparison is at most sqrt(1/2) texels off, and a kernel of three by three by one more
// where a corner is sharp: of two sides that meet at 50 degrees less than half of the kernel may be inside.
TEST_F(HardBiasTest, ThinCastersKeepTheirShadow) {
    const auto snapshot = testing::snapshot(thinCasters());
    for (const std::string& mode : kBiasModes)
        for (const auto& [filter, texels] : {std::pair{"filter=hard", 1.0}, std::pair{"filter=pcf", 2.0}}) {
            if (mode == "none") continue;
            const TruthComparison sum =
                testing::compareWithTruth(snapshot, "shadow-map", {"bias-mode=" + mode, filter, "resolution=512"},
                                          kSize, 0, testing::edgeReach(snapshot, 0, 512, kSize, texels));
            EXPECT_GT(sum.lit, 5000);
            EXPECT_GT(sum.shadowed, 500);
            EXPECT_EQ(sum.falseLit, 0) << mode << ", " << filter << ": " << sum;
            EXPECT_EQ(sum.coverage, 0);
        }
}

// A sheet that hovers three texels over the floor: to the light at 45 degrees that is 4.2 texels before the floor, more than
// the default's bias and less than the constant that cures grazing light.
TEST_F(HardBiasTest, TheSameConstantLosesASheetNearTheFloor) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(sunAt(45));
    for (const double x : {-4.8, 4.8}) // posts that make the map as wide as the floor
        testing::addObject(scene, scene::makeBox({0.2, 0.2, 0.2}), testing::translation({x, 0.1, x}));
    const shadow_map::LightMaps maps = testing::sceneMaps(scene, scene.lights[0], 512, 1);
    const double texel = 2.0 / (maps.lightClipFromLightView[0][0][0] * 512);
    testing::addObject(scene, scene::makeBox({1, kSheet, 1}), testing::translation({0, 3 * texel, 0}));
    scene.camera.positionWorld = {1.2, 0.35, 0};
    scene.camera.targetWorld = {0.5, 0, 0};
    scene.camera.fovYDegrees = 35;
    const auto snapshot = testing::snapshot(scene);
    const JudgedPicture judged(snapshot, kSize, 0, testing::edgeReach(snapshot, 0, 512, kSize, 1.5));
    const TruthComparison right = compare(judged, {"fit=scene", "resolution=512"});
    EXPECT_GT(right.lit, 5000);
    EXPECT_GT(right.shadowed, 5000);
    EXPECT_EQ(right.falseLit, 0) << right;
    const auto naive = testing::renderVisibility(
        snapshot, "shadow-map", joined(constantBias(kConstantAt85), {"fit=scene", "resolution=512"}), kSize, 0);
    EXPECT_EQ(judged.differing(naive), right.shadowed) << "all of the shadow is lost";
}

} // namespace
} // namespace shadowlab
