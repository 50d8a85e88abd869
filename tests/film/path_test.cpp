// Paths: exact values at and between the keys, nothing moves outside them, and what a path may not say.
// SPDX-License-Identifier: MIT
#include "app/film/path.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "app/film/motion.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/scenes.h"

namespace shadowlab::film {
namespace {

// Shares that are sums of powers of two: what the arithmetic gives is exact.
void expectExactly(const dvec3& a, const dvec3& b) { EXPECT_EQ(a, b) << a.x << ' ' << a.y << ' ' << a.z; }

scene::Snapshot lightsOfAllKinds() {
    return scene::parseSceneJson(R"({
        "camera": {"position": [0, 2, 8], "target": [0, 0, 0], "fovYDegrees": 40, "near": 0.5},
        "lights": [
            {"name": "key",   "type": "point", "position": [0, 4, 0], "intensity": 10},
            {"name": "sun",   "type": "directional", "direction": [0, -1, 0]},
            {"name": "lamp",  "type": "spot", "position": [1, 3, 0], "coneDegrees": 60, "edgeDegrees": 4},
            {"name": "panel", "type": "rect", "position": [0, 5, 0], "intensity": 2},
            {"name": "bulb",  "type": "sphere", "position": [3, 3, 3], "radius": 0.5}],
        "objects": [{"shape": "box", "size": [1, 1, 1]}]})",
                                 "kinds.json", {});
}

Path path(const std::string& text) { return parsePath(text, "x.json", *lightsOfAllKinds()); }

TEST(Path, GoesEvenlyFromKeyToKeyAndStandsStillOutside) {
    const Path p = path(R"([  // from the left, then back
        {"frame": 3, "camera": {"position": [-4, 2, 8]}, "lights": [{"name": "key", "intensity": 20, "color": [1, 0, 0]}]},
        {"frame": 7, "camera": {"position": [4, 6, 8], "fovYDegrees": 20}, "lights": [{"name": "key", "intensity": 60, "color": [0, 1, 0]}]},
        {"frame": 9, "camera": {"position": [0, 2, 8]}}])");
    EXPECT_EQ(p.lastFrame(), 9);
    for (const int before : {-1, 1, 2, 3})
        expectExactly(p.at(before).camera.positionWorld, {-4, 2, 8});
    expectExactly(p.at(4).camera.positionWorld, {-2, 3, 8});
    expectExactly(p.at(5).camera.positionWorld, {0, 4, 8});
    expectExactly(p.at(7).camera.positionWorld, {4, 6, 8});
    expectExactly(p.at(8).camera.positionWorld, {2, 4, 8});
    for (const int after : {9, 10, 1000})
        expectExactly(p.at(after).camera.positionWorld, {0, 2, 8});
    EXPECT_EQ(p.at(4).camera.fovYDegrees, 35);
    EXPECT_EQ(p.at(4).lights[0].intensity, 30);
    EXPECT_EQ(p.at(5).lights[0].color, vec3(0.5f, 0.5f, 0));
}

TEST(Path, WhatAKeyLeavesOutIsAsAtTheKeyBeforeElseAsInTheScene) {
    const Path p = path(R"([{"frame": 1, "lights": [{"name": "bulb", "radius": 1}]},
                            {"frame": 5, "camera": {"target": [0, 1, 0]}},
                            {"frame": 9, "lights": [{"name": "bulb", "position": [7, 3, 3]}]}])");
    const scene::Snapshot scene = lightsOfAllKinds();
    for (int frame = 1; frame <= 9; ++frame) {
        const CameraAndLights state = p.at(frame);
        EXPECT_EQ(state.camera.positionWorld, scene->camera.positionWorld);
        EXPECT_EQ(state.camera.near, 0.5);
        EXPECT_EQ(state.camera.far, scene->camera.far);
        EXPECT_EQ(state.lights[4].radius, 1);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(state.lights[i], scene->lights[i]) << frame;
    }
    expectExactly(p.at(3).camera.targetWorld, {0, 0.5, 0});
    expectExactly(p.at(9).camera.targetWorld, {0, 1, 0});
    expectExactly(p.at(5).lights[4].positionWorld, {3, 3, 3}); // it sets out where it was left standing
    expectExactly(p.at(6).lights[4].positionWorld, {4, 3, 3});
}

TEST(Path, EveryKeyOfALightMoves) {
    const Path p = path(R"([{"frame": 1}, {"frame": 3, "lights": [
        {"name": "sun", "direction": [5, 0, 0]},
        {"name": "lamp", "direction": [0, 0, -2], "coneDegrees": 40, "edgeDegrees": 8},
        {"name": "panel", "edgeU": [0, 0, 1], "edgeV": [2, 0, 0], "intensity": 6}]}])");
    const std::vector<scene::Light> lights = p.at(2).lights;
    const double half = std::sqrt(0.5);
    EXPECT_LT(glm::length(lights[1].directionWorld - dvec3(half, -half, 0)), 1e-15); // however long they were
    EXPECT_LT(glm::length(lights[2].directionWorld - dvec3(0, -half, -half)), 1e-15);
    EXPECT_EQ(lights[2].coneDegrees, 50);
    EXPECT_EQ(lights[2].edgeDegrees, 6);
    expectExactly(lights[3].edgeUWorld, {0.5, 0, 0.5});
    expectExactly(lights[3].edgeVWorld, {1, 0, 0.5});
    EXPECT_EQ(lights[3].intensity, 4);
    expectExactly(p.at(3).lights[1].directionWorld, {1, 0, 0});
}

TEST(Path, AFarPlaneIsFoundOnTheWayFromInfinityOnlyAtItsKey) {
    const Path p = path(R"([{"frame": 1}, {"frame": 3, "camera": {"far": 50}}, {"frame": 5, "camera": {"far": 30}}])");
    EXPECT_TRUE(std::isinf(p.at(2).camera.far));
    EXPECT_EQ(p.at(3).camera.far, 50);
    EXPECT_EQ(p.at(4).camera.far, 40);
}

/// A motion along a path, with the revisions of the moments before and after.
TEST(Path, OnlyWhatMovesGetsNewRevisions) {
    const scene::Snapshot base = lightsOfAllKinds();
    const auto second = [&](const std::string& lights) {
        Motion motion{2, {}, {}, path(R"([{"frame": 1}, {"frame": 2, "lights": [)" + lights + "]}]")};
        const Moment first = momentAt(motion, base, 0, base);
        EXPECT_EQ(first.snapshot, base);
        const Moment moment = momentAt(motion, base, 1, first.snapshot);
        EXPECT_EQ(momentAt(motion, base, 2, moment.snapshot).snapshot, moment.snapshot); // nothing moves any more
        return moment.snapshot;
    };
    struct Case {
        std::string lights;
        bool geometry, transforms, materials;
    };
    for (const Case& c : {Case{R"({"name": "key", "position": [1, 4, 0], "intensity": 3})", false, false, false},
                          Case{R"({"name": "bulb", "position": [1, 4, 0]})", false, true, false},
                          Case{R"({"name": "bulb", "radius": 0.25})", true, true, false},
                          Case{R"({"name": "panel", "edgeU": [3, 0, 0]})", true, true, false},
                          Case{R"({"name": "panel", "color": [1, 0, 0]})", false, false, true}}) {
        const scene::Revisions after = second(c.lights)->revisions, before = base->revisions;
        EXPECT_NE(after.lights, before.lights) << c.lights;
        EXPECT_EQ(after.geometry != before.geometry, c.geometry) << c.lights;
        EXPECT_EQ(after.transforms != before.transforms, c.transforms) << c.lights;
        EXPECT_EQ(after.materials != before.materials, c.materials) << c.lights;
    }
}

TEST(Path, SurfacesFollowTheirLights) {
    const scene::Snapshot base = lightsOfAllKinds();
    const Motion motion{3, {}, {}, path(R"([{"frame": 1}, {"frame": 3, "lights": [
        {"name": "bulb", "position": [5, 3, 3], "radius": 1.5, "intensity": 3},
        {"name": "panel", "position": [0, 5, 4], "edgeU": [4, 0, 0]}]}])")};
    const scene::Snapshot half = momentAt(motion, base, 1).snapshot;
    const auto surface = [&](int light) -> const scene::Object& {
        return *std::ranges::find(half->objects, light, &scene::Object::emitterOfLight);
    };
    const scene::Bounds panel = scene::boundsWorld(surface(3)), bulb = scene::boundsWorld(surface(4));
    expectExactly(panel.lowerWorld, {-1.25, 5, 1.5}); // half way: at (0, 5, 2), 2.5 x 1
    expectExactly(panel.upperWorld, {1.25, 5, 2.5});
    // The vertices of the sphere are floats.
    EXPECT_LT(glm::length(bulb.lowerWorld - dvec3(3, 2, 2)), 1e-6);
    EXPECT_LT(glm::length(bulb.upperWorld - dvec3(5, 4, 4)), 1e-6);
    EXPECT_EQ(half->materials[surface(4).partMaterials.front()].emission, vec3(2));
    // What is seen is what a scene file with these lights would show.
    scene::Scene fresh = *base;
    fresh.lights = half->lights;
    scene::addEmitterSurfaces(fresh);
    ASSERT_EQ(fresh.objects.size(), half->objects.size());
    for (std::size_t i = 0; i < fresh.objects.size(); ++i) {
        EXPECT_EQ(fresh.objects[i].worldFromObject, half->objects[i].worldFromObject);
        EXPECT_EQ(fresh.objects[i].mesh->positionsMesh, half->objects[i].mesh->positionsMesh);
    }
}

struct BadPath {
    const char* name;
    std::string text, place, phrase;
    ExitStatus status = ExitStatus::badInput;
};
void PrintTo(const BadPath& bad, std::ostream* out) { *out << bad.name; }

class BadPaths : public ::testing::TestWithParam<BadPath> {};

TEST_P(BadPaths, AreRefusedWithLineColumnAndReason) {
    const BadPath& bad = GetParam();
    const Error error = scene::errorOf([&] { (void)path(bad.text); });
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("x.json:" + bad.place + ": ")) << message;
    EXPECT_TRUE(scene::contains(message, bad.phrase)) << message;
    EXPECT_TRUE(scene::contains(message, "; ")) << "says what to do: " << message;
    EXPECT_FALSE(scene::contains(message, "\n")) << message;
    EXPECT_EQ(error.status(), bad.status) << message;
}

/// A second key, on line 2, with these lights.
std::string toLights(const std::string& lights) {
    return "[{\"frame\": 1},\n{\"frame\": 9, \"lights\": [" + lights + "]}]";
}
std::string toCamera(const std::string& keys) {
    return "[{\"frame\": 1},\n{\"frame\": 9, \"camera\": {" + keys + "}}]";
}

INSTANTIATE_TEST_SUITE_P(
    Path, BadPaths,
    ::testing::Values(
        BadPath{"Empty", "", "1:1", "write a path, as [{\"frame\": 1"},
        BadPath{"Syntax", "[\n{]", "2:2", "fix the JSON here"},
        BadPath{"TooDeep", std::string(65, '['), "1:65", "nested deeper", ExitStatus::overLimit},
        BadPath{"NoList", "{\"frame\": 1}", "1:1", "a path is a list, and this is an object"},
        BadPath{"NoKeys", "[ ]", "1:1", "the path has no keys"},
        BadPath{"NoFrame", "[\n{}]", "2:1", "key 1 has no \"frame\""},
        BadPath{"FrameZero", "[{\"frame\":\n 0}]", "2:2", "a whole number from 1 to 100000"},
        BadPath{"FrameHalf", "[{\"frame\":\n 1.5}]", "2:2", "is 1.5; it must be a whole number"},
        BadPath{"FrameTooLarge", "[{\"frame\":\n 100001}]", "2:2", "from 1 to 100000"},
        BadPath{"FrameTwice", "[{\"frame\": 4},\n{\"frame\": 4}]", "2:11", "in the order of their frames"},
        BadPath{"FramesFall", "[{\"frame\": 4},\n{\"frame\": 3}]", "2:11", "of the key before is 4"},
        BadPath{"UnknownKey", "[{\"frame\": 1,\n\"light\": []}]", "2:1", "did you mean \"lights\"?"},
        BadPath{"KeyTwice", "[{\"frame\": 1,\n\"frame\": 2}]", "2:1", "appears twice"},
        BadPath{"CameraKey", toCamera("\"postion\": [0, 0, 0]"), "2:25", "did you mean \"position\"?"},
        BadPath{"CameraRange", toCamera("\"fovYDegrees\": 180"), "2:40", "of the camera of key 2 is 180"},
        BadPath{"CameraAtItsTarget", toCamera("\"position\": [0, 0, 0]"), "2:24", "camera's own position"},
        BadPath{"NearBeyondFar",
                "[{\"frame\": 1, \"camera\": {\"far\": 10}},\n {\"frame\": 2, \"camera\": {\"near\": 20}}]", "2:25",
                "larger than near, which is 20"},
        BadPath{"LightsAreNoList", "[{\"frame\": 1, \"lights\":\n {}}]", "2:2", "it must be an array"},
        BadPath{"NoName", toLights("{}"), "2:25", "light 1 of key 2 has no \"name\""},
        BadPath{"UnknownLight", toLights("{\"name\": \"lmap\"}"), "2:34", "did you mean \"lamp\"?"},
        BadPath{"LightTwice", toLights("{\"name\": \"sun\"}, {\"name\": \"sun\"}"), "2:51",
                "again, first at x.json:2:25"},
        BadPath{"Type", toLights("{\"name\": \"sun\", \"type\": \"spot\"}"), "2:41", "unknown key \"type\""},
        BadPath{"KeyOfAnotherType", toLights("{\"name\": \"sun\", \"position\": [0, 0, 0]}"), "2:41",
                "light 1 of key 2 (type directional)"},
        BadPath{"Range", toLights("{\"name\": \"key\", \"intensity\": -1}"), "2:54", "from 0 to 1e+15"},
        BadPath{"ConeNarrowerThanItsBand", toLights("{\"name\": \"lamp\", \"coneDegrees\": 6}"), "2:57",
                "at least twice edgeDegrees, which is 4"},
        BadPath{"ParallelEdges", toLights("{\"name\": \"panel\", \"edgeU\": [0, 0, 3]}"), "2:25",
                "is parallel to edgeU"},
        BadPath{"OppositeDirections", toLights("{\"name\": \"sun\", \"direction\": [0, 2, 0]}"), "2:1",
                "from frame 1 to frame 9, \"direction\" of light \"sun\" turns to its opposite"},
        BadPath{"OppositeUps", toCamera("\"up\": [0, -1, 0]"), "2:1", "\"up\" of the camera turns to its opposite"},
        BadPath{"ThroughTheTarget", toCamera("\"position\": [0, -2, -8]"), "2:1",
                "at frame 5, the camera comes to its own"},
        BadPath{"EdgesCross", toLights("{\"name\": \"panel\", \"edgeU\": [0, 0, 1], \"edgeV\": [1, 0, 0]}"), "2:1",
                "at frame 5, the edges of light \"panel\" are parallel"}),
    [](const ::testing::TestParamInfo<BadPath>& info) { return std::string(info.param.name); });

TEST(Path, MissingFilesAndFoldersAreSaid) {
    const scene::TempFolder folder;
    for (const std::filesystem::path& file : {folder.path() / "none.json", folder.path()}) {
        const Error error = scene::errorOf([&] { (void)loadPath(file, *lightsOfAllKinds()); });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_TRUE(scene::contains(error.what(), file.string())) << error.what();
    }
}

} // namespace
} // namespace shadowlab::film
