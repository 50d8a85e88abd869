// What is written of a random scene is read as the same, and a mesh is the same however its file is written.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/context/assets.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/relations/random_recipes.h"

namespace shadowlab::relations {
namespace {

namespace fs = std::filesystem;

constexpr int kRecipes = 20;

/// A folder that is gone afterwards.
class Files : public ::testing::Test {
protected:
    Files() { fs::create_directories(folder_); }
    ~Files() override { fs::remove_all(folder_); }

    static std::string read(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }
    static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
    scene::LoadOptions options() const {
        return {.assetsRoot = context::assetsRoot(), .allowed = {folder_}, .limits = {}};
    }
    const fs::path folder_ = fs::path(::testing::TempDir()) / ("shadowlab-files-" + std::to_string(::getpid()));
};

TEST_F(Files, ASceneThatWasReadIsWrittenAsItWas) {
    std::size_t compared = 0;
    for (const std::uint64_t seed : seeds())
        for (const Recipe& recipe : randomRecipes(seed, recipesPerSeed(kRecipes))) {
            const scene::Scene scene = sceneOf(recipe);
            const fs::path file = writeScene(scene, folder_, "scene");
            const auto loaded = scene::loadScene(file.string(), options());
            EXPECT_EQ(scene::sceneText(*loaded, loaded->camera, folder_), read(file)) << recipe;
            EXPECT_EQ(loaded->camera, scene.camera) << recipe;
            ASSERT_EQ(loaded->objects.size(), scene.objects.size());
            for (std::size_t o = 0; o < scene.objects.size(); ++o) {
                // Places on the grid have few digits: they come through text and float alike.
                const scene::Bounds was = scene::boundsWorld(scene.objects[o]), is = boundsWorld(loaded->objects[o]);
                EXPECT_EQ(is.lowerWorld, was.lowerWorld) << recipe;
                EXPECT_EQ(is.upperWorld, was.upperWorld) << recipe;
                EXPECT_EQ(loaded->objects[o].mesh->triangles.size(), scene.objects[o].mesh->triangles.size());
            }
            compared += scene.objects.size();
        }
    EXPECT_GE(compared, std::size_t{4 * kRecipes});
}

/// The same file in other words.
std::string rewritten(const std::string& text, const std::string& lineEnd, const std::string& before, bool relative) {
    std::istringstream lines(text);
    std::string result = before;
    int vertices = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        vertices += kind == "v";
        if (kind == "f" && relative) {
            line = kind;
            for (int vertex = 0; words >> vertex;)
                line += " " + std::to_string(vertex - vertices - 1);
        }
        result += line + lineEnd;
    }
    return result;
}

TEST_F(Files, AMeshIsTheSameHoweverItIsWritten) {
    int compared = 0;
    for (const std::uint64_t seed : seeds())
        for (const Recipe& recipe : randomRecipes(seed, recipesPerSeed(kRecipes))) {
            const scene::Scene scene = sceneOf(recipe);
            writeScene(scene, folder_, "scene");
            const fs::path file = folder_ / ("scene-" + scene.objects.back().name + ".obj");
            const std::string text = read(file);
            const scene::Mesh plain = scene::loadObj(file, scene::NormalMode::file, options()).mesh;
            const fs::path other = folder_ / "other.obj";
            for (const std::string& words : {rewritten(text, "\n", "", true), rewritten(text, "\r\n", "", false),
                                             rewritten(text, " \t\n", "\xef\xbb\xbf", false),
                                             rewritten(text, "\n# again\n\n", "# first\n", true)}) {
                ASSERT_NE(words, text);
                write(other, words);
                const scene::Mesh mesh = scene::loadObj(other, scene::NormalMode::file, options()).mesh;
                EXPECT_EQ(mesh.positionsMesh, plain.positionsMesh) << recipe;
                EXPECT_EQ(mesh.normalsMesh, plain.normalsMesh) << recipe;
                EXPECT_EQ(mesh.triangles, plain.triangles) << recipe;
                ++compared;
            }
        }
    EXPECT_GE(compared, 8 * kRecipes);
}

} // namespace
} // namespace shadowlab::relations
