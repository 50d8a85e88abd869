// The same picture elsewhere: scene, eye and lights moved together by a million metres, or made ten thousand times smaller or
// larger, have the same shadows for all three ways to count. And what rounds to float in the world has not.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/shadow_volume/volume_case.h"
#include "tests/support/hard_scenes.h"

namespace shadowlab {
namespace {

using testing::HardClass;

/// Places to a multiple of 2^-20, a micrometre: a million metres farther on they are doubles still, and the same.
scene::Scene onGrid(scene::Scene scene) {
    const auto snap = [](dvec3& place) { place = glm::round(place * 0x1p20) * 0x1p-20; };
    snap(scene.camera.positionWorld);
    snap(scene.camera.targetWorld);
    for (scene::Light& light : scene.lights)
        snap(light.positionWorld);
    for (scene::Object& object : scene.objects)
        for (int axis = 0; axis < 3; ++axis)
            object.worldFromObject[3][axis] = std::round(object.worldFromObject[3][axis] * 0x1p20) * 0x1p-20;
    return scene;
}

/// By a power of two: every number stays what it is but for its exponent, so that the two scenes are alike exactly. With
/// 1e-4 itself corners would round to other places of the grid of doubles, and their shadows with them.
scene::Scene scaled(scene::Scene scene, double factor) {
    scene.camera.positionWorld *= factor;
    scene.camera.targetWorld *= factor;
    scene.camera.near *= factor;
    scene.camera.far *= factor;
    for (scene::Light& light : scene.lights) {
        light.positionWorld *= factor;
        light.edgeUWorld *= factor;
        light.edgeVWorld *= factor;
        light.radius *= factor;
    }
    for (scene::Object& object : scene.objects)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                object.worldFromObject[column][row] *= factor;
    return scene;
}

/// The vertices themselves, at their place in the world.
scene::Scene withPlacesInFloat(scene::Scene scene) {
    for (scene::Object& object : scene.objects) {
        scene::Mesh mesh = *object.mesh;
        for (vec3& position : mesh.positionsMesh)
            position = vec3(transformPoint(scene::worldFromMesh(object), dvec3(position)));
        object.mesh = scene::sharedMesh(mesh);
        object.worldFromObject = dmat4(1.0);
    }
    return scene;
}

using Change = std::function<scene::Scene(const scene::Scene&)>;

Change movedBy(const dvec3& offset) {
    return [=](const scene::Scene& scene) { return testing::moved(scene, offset); };
}
Change scaledBy(double factor) {
    return [=](const scene::Scene& scene) { return scaled(scene, factor); };
}

/// Pixels of all pictures.
struct Differing {
    double pixels = 0, differing = 0, lit = 0, dark = 0;
};

class SameElsewhere : public testing::VolumeCase {
protected:
    static std::vector<scene::Scene> smallScenes() {
        scene::Scene simple = testing::simpleScene();
        simple.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
        std::vector<scene::Scene> scenes = {onGrid(simple)};
        for (const HardClass hardClass : testing::kHardClasses)
            for (const bool directional : {false, true})
                scenes.push_back(testing::hardScene(hardClass, 2, directional));
        return scenes;
    }
    static std::vector<scene::Scene> builtInScenes() {
        std::vector<scene::Scene> scenes;
        const auto root = context::assetsRoot();
        for (const std::string& name : scene::builtInScenes(root))
            scenes.push_back(onGrid(*scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}})));
        return scenes;
    }

    /// How much of the pictures, for all lights and ways, is another after each of the changes.
    static std::vector<Differing> compare(const std::vector<scene::Scene>& scenes, const std::vector<Change>& changes) {
        std::vector<Differing> sums(changes.size());
        for (const scene::Scene& scene : scenes) {
            const std::vector<picture::VisibilityImage> here = pictures(scene);
            for (std::size_t c = 0; c < changes.size(); ++c) {
                const std::vector<picture::VisibilityImage> there = pictures(changes[c](scene));
                for (std::size_t i = 0; i < here.size(); ++i)
                    add(sums[c], here[i], there[i]);
            }
        }
        for (const Differing& sum : sums) {
            EXPECT_GT(sum.lit, sum.pixels / 10);
            EXPECT_GT(sum.dark, sum.pixels / 10);
        }
        return sums;
    }

private:
    /// For all lights and ways; with SHADOWLAB_LONG=1 for each way before and after repair.
    static std::vector<picture::VisibilityImage> pictures(const scene::Scene& scene) {
        const scene::Snapshot snapshot = testing::snapshot(scene);
        std::vector<picture::VisibilityImage> pictures;
        const auto add = [&](const testing::ExactWay& way, int light, const char* setting) {
            std::vector<std::string> settings = way.settings;
            if (setting) settings.emplace_back(setting);
            pictures.push_back(testing::renderVisibility(snapshot, way.technique, settings, {192, 108}, light));
        };
        for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light)
            for (const testing::ExactWay& way : testing::kExactWays) {
                if (!std::getenv("SHADOWLAB_LONG")) {
                    add(way, light, nullptr);
                    continue;
                }
                add(way, light, "repair=false");
                add(way, light, "repair=true");
            }
        return pictures;
    }
    static void add(Differing& sum, const picture::VisibilityImage& a, const picture::VisibilityImage& b) {
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                ++sum.pixels;
                ++(a.grey(x, y) > 127 ? sum.lit : sum.dark);
                sum.differing += a.grey(x, y) != b.grey(x, y) || a.alpha(x, y) != b.alpha(x, y);
            }
    }
};

// One pixel in a million: a corner's place on the screen may round the other way in the last bit of a float.
constexpr double kShare = 1e-6;

TEST_F(SameElsewhere, MovedByAMillionMetresOrTenThousandTimesSmallerOrLarger) {
    for (const std::vector<scene::Scene>& scenes : {smallScenes(), builtInScenes()})
        for (const Differing& sum :
             compare(scenes, {movedBy({1e6, 0, 0}), movedBy({-1e6, 1e6, 1e6}), scaledBy(0x1p-13), scaledBy(0x1p13)})) {
            std::cout << sum.differing << " of " << sum.pixels << " pixels differ\n";
            EXPECT_LE(sum.differing, kShare * sum.pixels);
        }
}

TEST_F(SameElsewhere, ButNotWithPlacesInFloat) {
    const auto inFloat = [](const Change& change) -> Change {
        return [=](const scene::Scene& scene) { return withPlacesInFloat(change(scene)); };
    };
    const auto sums = compare(smallScenes(), {inFloat(movedBy({0, 0, 0})), inFloat(movedBy({1e6, 0, -1e6}))});
    EXPECT_LE(sums[0].differing, 1e-3 * sums[0].pixels) << "near the origin a float is good enough";
    EXPECT_GT(sums[1].differing, 1e-2 * sums[1].pixels);
}

} // namespace
} // namespace shadowlab
