// A scene that fails is made as small as what fails in it, whatever that is.
// SPDX-License-Identifier: MIT
#include "app/student/search/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/student/search/building_blocks.h"
#include "app/student/search/random_scenes.h"

namespace shadowlab::student {
namespace {

const SearchObject* objectNamed(const SearchScene& scene, const std::string& name) {
    const auto found = std::ranges::find(scene.objects, name, &SearchObject::name);
    return found == scene.objects.end() ? nullptr : &*found;
}

SearchScene bigScene() {
    SearchScene scene;
    scene.eyeWorld = {1.37, 2.41, 5.93};
    scene.objects = {floorOf(20), box("box", {1, 0.5, 0.13}, {1, 1, 1}, 25), ball("ball", {-1, 1, 0}, 0.5), star("star", {0, 1, 2}, {1, 1, 1}, 5)};
    scene.lights = {lamp({2.17, 3.33, 1}, 40), sun({-1, -1, 0.2})};
    return scene;
}

TEST(ShrinkTest, WhatHasNothingToDoWithItIsTakenAway) {
    int asked = 0;
    // It fails with a lamp and a ball that still has a triangle, and no other thing.
    const auto fails = [&](const SearchScene& scene) {
        ++asked;
        return objectNamed(scene, "ball") != nullptr && std::ranges::count(scene.lights, false, &SearchLight::isSun) == 1;
    };
    const Shrunk shrunk = shrink(bigScene(), fails, [] { return true; });
    EXPECT_EQ(shrunk.attempts, asked);
    ASSERT_EQ(shrunk.scene.objects.size(), 1u);
    EXPECT_EQ(triangleCount(shrunk.scene), 1) << "of 80 in the ball, and " << triangleCount(bigScene()) << " in all";
    EXPECT_EQ(shrunk.scene.objects[0].cornersWorld.size(), 3u) << "corners of no triangle go as well";
    ASSERT_EQ(shrunk.scene.lights.size(), 1u);
    for (const double number : {shrunk.scene.eyeWorld.x, shrunk.scene.eyeWorld.y, shrunk.scene.lights[0].place.x})
        EXPECT_EQ(number, std::round(number)) << "a round number does";
    EXPECT_TRUE(fails(shrunk.scene));
}

TEST(ShrinkTest, WhatIsNeededStays) {
    // It fails as long as the star has seven triangles, and the eye is beyond 5.5.
    const auto fails = [](const SearchScene& scene) {
        const SearchObject* const star = objectNamed(scene, "star");
        return star && star->triangles.size() >= 7 && scene.eyeWorld.z > 5.5;
    };
    const Shrunk shrunk = shrink(bigScene(), fails, [] { return true; });
    EXPECT_EQ(triangleCount(shrunk.scene), 7);
    EXPECT_EQ(shrunk.scene.eyeWorld.z, 6);
}

TEST(ShrinkTest, ItEndsWhenTheTimeIsOver) {
    int left = 3;
    const Shrunk shrunk = shrink(bigScene(), [](const SearchScene&) { return true; }, [&] { return left-- > 0; });
    EXPECT_LE(shrunk.attempts, 3);
    EXPECT_EQ(shrunk.scene.objects.size() + shrunk.scene.lights.size(), bigScene().objects.size() + bigScene().lights.size() - shrunk.attempts + 0u);
}

TEST(RandomScenesTest, TheSameSeedMakesTheSameScenes) {
    std::set<std::string> texts;
    int scenes = 0;
    for (const Family& family : families())
        for (int number = 0; number < 20; ++number, ++scenes) {
            const auto files = filesOf(randomScene(family, 5, number), "scene", "a scene");
            EXPECT_EQ(files, filesOf(randomScene(family, 5, number), "scene", "a scene"));
            EXPECT_NE(files, filesOf(randomScene(family, 6, number), "scene", "a scene")) << family.id << " " << number;
            std::string all;
            for (const auto& [name, text] : files)
                all += text;
            texts.insert(all);
            EXPECT_LE(triangleCount(randomScene(family, 5, number)), 200);
        }
    EXPECT_EQ(static_cast<int>(texts.size()), scenes) << "no two are alike";
    EXPECT_GE(scenes, 100);
}

TEST(RandomScenesTest, EveryBlankIsWhatSomeKindIsAbout) {
    const std::map<std::string_view, int> counts = {{"planar", 4}, {"shadow-map", 5}, {"shadow-volume", 7}, {"ray-tracing", 8}, {"radiosity", 5}};
    for (const Family& family : families()) {
        std::set<int> about;
        for (const SceneKind& kind : kindsOf(family))
            about.insert(kind.blanks.begin(), kind.blanks.end());
        EXPECT_EQ(static_cast<int>(about.size()), counts.at(family.id)) << family.id;
        EXPECT_EQ(*about.rbegin(), counts.at(family.id)) << family.id;
        EXPECT_GE(kindsOf(family).size(), 8u) << family.id;
    }
}

} // namespace
} // namespace shadowlab::student
