// What the probe of the shadow map says a texel holds, against the map that the graphics card drew; and what it decides, against
// the picture.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <map>

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
using MapProbeTest = testing::GlTest;

constexpr ivec2 kSize{96, 72};
constexpr int kStep = 5, kCoarseStep = 8;
constexpr int kResolution = 187; ///< that no other texture has

/// All layers of the one depth map of that resolution.
std::vector<float> readMap(int layers) {
    for (GLuint name = 1; name < 4096; ++name) {
        if (!glIsTexture(name)) continue;
        glBindTexture(GL_TEXTURE_2D_ARRAY, name);
        if (glGetError() != GL_NO_ERROR) continue; // it is of another kind
        GLint side = 0, depthBits = 0, found = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &side);
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH_SIZE, &depthBits);
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH, &found);
        if (side != kResolution || depthBits == 0 || found != layers) continue;
        std::vector<float> depths(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                                  static_cast<std::size_t>(layers));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
        gl::takeDebugMessages(); // of textures of other kinds
        return depths;
    }
    ADD_FAILURE() << "no such map";
    return {};
}

scene::Scene withLight(const scene::Light& light) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {light};
    return scene;
}

std::vector<std::string> with(std::vector<std::string> settings) {
    settings.push_back("resolution=" + std::to_string(kResolution));
    return settings;
}

TEST_F(MapProbeTest, SaysWhatTheMapHolds) {
    int compared = 0, filled = 0, differing = 0, unexplained = 0, withoutOffset = 0;
    for (const scene::Light& light : {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}),
                                      testing::pointLight({0.2, 0.7, 0.1})})
        for (const char* bias : {"none", "slope-scaled", "receiver-plane", "dual-depth"}) {
            const auto scene = testing::snapshot(withLight(light));
            ProbedPicture picture(scene, "shadow-map", with({"filter=hard", std::string("bias-mode=") + bias}), kSize);
            const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(*scene);
            std::map<int, testing::EdgeTexels> edges; // of each layer
            std::vector<float> map;
            for (int y = 1; y < kSize.y; y += kStep)
                for (int x = 1; x < kSize.x; x += kStep) {
                    const Probe probe = picture.probe(x, y);
                    if (!probe.find<MapProbe>()) continue;
                    if (map.empty()) map = readMap(probe.find<MapProbe>()->layers);
                    const ivec2 texel = probe.find<MapProbe>()->texel;
                    if (texel.x < 0 || texel.y < 0 || texel.x >= kResolution || texel.y >= kResolution) continue;
                    const float drawn = map[static_cast<std::size_t>(
                        (probe.find<MapProbe>()->layer * kResolution + texel.y) * kResolution + texel.x)];
                    ++compared;
                    filled += drawn < 1;
                    // Float positions move a vertex by 2^-24 of its distance, and a texel's centre along a slope with it: 1e-5 of
                    // the range is far below the bias, and a hundredth of a metre here. Beyond it another surface was hit.
                    const bool differs = std::abs(drawn - probe.find<MapProbe>()->stored) > 1e-5;
                    differing += differs;
                    unexplained +=
                        differs && !edges.try_emplace(probe.find<MapProbe>()->layer, triangles, *probe.find<MapProbe>()).first->second(texel);
                    withoutOffset += std::abs(drawn - probe.find<MapProbe>()->first) > 1e-5;
                }
        }
    std::cout << compared << " texels, " << filled << " of them filled, " << differing << " differ, " << unexplained
              << " of them not at an edge; from the first surface's own depth " << withoutOffset << " differ\n";
    EXPECT_GT(compared, 1000);
    EXPECT_GT(filled, 300);
    EXPECT_GT(withoutOffset, 100) << "or the offset would not be tested";
    EXPECT_EQ(unexplained, 0)
        << "only a centre that an edge passes within the rasteriser's 1/256 may see another surface";
    EXPECT_LE(differing, compared / 200) << "of edges there are few";
}

/// Does the eye see the same triangle in a small square around the pixel's centre? The rasteriser moves corners to the next 256th.
bool isClear(const trace::ExactVisibility& judge, const scene::Scene& scene, int x, int y) {
    const auto middle = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize);
    for (const dvec2 aside : {dvec2(-1, -1), dvec2(1, -1), dvec2(-1, 1), dvec2(1, 1)}) {
        const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5 + aside / 256.0, kSize);
        if (!hit || !middle || hit->object != middle->object || hit->triangle != middle->triangle) return false;
    }
    return true;
}

struct Agreement {
    int compared = 0, shadowed = 0, certain = 0, unclear = 0, turnedByRounding = 0;
    int atBorder = 0, atDepth = 0, atEdge = 0;
    double largest = 0; ///< deviation of those that nothing is in doubt of
};

/// Every pixel of a grid: the picture must have an answer that rounding allows, and the probe's own where none is in doubt.
void compareWithPicture(const scene::Light& light, const std::vector<std::string>& settings, Agreement& all,
                        const std::string& technique = "shadow-map") {
    const auto scene = testing::snapshot(withLight(light));
    const trace::ExactVisibility judge(scene);
    const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(*scene);
    const bool hasMap = technique != "shadow-map-alias-free"; // which has no parameters
    ProbedPicture picture(scene, technique, hasMap ? with(settings) : settings, kSize);
    std::map<int, testing::EdgeTexels> edges; // of each layer
    std::string name = technique + " ";
    for (const std::string& setting : settings)
        name += setting + " ";
    // Half a step of the picture's 8 bits; the weights of hw2x2 are shares of a texel, as exact as places are.
    constexpr double kRounding = 0.6 / 255 + 2 * testing::MapMargin::kPlaceTexels;
    for (int y = 1; y < kSize.y; y += kCoarseStep)
        for (int x = 1; x < kSize.x; x += kCoarseStep) {
            const Probe probe = picture.probe(x, y);
            if (!probe.decision) continue;
            if (!isClear(judge, *scene, x, y)) {
                ++all.unclear;
                continue;
            }
            ++all.compared;
            const double drawn = picture.visibility().grey(x, y) / 255.0, told = probe.decision->visibility;
            all.shadowed += drawn < 0.5;
            testing::PossibleAnswer possible{told, told};
            const bool fades = std::ranges::find(probe.facts, "share of the next cascade in the answer",
                                                 &Probe::Fact::label) != probe.facts.end();
            if (probe.find<MapProbe>() && !probe.decision->isTurnedAway && !fades) {
                const int layer = probe.find<MapProbe>()->layer;
                const auto known = edges.try_emplace(layer, triangles, *probe.find<MapProbe>()).first;
                const testing::PossibleAnswer ofTaps =
                    testing::MapMargin(*probe.find<MapProbe>(), known->second).of(probe.find<MapProbe>()->taps);
                if (!ofTaps.isCertain()) possible = ofTaps;
            }
            all.atBorder += possible.atBorder > 0;
            all.atDepth += possible.atDepth > 0;
            all.atEdge += possible.atEdge > 0;
            if (possible.isCertain()) {
                ++all.certain;
                all.largest = std::max(all.largest, std::abs(drawn - told));
            }
            all.turnedByRounding += !possible.isCertain() && std::abs(drawn - told) > kRounding;
            EXPECT_GE(drawn, possible.low - kRounding)
                << name << static_cast<int>(light.type) << " at " << x << "," << y << ", told " << told;
            EXPECT_LE(drawn, possible.high + kRounding)
                << name << static_cast<int>(light.type) << " at " << x << "," << y << ", told " << told;
        }
}

TEST_F(MapProbeTest, DecidesAsThePictureDoesWhereRoundingCannotDecideOtherwise) {
    scene::Light spot = testing::pointLight({2, 5, 3});
    spot.type = scene::LightType::spot;
    spot.directionWorld = glm::normalize(dvec3(-2, -5, -3));
    spot.coneDegrees = 70;
    Agreement biased, unbiased;
    const std::vector<scene::Light> lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}),
                                              spot, testing::pointLight({0.2, 0.7, 0.1})};
    for (const scene::Light& light : lights)
        for (const std::vector<std::string>& settings : {std::vector<std::string>{"filter=hard", "bias-mode=none"},
                                                         {"filter=hard"},
                                                         {"filter=pcf", "pcf-radius=2"},
                                                         {"filter=hw2x2"},
                                                         {"filter=disc", "disc-radius=3", "samples=24"},
                                                         {"filter=disc", "noise=pixel"},
                                                         {"filter=hard", "bias-mode=constant"},
                                                         {"filter=hard", "bias-mode=normal-offset"},
                                                         {"filter=pcf", "bias-mode=adaptive"},
                                                         {"filter=pcf", "bias-mode=slope-scaled"},
                                                         {"filter=hard", "bias-mode=dual-depth"},
                                                         {"filter=pcf", "cascades=3", "depth-bounds=camera"}})
            compareWithPicture(light, settings, std::ranges::count(settings, "bias-mode=none") > 0 ? unbiased : biased);
    for (const scene::Light& light : lights)
        for (const char* technique : {"shadow-map-exact", "shadow-map-alias-free"})
            compareWithPicture(light, {}, biased, technique);
    for (const auto& [name, all] : {std::pair("with a bias", biased), std::pair("without", unbiased)})
        std::cout << name << ": " << all.compared << " pixels, " << all.shadowed << " in shadow, " << all.certain
                  << " certain (largest deviation " << all.largest << "), in doubt at a texel's border " << all.atBorder
                  << ", by depth " << all.atDepth << ", at an edge " << all.atEdge << "; of these "
                  << all.turnedByRounding << " turned over; left out " << all.unclear
                  << " at the edge of what the eye sees\n";
    EXPECT_GT(biased.compared, 2000);
    EXPECT_GT(biased.shadowed, 300);
    EXPECT_GT(biased.certain, biased.compared * 4 / 5) << "or little would be tested";
    EXPECT_GT(unbiased.certain, unbiased.compared / 2);
}

// Each kind of error has the settings that make it, and its name.
TEST_F(MapProbeTest, NamesTheErrorThatItMakes) {
    scene::Scene low = testing::simpleScene(); // a sheet near the floor: most of the shadow that a large bias loses
    testing::addObject(low, scene::makeBox({2, 0.02, 2}), testing::translation({-2, 0.3, 1}));
    const auto scene = testing::snapshot(low);
    const auto named = [&](std::vector<std::string> settings) {
        settings.emplace_back("resolution=64");
        ProbedPicture picture(scene, "shadow-map", settings, kSize);
        std::map<std::string, int> names;
        for (int y = 1; y < kSize.y; y += 2)
            for (int x = 1; x < kSize.x; x += 2) {
                const Probe probe = picture.probe(x, y);
                if (!probe.decision || probe.decision->why.empty()) continue;
                ++names[probe.decision->why.substr(0, probe.decision->why.find(':'))];
            }
        for (const auto& [name, count] : names)
            std::cout << settings[1] << ": " << name << " " << count << "\n";
        return names;
    };
    auto none = named({"filter=hard", "bias-mode=none"});
    EXPECT_GT(none["acne"], 30);
    auto much = named({"filter=hard", "bias-mode=constant", "bias-unit=metres", "constant-bias=0.6"});
    EXPECT_GT(much["peter-panning"], 10);
    EXPECT_EQ(much["acne"], 0);
    auto right = named({"filter=hard", "bias-mode=receiver-plane"});
    EXPECT_EQ(right["acne"], 0);
    EXPECT_GT(right["aliasing"], 1);
}

} // namespace
} // namespace shadowlab
