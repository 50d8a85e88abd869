// What the probe of the shadow map says a texel holds, against the map that the graphics card drew; and what it decides, against
// the picture.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <map>

#include "techniques/foundation/scene/shapes.h"
#include "tests/support/gl_fixture.h"
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
    int compared = 0, filled = 0, differing = 0, withoutOffset = 0;
    for (const scene::Light& light : {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}),
                                      testing::pointLight({0.2, 0.7, 0.1})})
        for (const char* bias : {"none", "slope-scaled", "receiver-plane", "dual-depth"}) {
            const auto scene = testing::snapshot(withLight(light));
            ProbedPicture picture(scene, "shadow-map", with({"filter=hard", std::string("bias-mode=") + bias}), kSize);
            std::vector<float> map;
            for (int y = 1; y < kSize.y; y += kStep)
                for (int x = 1; x < kSize.x; x += kStep) {
                    const Probe probe = picture.probe(x, y);
                    if (!probe.map) continue;
                    if (map.empty()) map = readMap(probe.map->layers);
                    const ivec2 texel = probe.map->texel;
                    if (texel.x < 0 || texel.y < 0 || texel.x >= kResolution || texel.y >= kResolution) continue;
                    const float drawn = map[static_cast<std::size_t>(
                        (probe.map->layer * kResolution + texel.y) * kResolution + texel.x)];
                    ++compared;
                    filled += drawn < 1;
                    // Float positions move a vertex by 2^-24 of its distance, and a texel's centre along a slope with it: 1e-5 of
                    // the range is far below the bias, and a hundredth of a metre here. Beyond it another surface was hit.
                    differing += std::abs(drawn - probe.map->stored) > 1e-5;
                    withoutOffset += std::abs(drawn - probe.map->first) > 1e-5;
                }
        }
    std::cout << compared << " texels, " << filled << " of them filled, " << differing << " differ, of the first\n"
              << "surface's own depth " << withoutOffset << "\n";
    EXPECT_GT(compared, 1000);
    EXPECT_GT(filled, 300);
    EXPECT_GT(withoutOffset, 100) << "or the offset would not be tested";
    EXPECT_LE(differing, compared / 200) << "centres of texels that an edge passes within the rasteriser's 1/256";
}

TEST_F(MapProbeTest, DecidesAsThePictureDoes) {
    int compared = 0, shadowed = 0;
    scene::Light spot = testing::pointLight({2, 5, 3});
    spot.type = scene::LightType::spot;
    spot.directionWorld = glm::normalize(dvec3(-2, -5, -3));
    spot.coneDegrees = 70;
    for (const scene::Light& light : {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}), spot,
                                      testing::pointLight({0.2, 0.7, 0.1})})
        for (const std::vector<std::string>& settings : {std::vector<std::string>{"filter=hard", "bias-mode=none"},
                                                         {"filter=hard"},
                                                         {"filter=pcf", "pcf-radius=2"},
                                                         {"filter=hw2x2"},
                                                         {"filter=hard", "bias-mode=constant"},
                                                         {"filter=hard", "bias-mode=normal-offset"},
                                                         {"filter=pcf", "bias-mode=adaptive"},
                                                         {"filter=pcf", "bias-mode=slope-scaled"},
                                                         {"filter=hard", "bias-mode=dual-depth"},
                                                         {"filter=pcf", "cascades=3", "depth-bounds=camera"}}) {
            const auto scene = testing::snapshot(withLight(light));
            ProbedPicture picture(scene, "shadow-map", with(settings), kSize);
            int here = 0, differing = 0;
            for (int y = 1; y < kSize.y; y += kCoarseStep)
                for (int x = 1; x < kSize.x; x += kCoarseStep) {
                    const Probe probe = picture.probe(x, y);
                    if (!probe.decision) continue;
                    ++here;
                    const double drawn = picture.visibility().grey(x, y) / 255.0;
                    shadowed += drawn < 0.5;
                    // One of the filter's comparisons may fall the other way by rounding: of 25 that is 0.04.
                    differing += std::abs(drawn - probe.decision->visibility) > 0.045;
                }
            compared += here;
            std::string name;
            for (const std::string& setting : settings)
                name += setting + " ";
            // Without a bias a surface is compared with itself, and rounding decides.
            const bool isNoise = settings.size() > 1 && settings[1] == "bias-mode=none";
            EXPECT_LE(differing, isNoise ? here / 20 : here / 100 + 1) << name << static_cast<int>(light.type);
        }
    EXPECT_GT(compared, 2000);
    EXPECT_GT(shadowed, 300);
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
