// Notes on a scene as a whole: lights that a caster hides, and units that are no metres. No false alarm in the scenes there are.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/query/hidden_lights.h"
#include "techniques/foundation/scene/query/unit_notes.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "assets";

std::shared_ptr<const Scene> sceneOf(const std::string& lights, const std::string& objects,
                                     const std::string& camera = R"("position": [0, 2, 6], "target": [0, 1, 0])") {
    const TempFolder folder;
    folder.write("open.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                             "f 5 6 7 8\nf 1 5 8 4\nf 2 3 7 6\nf 4 8 7 3\nf 1 4 3 2\n"); // no bottom
    return loadScene(folder
                         .write("s.json", "{\"camera\": {" + camera + "}, \"lights\": [" + lights +
                                              "], \"objects\": [" + objects + "]}")
                         .string(),
                     {});
}

constexpr const char* kBulb = R"({"type": "point", "name": "bulb", "position": [0, 1.6, 0], "intensity": 12})";
constexpr const char* kGlobe = R"({"name": "globe", "shape": "sphere", "radius": 0.4, "translate": [0, 1.6, 0])";

TEST(HiddenLights, ABulbInItsGlobeIsTold) {
    const auto scene = sceneOf(kBulb, std::string(kGlobe) + "}");
    ASSERT_EQ(scene->notes.size(), 1u);
    for (const char* part : {"s.json: ", "\"bulb\"", "\"globe\"", "\"castsShadow\": false"})
        EXPECT_TRUE(contains(scene->notes[0], part)) << part << " in " << scene->notes[0];
}

TEST(HiddenLights, WhatLetsLightOutIsNotTold) {
    EXPECT_TRUE(notesOnHiddenLights(*sceneOf(kBulb, std::string(kGlobe) + ", \"castsShadow\": false}")).empty());
    EXPECT_TRUE(
        notesOnHiddenLights(*sceneOf(kBulb, R"({"mesh": "open.obj", "scale": 0.4, "translate": [0, 1.6, 0]})")).empty())
        << "a shade without a bottom";
    EXPECT_TRUE(notesOnHiddenLights(*sceneOf(R"({"type": "sphere", "position": [0, 1.6, 0], "radius": 0.5})",
                                             std::string(kGlobe) + "}"))
                    .empty())
        << "the lamp is larger than the ball in it";
    EXPECT_TRUE(
        notesOnHiddenLights(*sceneOf(R"({"type": "directional", "direction": [0, -1, 0]})", std::string(kGlobe) + "}"))
            .empty());
}

TEST(HiddenLights, ARoomAroundTheEyeIsNoCasterThatHides) {
    const std::string room = R"({"shape": "box", "size": [20, 20, 20]})";
    EXPECT_TRUE(notesOnHiddenLights(*sceneOf(kBulb, room)).empty());
    EXPECT_EQ(notesOnHiddenLights(*sceneOf(kBulb, room, R"("position": [0, 0, 30], "target": [0, 0, 0])")).size(), 1u)
        << "seen from outside it hides its light";
}

TEST(HiddenLights, AShellWithTwoWallsHidesToo) {
    // The winding number within the inner wall is 0, as outside: rays find the walls all the same.
    std::string obj;
    for (const double size : {1.0, 0.9})
        for (int i = 0; i < 8; ++i)
            obj += "v " + std::to_string(i & 1 ? size : -size) + " " + std::to_string(i & 2 ? size : -size) + " " +
                   std::to_string(i & 4 ? size : -size) + "\n";
    obj += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    obj += "f 9 10 12 11\nf 13 15 16 14\nf 9 13 14 10\nf 11 12 16 15\nf 9 11 15 13\nf 10 14 16 12\n";
    const TempFolder folder;
    folder.write("shell.obj", obj);
    const auto scene = loadScene(
        folder
            .write("s.json",
                   std::string("{\"camera\": {\"position\": [0, 2, 6], \"target\": [0, 1, 0]}, \"lights\": [") + kBulb +
                       "], \"objects\": [{\"mesh\": \"shell.obj\", \"translate\": [0, 1.6, 0]}]}")
            .string(),
        {});
    EXPECT_EQ(notesOnHiddenLights(*scene).size(), 1u);
}

/// A box on a floor under a lamp, all lengths times `scale`, and the lamp as it would be in metres.
std::string unitNote(double scale, double intensity = 40) {
    const auto number = [&](double metres) { return std::to_string(scale * metres); };
    return noteOnUnits(
        *sceneOf("{\"type\": \"point\", \"position\": [0, " + number(4) +
                     ", 0], \"intensity\": " + std::to_string(intensity) + "}",
                 "{\"shape\": \"quad\", \"size\": [" + number(12) + ", " + number(12) +
                     "]}, {\"shape\": \"box\", \"size\": [" + number(2) + ", " + number(1) + ", " + number(1) + "]}",
                 "\"position\": [0, " + number(2) + ", " + number(6) + "], \"target\": [0, " + number(1) + ", 0]"));
}

TEST(UnitNotes, MillimetresAndKilometresAreTold) {
    EXPECT_EQ(unitNote(1), "");
    EXPECT_TRUE(contains(unitNote(1000), "in millimetres?")) << unitNote(1000);
    EXPECT_TRUE(contains(unitNote(1000), "by 0.001")) << unitNote(1000);
    EXPECT_TRUE(contains(unitNote(1000), "the scene is 2000 m across")) << unitNote(1000); // of the box: the floor is none of the things
    EXPECT_TRUE(contains(unitNote(0.001), "in kilometres?")) << unitNote(0.001);
}

TEST(UnitNotes, DrawingsInMillimetresAreToldAtAnySize) {
    for (const double scale : {10.0, 80.0, 400.0}) { // parts of 2 cm and more, under lamps that would do for them in metres
        const std::string note = unitNote(scale, 40 * scale * scale * 1e-6);
        EXPECT_TRUE(contains(note, "in millimetres?")) << scale << ": " << note;
    }
    EXPECT_TRUE(contains(unitNote(100), "darker")) << unitNote(100);
    EXPECT_TRUE(contains(unitNote(0.01, 40), "brighter")) << unitNote(0.01, 40);
    EXPECT_EQ(unitNote(2, 0.04), "") << "a dark room";
}

TEST(UnitNotes, WhatShinesBesideTheLightsIsNoEvidence) {
    const std::string lamp = R"({"type": "point", "position": [0, 4000, 0], "intensity": 40})";
    const auto scene = [&](const std::string& material) {
        const TempFolder folder;
        return loadScene(folder.write("s.json", R"({"camera": {"position": [0, 2000, 6000], "target": [0, 0, 0]}, "lights": [)" + lamp +
                                                    R"(], "materials": {"panel": )" + material +
                                                    R"(}, "objects": [{"shape": "box", "size": [2000, 1000, 1000], "material": "panel"}]})")
                             .string(),
                         {});
    };
    EXPECT_NE(noteOnUnits(*scene("{}")), "");
    EXPECT_EQ(noteOnUnits(*scene(R"({"emission": [1, 1, 1]})")), "");
}

TEST(UnitNotes, SizeAloneProvesNothing) {
    EXPECT_EQ(unitNote(1000, 40e6), "") << "a valley with lights that reach across it";
    EXPECT_EQ(unitNote(0.001, 40e-6), "") << "a watch under a lamp of its size";
    const auto terrain = sceneOf(R"({"type": "directional", "direction": [0, -1, 0]})",
                                 R"({"shape": "box", "size": [5000, 900, 5000]})");
    EXPECT_EQ(noteOnUnits(*terrain), "") << "the sun is as bright in any unit";
}

TEST(SceneNotes, NoFalseAlarmInTheScenesOfTheProgram) {
    int looked = 0;
    for (const std::string folder : {"scenes", "lessons/scenes", "decks/scenes"})
        for (const auto& entry : std::filesystem::directory_iterator(kAssets / folder)) {
            if (entry.path().extension() != ".json") continue;
            const auto scene = loadScene(entry.path().string(), {.assetsRoot = kAssets, .allowed = {}, .limits = {}});
            EXPECT_EQ(notesOnHiddenLights(*scene), std::vector<std::string>{}) << entry.path();
            EXPECT_EQ(noteOnUnits(*scene), "") << entry.path();
            ++looked;
        }
    EXPECT_GT(looked, 12);
    for (const auto& entry : std::filesystem::directory_iterator(kAssets / "models"))
        if (entry.path().extension() == ".obj") {
            EXPECT_EQ(noteOnUnits(*stageObj(entry.path(), {})), "") << entry.path();
        }
}

} // namespace
} // namespace shadowlab::scene
