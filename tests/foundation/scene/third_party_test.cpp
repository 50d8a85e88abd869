// What the libraries that read files let through, and that we do not: each fault first as the library has it, then as we do. Where
// a library fixes one, its half turns red, and says that ours may go.
// SPDX-License-Identifier: MIT
#define TINYOBJLOADER_USE_DOUBLE // as where it is compiled, in obj_faces.cpp
#include <tiny_obj_loader.h>

#include <nlohmann/json.hpp>

#include <sstream>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// What tinyobjloader makes of a text by itself.
struct Loaded {
    bool ok = false;
    std::string warning, error;
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

Loaded byLibrary(const std::string& text) {
    std::istringstream stream(text);
    Loaded loaded;
    std::vector<tinyobj::material_t> materials;
    loaded.ok =
        tinyobj::LoadObj(&loaded.attributes, &loaded.shapes, &materials, &loaded.warning, &loaded.error, &stream);
    return loaded;
}

std::string ours(const std::string& text) {
    const TempFolder folder;
    const auto file = folder.write("bad.obj", text);
    const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
    EXPECT_EQ(error.status(), ExitStatus::badInput) << error.what();
    return error.what();
}

/// TALOS-2020-1212, fixed in 2023 (pull request 358).
TEST(ThirdParty, TinyobjTakesIndicesBeforeTheFirstVertex) {
    const std::string text = kThree + "f -1 -2 -9\n";
    const Loaded loaded = byLibrary(text);
    if (loaded.ok) { // 2.0.0rc10, which Debian 12 has; rc13 refuses the file
        EXPECT_EQ(loaded.error, "");
        ASSERT_EQ(loaded.shapes.size(), 1u);
        ASSERT_EQ(loaded.shapes[0].mesh.indices.size(), 3u);
        EXPECT_LT(loaded.shapes[0].mesh.indices[2].vertex_index, 0) << "whoever follows it reads before the array";
    }
    EXPECT_TRUE(contains(ours(text), ":4: ")) << ours(text);
}

TEST(ThirdParty, TinyobjTakesIndicesBeyondTheLastVertex) {
    const std::string text = kThree + "f 1 2 9\n# another line\n";
    const Loaded loaded = byLibrary(text);
    EXPECT_TRUE(loaded.ok);
    ASSERT_EQ(loaded.shapes.size(), 1u);
    EXPECT_GE(static_cast<std::size_t>(loaded.shapes[0].mesh.indices.at(2).vertex_index), std::size_t{3});
    EXPECT_TRUE(contains(ours(text), ":4: ")) << ours(text);
}

TEST(ThirdParty, TinyobjWrapsIndicesRound) {
    const std::string text = kThree + "f 1 2 99999999999\n";
    const Loaded loaded = byLibrary(text);
    EXPECT_TRUE(loaded.ok);
    ASSERT_EQ(loaded.shapes.size(), 1u);
    EXPECT_NE(loaded.shapes[0].mesh.indices.at(2).vertex_index, 99999999998) << "it has no such number";
    EXPECT_TRUE(contains(ours(text), ":4: ")) << ours(text);
}

TEST(ThirdParty, TinyobjMakesZeroOfWhatIsNoNumber) {
    for (const char* junk : {"abc", "nan", ""}) {
        const std::string text = "v " + std::string(junk) + " 0 0\n" + kThree + "f 2 3 4\n";
        const Loaded loaded = byLibrary(text);
        EXPECT_TRUE(loaded.ok && loaded.warning.empty() && loaded.error.empty()) << junk << ": fixed";
        EXPECT_EQ(loaded.attributes.vertices.at(0), 0) << junk;
        EXPECT_TRUE(contains(ours(text), ":1: ")) << ours(text);
    }
}

TEST(ThirdParty, TinyobjStopsAtADecimalComma) {
    const std::string text = "v 1,5 0 0\n" + kThree + "f 2 3 4\n";
    const Loaded loaded = byLibrary(text);
    EXPECT_TRUE(loaded.ok && loaded.warning.empty()) << "fixed";
    EXPECT_EQ(loaded.attributes.vertices.at(0), 1);
    EXPECT_TRUE(contains(ours(text), "1.5")) << ours(text);
}

TEST(ThirdParty, TinyobjMakesInfinityOfLargeNumbers) {
    const std::string text = "v 1e400 0 0\n" + kThree + "f 2 3 4\n";
    EXPECT_FALSE(std::isfinite(byLibrary(text).attributes.vertices.at(0))) << "fixed";
    EXPECT_TRUE(contains(ours(text), ":1: ")) << ours(text);
}

TEST(ThirdParty, TinyobjTakesNoiseForAnEmptyMesh) {
    std::string noise = "\x89PNG\r\n\x1a\n";
    for (int i = 1; i < 256; ++i)
        noise += static_cast<char>(i);
    const Loaded loaded = byLibrary(noise);
    EXPECT_TRUE(loaded.ok && loaded.error.empty() && loaded.shapes.empty()) << "fixed: " << loaded.error;
    EXPECT_TRUE(contains(ours(noise), "bad.obj")) << ours(noise);
}

/// The folder's name takes the place of the file's: an ifstream opens it, and reads nothing.
TEST(ThirdParty, TinyobjTakesAFolderForAnEmptyMesh) {
    const TempFolder folder;
    Loaded loaded;
    std::vector<tinyobj::material_t> materials;
    EXPECT_TRUE(tinyobj::LoadObj(&loaded.attributes, &loaded.shapes, &materials, &loaded.warning, &loaded.error,
                                 folder.path().c_str()))
        << "fixed: " << loaded.error;
    EXPECT_TRUE(loaded.shapes.empty());
    const Error error = errorOf([&] { (void)loadObj(folder.path(), NormalMode::file, {}); });
    EXPECT_TRUE(contains(error.what(), "directory")) << error.what();
}

/// Of two values for one key the last counts, without a word.
TEST(ThirdParty, NlohmannTakesAKeyTwice) {
    EXPECT_EQ(nlohmann::json::parse(R"({"near": 1, "near": 2})").at("near"), 2) << "fixed";
    const std::string text = R"({"camera": {"position": [0, 1, 5], "target": [0, 0, 0], "near": 1, "near": 2}})";
    const Error error = errorOf([&] { (void)parseSceneJson(text, "s.json", {}); });
    EXPECT_TRUE(contains(error.what(), "near")) << error.what();
    EXPECT_EQ(error.status(), ExitStatus::badInput);
}

/// The parser has no limit of depth, and code that walks the tree afterwards overflows the stack.
TEST(ThirdParty, NlohmannTakesAnyDepth) {
    constexpr std::size_t kDepth = 100000;
    const std::string text = std::string(kDepth, '[') + std::string(kDepth, ']');
    EXPECT_TRUE(nlohmann::json::accept(text)) << "fixed";
    const Error error = errorOf([&] { (void)parseSceneJson(text, "s.json", {}); });
    EXPECT_EQ(error.status(), ExitStatus::overLimit) << error.what();
}

} // namespace
} // namespace shadowlab::scene
