// Every filter with every bias and every kind of map.
//   M25 from 0 to 1           EveryCombinationGivesVisibilities
//   reach of the kernels      BeyondTheKernelsReachAllIsRight, WideKernelsSeeNoSeamBetweenSixMaps
//                             naive: bias-mode=none, slope-bias=0
//   edges of what is asked    CullingCutsNoPenumbraOff
// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/shadow_map/bias/biases.h"
#include "techniques/shadow_map/filters/filters.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::JudgedPicture;
using testing::ShadowMapSlot;
using testing::TieRadius;
using CombinationsTest = testing::GlTest;
using Settings = std::vector<std::string>;

constexpr ivec2 kPictureSize{160, 120};

template <typename Table>
Settings namesOf(const Table& table) {
    Settings names;
    for (const auto& entry : table)
        names.emplace_back(entry.name);
    return names;
}
const Settings kFilters = namesOf(shadow_map::filters()), kModes = namesOf(shadow_map::biases());

using enum scene::LightType;
struct MapKind {
    const char* name;
    scene::LightType light;
    const char* setting; ///< cascades=1 is the default
};
constexpr MapKind kSixMaps{"six maps", point, "cascades=1"}, kSquare{"square", rect, "cascades=1"};
constexpr MapKind kMapKinds[] = {kSixMaps,
                                 {"spot", spot, "cascades=1"},
                                 {"sun", directional, "cascades=1"},
                                 {"cascades", directional, "cascades=3"},
                                 {"warped", directional, "warp=lispsm"},
                                 kSquare,
                                 {"ball", sphere, "cascades=1"}};

/// The simple scene under a light for that kind of map. One with an area is `size` metres wide.
scene::Snapshot simpleUnder(const MapKind& kind, double size, bool floorCasts = true) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[0].castsShadow = floorCasts;
    scene::Light& light = scene.lights[0];
    light.type = kind.light;
    light.edgeUWorld = {size, 0, 0};
    light.edgeVWorld = {0, 0, size};
    light.radius = 0.5 * size;
    light.directionWorld =
        kind.light == directional ? glm::normalize(dvec3(0.5, -1, 0.25)) : glm::normalize(dvec3(-0.4, -1, -0.6));
    if (kind.light == point) light.positionWorld = {0, 1, 0}; // among the casters
    return testing::snapshot(scene);
}

Settings settingsFor(const MapKind& kind, const std::string& filter, int resolution) {
    return {kind.setting, "filter=" + filter, "resolution=" + std::to_string(resolution)};
}

// M25. Bias, filter and the choice of a map are a file of GLSL each. Where there is one map all are tried with all; where there
// are several, each bias and each filter with the choice.
TEST_F(CombinationsTest, EveryCombinationGivesVisibilities) {
    constexpr ivec2 kSize{96, 72};
    const scene::Snapshot amidCasters = simpleUnder(kSixMaps, 0);
    ASSERT_EQ(testing::sceneMaps(*amidCasters, amidCasters->lights[0], 128, 1).layers(), 6);
    ShadowMapSlot slot(amidCasters);
    int pictures = 0;
    for (const MapKind& kind : kMapKinds) {
        slot.setScene(simpleUnder(kind, 0.2));
        for (const std::string& filter : kFilters)
            for (const std::string& mode : kModes) {
                const bool several = kind.light == point || std::string(kind.setting) == "cascades=3";
                if (several && filter != "pcf" && mode != "receiver-plane") continue;
                Settings settings = settingsFor(kind, filter, 128);
                settings.insert(settings.end(), {"bias-mode=" + mode, "light-radius=0.05"});
                const judge::Grid<float> image = slot.shares(settings, kSize, 0);
                int lit = 0, dark = 0, outside = 0;
                for (const float v : image.values) {
                    if (v == -1) continue;                                             // no surface
                    lit += v > 0.9f, dark += v < 0.1f, outside += !(v >= 0 && v <= 1); // or not a number
                }
                EXPECT_EQ(outside, 0) << kind.name << " " << filter << " " << mode;
                EXPECT_GT(lit, 300) << kind.name << " " << filter << " " << mode;
                EXPECT_GT(dark, 50) << kind.name << " " << filter << " " << mode;
                EXPECT_NO_THROW(gl::check(filter)) << kind.name << " " << filter << " " << mode;
                ++pictures;
            }
    }
    ASSERT_GE(kFilters.size(), 9u);
    ASSERT_GE(kModes.size(), 7u);
    const int filters = static_cast<int>(kFilters.size()), modes = static_cast<int>(kModes.size());
    EXPECT_EQ(pictures, 5 * filters * modes + 2 * (filters + modes - 1));
}

/// How much brighter or darker than the truth pixels are that lie farther from its edges than the kernel reaches.
struct Beyond {
    int lit = 0, shadowed = 0, near = 0; ///< in truth; and wrong, but within reach
    int wrong = 0;                       ///< by a hundredth at least
};
std::ostream& operator<<(std::ostream& stream, const Beyond& b) {
    return stream << b.lit << " lit, " << b.shadowed << " shadowed, " << b.near << " near an edge, " << b.wrong
                  << " wrong beyond the kernel's reach";
}

Beyond beyond(const JudgedPicture& judged, const judge::Grid<float>& image) {
    Beyond result;
    for (int y = 0; y < judged.size().y; ++y)
        for (int x = 0; x < judged.size().x; ++x) {
            const trace::Visibility truth = judged.truth(x, y);
            const bool lit = truth == trace::Visibility::lit;
            if (!lit && truth != trace::Visibility::shadowed) continue;
            ++(lit ? result.lit : result.shadowed);
            if (std::abs(image.at(x, y) - (lit ? 1 : 0)) < 0.01f) continue;
            ++(judged.isTie(x, y) ? result.near : result.wrong);
        }
    EXPECT_GT(result.lit, 2000);
    EXPECT_GT(result.shadowed, 200);
    return result;
}

/// And edges are not everywhere: else nothing would have been compared.
bool isRight(const Beyond& b) { return b.wrong == 0 && b.near < (b.lit + b.shadowed) / 10; }

/// Of a light that is so large the widest penumbra that anything can cast on the point, to each side, and `texels` more.
TieRadius penumbraReach(const scene::Snapshot& snapshot, double halfWidth, const TieRadius& texels) {
    const scene::Light& source = snapshot->lights[0];
    const bool parallel = source.type == scene::LightType::directional;
    const std::vector<scene::Bounds> bounds = scene::objectBounds(*snapshot);
    double nearest = 1e300, highest = 0;
    for (const std::size_t caster : scene::usefulCasters(*snapshot, source)) {
        const dvec3& light = source.positionWorld;
        nearest = std::min(
            nearest, glm::length(light - glm::clamp(light, bounds[caster].lowerWorld, bounds[caster].upperWorld)));
        highest = std::max(highest, bounds[caster].upperWorld.y);
    }
    return [=](const std::optional<trace::EyeHit>& hit) {
        if (!hit) return texels(hit);
        const dvec3 offset = source.positionWorld - hit->positionWorld;
        const dvec3 toLight = parallel ? -source.directionWorld : glm::normalize(offset);
        const double magnified = parallel ? highest / toLight.y : glm::length(offset) / nearest - 1;
        const double cosine = std::max(0.02, std::abs(glm::dot(toLight, hit->geometricNormalWorld)));
        const double tanHalf = std::tan(snapshot->camera.fovYDegrees * glm::pi<double>() / 360.0);
        return texels(hit) + halfWidth * magnified / cosine * kPictureSize.y / (2 * tanHalf * hit->distance);
    };
}

// Texels: the corner of a kernel is (r + 1/2) sqrt(2) away, and a comparison a texel off by the bias. Moments are averaged over
// 3 x 3 texels and then interpolated, so over 5 x 5. In this scene nothing lies behind two casters, so that no light bleeds.
TEST_F(CombinationsTest, BeyondTheKernelsReachAllIsRight) {
    constexpr double kHalfWidth = 0.02;
    ShadowMapSlot slot(simpleUnder(kSixMaps, 0));
    int naive = 0;
    for (const MapKind& kind : kMapKinds) {
        const scene::Snapshot snapshot = simpleUnder(kind, 2 * kHalfWidth);
        slot.setScene(snapshot);
        const int resolution = kind.light == point ? 512 : 1024; // of each of six
        const auto reach = [&](double texels) {
            return testing::edgeReach(snapshot, 0, resolution, kPictureSize, texels);
        };
        const auto compare = [&](const JudgedPicture& judged, const std::string& filter, const char* bias) {
            Settings settings = settingsFor(kind, filter, resolution);
            settings.insert(settings.end(), {bias, "light-radius=" + std::to_string(kHalfWidth)});
            const Beyond b = beyond(judged, slot.shares(settings, kPictureSize, 0));
            std::cout << kind.name << " " << filter << " " << bias << ": " << b << "\n";
            return b;
        };
        if (kind.light != sphere) { // which is where the square is, and has the same map
            const JudgedPicture kernels(snapshot, kPictureSize, 0, reach(4.0));
            for (const char* filter : {"hard", "hw2x2", "pcf", "disc", "vsm", "esm", "evsm", "msm"})
                EXPECT_TRUE(isRight(compare(kernels, filter, "bias-mode=receiver-plane")))
                    << kind.name << " " << filter;
            naive += compare(kernels, "hard", "bias-mode=none").wrong;
        }
        const JudgedPicture penumbrae(snapshot, kPictureSize, 0, penumbraReach(snapshot, kHalfWidth, reach(2.0)));
        EXPECT_TRUE(isRight(compare(penumbrae, "pcss", "bias-mode=receiver-plane"))) << kind.name;
    }
    EXPECT_GT(naive, 500);
}

// Boxes across the diagonals, where two of the six maps meet, and kernels of many texels: none may look beyond its own map. The
// floor slants within each of them; so this also shows what becomes of evsm and msm whose bias does not cover that.
TEST_F(CombinationsTest, WideKernelsSeeNoSeamBetweenSixMaps) {
    constexpr int kResolution = 512;
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight({0, 1, 0}));
    for (const dvec3 at : {dvec3(1, 0.25, 1), dvec3(-1, 0.25, 1), dvec3(1, 0.25, -1), dvec3(-1, 0.25, -1)})
        testing::addObject(scene, scene::makeBox({0.4, 0.5, 0.4}), testing::translation(at));
    const auto snapshot = testing::snapshot(scene);
    ASSERT_EQ(testing::sceneMaps(scene, scene.lights[0], kResolution, 1).layers(), 6);
    ShadowMapSlot slot(snapshot);
    // (8 + 1/2) sqrt(2) texels, and of moments one more.
    const JudgedPicture judged(snapshot, kPictureSize, 0,
                               testing::edgeReach(snapshot, 0, kResolution, kPictureSize, 13.5));
    const auto compare = [&](const std::string& filter, const char* bias) {
        Settings settings = settingsFor(kSixMaps, filter, kResolution);
        settings.insert(settings.end(), {"pcf-radius=8", "disc-radius=12", "blur-radius=8", bias});
        const Beyond b = beyond(judged, slot.shares(settings, kPictureSize, 0));
        std::cout << filter << " " << bias << ": " << b << "\n";
        return b;
    };
    for (const char* filter : {"pcf", "disc", "vsm", "esm", "evsm", "msm"})
        EXPECT_TRUE(isRight(compare(filter, "slope-bias=1"))) << filter;
    for (const char* filter : {"evsm", "msm"})
        EXPECT_GT(compare(filter, "slope-bias=0").wrong, 1000) << filter;
}

// The map is asked only in that part of the picture where a shadow can fall; with kernels so wide that is more than where
// shadows would have hard edges. There is no naive variant: the guard bands that see to it cannot be turned off.
TEST_F(CombinationsTest, CullingCutsNoPenumbraOff) {
    ShadowMapSlot slot(simpleUnder(kSixMaps, 0));
    for (const MapKind& kind : kMapKinds)
        for (const char* filter : {"hw2x2", "pcf", "disc", "pcss", "vsm", "evsm"}) {
            // Culling leaves the floor out of the map, which shadows nothing; seen from the foot of a wall it would be nearer to
            // the light than the wall is, and the search of PCSS would take it for a blocker.
            slot.setScene(simpleUnder(kind, 0.5, std::string(filter) != "pcss"));
            Settings settings = settingsFor(kind, filter, 256);
            settings.insert(settings.end(), {"pcf-radius=6", "disc-radius=16", "blur-radius=8", "light-radius=0.2"});
            const auto with = slot.shares(settings, kPictureSize, 0);
            settings.emplace_back("cull=false");
            const auto without = slot.shares(settings, kPictureSize, 0);
            int differing = 0, between = 0;
            for (std::size_t i = 0; i < with.values.size(); ++i) {
                differing += with.values[i] != without.values[i];
                between += with.values[i] > 0 && with.values[i] < 1;
            }
            EXPECT_EQ(differing, 0) << kind.name << " " << filter;
            // Of hw2x2 a ramp is a texel wide, a third of a pixel.
            EXPECT_GT(between, 20) << kind.name << " " << filter;
        }
}

} // namespace
} // namespace shadowlab
