// Which texel a texture coordinate falls into, what is a hole, and what becomes of images that are none.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/holes.h"

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/image_files.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/perforated.h"

namespace shadowlab::scene {
namespace {

const std::string kCamera = R"("camera": {"position": [3, 2, 5], "target": [0, 0, 0]})";
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string pngOf(const std::vector<image::Color8>& texels, bool opaque) {
    image::Image picture(static_cast<int>(texels.size()), 1);
    for (int x = 0; x < picture.width; ++x)
        picture.set(x, 0, texels[static_cast<std::size_t>(x)]);
    const std::vector<std::uint8_t> bytes = image::encodePng(picture, {.opaque = opaque, .text = {}});
    return {bytes.begin(), bytes.end()};
}

/// One letter per texel of a row, as the file is read.
std::string read(const std::vector<image::Color8>& texels, bool opaque) {
    const TempFolder folder;
    const auto mask = ImageFiles().mask(folder.write("mask.png", pngOf(texels, opaque)), {}, Limits());
    std::string row;
    for (std::size_t i = 0; i < texels.size(); ++i)
        row += mask->isHole({(static_cast<double>(i) + 0.5) / static_cast<double>(texels.size()), 0.5}, false) ? '.' : '#';
    return row;
}

TEST(AlphaMask, TheNearestTexelRepeatedWithRowsFromTheBottom) {
    const auto mask = testing::maskOf({"#..", //
                                       ".##"});
    EXPECT_EQ(mask->size(), ivec2(3, 2));
    EXPECT_EQ(mask->texels(), (std::vector<std::uint8_t>{0, 255, 255, 255, 0, 0})) << "as OpenGL counts rows";
    int solid = 0, holes = 0;
    for (int u = -3; u <= 3; ++u)
        for (int v = -3; v <= 3; ++v)
            for (int column = 0; column < 3; ++column)
                for (int row = 0; row < 2; ++row) {
                    const bool hole = mask->isHole(dvec2(u + (column + 0.5) / 3, v + (row + 0.5) / 2), false);
                    EXPECT_EQ(hole, row == 0 ? column == 0 : column != 0) << column << ", " << row;
                    ++(hole ? holes : solid);
                }
    EXPECT_EQ(solid, 49 * 3);
    EXPECT_EQ(holes, 49 * 3);
    // A texel begins at its lower and left border; just below zero is the image's other end.
    EXPECT_TRUE(mask->isHole({0, 0}, false));
    EXPECT_FALSE(mask->isHole({0, 0.5}, false));
    EXPECT_FALSE(mask->isHole({-1e-18, 0}, false));
    EXPECT_TRUE(mask->isHole({-1e-18, -1e-18}, false));
}

TEST(AlphaMask, AlphaCountsAndBrightnessWhereThereIsNone) {
    EXPECT_EQ(read({{255, 255, 255, 127}, {0, 0, 0, 128}, {0, 0, 0, 255}, {9, 9, 9, 0}}, false), ".##.");
    EXPECT_EQ(read({{127, 127, 127}, {128, 128, 128}, {0, 255, 0}, {255, 0, 255}}, true), ".##.");
}

TEST(AlphaMask, OfASceneAreReadOnceAndKept) {
    const TempFolder folder;
    folder.write("leaf.png", pngOf({{0, 0, 0, 0}, {0, 0, 0, 255}}, false));
    const auto file = folder.write("scene.json", "");
    const auto scene = parseSceneJson("{" + kCamera + R"(, "materials": {
        "leaf": {"alphaMap": "leaf.png"}, "other": {"alphaMap": "./leaf.png"}},
        "objects": [{"shape": "quad", "size": [1, 1], "material": "leaf"}, {"shape": "box", "size": [1, 1, 1]}]})",
                                      file, {});
    EXPECT_EQ(scene->materials[1].alphaMap, (folder.path() / "leaf.png").string());
    EXPECT_EQ(scene->materials[1].alphaMask, scene->materials[2].alphaMask);
    EXPECT_TRUE(scene->notes.empty());
    EXPECT_TRUE(hasHoles(*scene, scene->objects[0]));
    EXPECT_FALSE(hasHoles(*scene, scene->objects[1]));
    // The first triangle has the corners (-x, -z), (-x, +z), (+x, +z): u = 0, 0, 1. The left half of the image is a hole.
    EXPECT_TRUE(isInHole(*scene, scene->objects[0], 0, {0.4, 0.3, 0.3}));
    EXPECT_FALSE(isInHole(*scene, scene->objects[0], 0, {0.2, 0.2, 0.6}));
    EXPECT_FALSE(isInHole(*scene, scene->objects[1], 0, {0.4, 0.3, 0.3}));
}

TEST(AlphaMask, WhatIsNoImageIsAnErrorInASceneAndANoteInAMesh) {
    const TempFolder folder;
    folder.write("text.png", "not a picture");
    folder.write("drawing.bmp", std::string("BM\x46\0\0\0", 6));
    folder.write("half.png", pngOf({{0, 0, 0, 0}, {0, 0, 0, 255}}, false).substr(0, 60));
    const auto file = folder.write("scene.json", "");
    for (const auto& [name, fault] : {std::pair<std::string, std::string>{"text.png", "neither PNG nor JPEG; save it"},
                                      std::pair<std::string, std::string>{"drawing.bmp", "neither PNG nor JPEG, but seems to be BMP; save it"},
                                      std::pair<std::string, std::string>{"half.png", "not a readable PNG: "}}) {
        const Error error = errorOf([&] {
            parseSceneJson("{" + kCamera + ",\n\"materials\": {\"leaf\": {\"alphaMap\": \"" + name + "\"}}}", file, {});
        });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_TRUE(contains(error.what(), "scene.json:2:36: ")) << error.what();
        EXPECT_TRUE(contains(error.what(), "is \"" + name + "\", " + fault)) << error.what();
        EXPECT_TRUE(contains(error.what(), "; save it ")) << error.what();

        folder.write("m.mtl", "newmtl leaf\nmap_d " + name + "\n");
        const ObjFile obj =
            loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kSquare + "usemtl leaf\nf 1 2 3\n"), NormalMode::file, {});
        EXPECT_EQ(obj.materials.at(0).alphaMask, nullptr);
        EXPECT_EQ(obj.materials.at(0).alphaMap, "");
        ASSERT_EQ(obj.notes.size(), 1u);
        EXPECT_TRUE(contains(obj.notes[0], "map_d \"" + name + "\" is ignored: " + fault)) << obj.notes[0];
    }
}

TEST(AlphaMask, AllOfASceneTogetherAreWithinItsMemory) {
    const TempFolder folder;
    const std::uint64_t texels = 1000;
    const std::vector<image::Color8> row(texels);
    for (const char* name : {"a.png", "b.png", "c.png"})
        folder.write(name, pngOf(row, false));
    folder.write("m.mtl", "newmtl leaf\nmap_d c.png\n");
    folder.write("m.obj", "mtllib m.mtl\n" + kSquare + "vt 0 0\nusemtl leaf\nf 1/1 2/1 3/1\n");
    const auto file = folder.write("scene.json", "");
    const std::string text = "{" + kCamera + R"(, "materials": {"a": {"alphaMap": "a.png"},
"b": {"alphaMap": "b.png"}, "again": {"alphaMap": "a.png"}}, "objects": [{"mesh": "m.obj"}]})";
    const auto with = [&](std::uint64_t bytes) {
        LoadOptions options;
        options.limits.memoryBytes = kBytesAtRest + bytes;
        return parseSceneJson(text, file, options);
    };
    // Of the three, two are kept while the third is read.
    const std::uint64_t needed = 2 * texels * kBytesPerTexel + texels * kBytesPerTexelRead;
    const std::uint64_t aFile = std::filesystem::file_size(folder.path() / "c.png");
    const auto whole = with(needed + aFile + 2000); // and room for an OBJ file
    EXPECT_EQ(whole->notes.size(), 0u);
    EXPECT_NE(whole->materials.back().alphaMask, nullptr);
    ASSERT_EQ(triangleCount(*whole), 1u);
    EXPECT_EQ(whole->memory.takenBytes, kBytesAtRest + 3 * texels * kBytesPerTexel + kBytesPerTriangle);
    EXPECT_EQ(whole->memory.limitBytes, kBytesAtRest + needed + aFile + 2000);
    const auto withoutThird = with(needed + aFile - 1);
    ASSERT_GE(withoutThird->notes.size(), 1u);
    EXPECT_TRUE(contains(withoutThird->notes[0], "map_d \"c.png\" is ignored: 1000 x 1 pixels, for which some "))
        << withoutThird->notes[0];
    const Error error = errorOf([&] { with(texels * (kBytesPerTexel + kBytesPerTexelRead) + aFile - 1); });
    EXPECT_EQ(error.status(), ExitStatus::overLimit);
    EXPECT_TRUE(contains(error.what(), "scene.json:2:")) << error.what();
    EXPECT_TRUE(contains(error.what(), "\"b.png\", 1000 x 1 pixels")) << error.what();
    EXPECT_TRUE(contains(error.what(), ", or set --limit memory")) << error.what();
}

TEST(AlphaMask, OfMeshesWithoutTextureCoordinatesCutsNothingAndSaysSo) {
    const TempFolder folder;
    folder.write("leaf.png", pngOf({{0, 0, 0, 0}}, false));
    folder.write("m.mtl", "newmtl leaf\nmap_d leaf.png\n");
    const auto file =
        folder.write("m.obj", "mtllib m.mtl\n" + kSquare +
                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt nan 0\nusemtl leaf\nf 1/1 2/2 3/3\nf 1 3 4\n"
                                  "f 1/1 3/3 4\nf 1/1 3/3 4/4\n");
    const ObjFile obj = loadObj(file, NormalMode::file, {});
    ASSERT_EQ(obj.mesh.parts.size(), 2u);
    EXPECT_TRUE(obj.mesh.parts[0].hasTexcoords);
    EXPECT_EQ(obj.mesh.parts[0].triangleCount, 1u);
    EXPECT_FALSE(obj.mesh.parts[1].hasTexcoords);
    EXPECT_EQ(obj.mesh.parts[1].triangleCount, 3u);
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "m.obj: material 'leaf': no holes are cut in 3 triangles without texture "))
        << obj.notes[0];

    const auto scene = parseSceneJson("{" + kCamera + R"(, "materials": {"lace": {"alphaMap": "leaf.png"}}, "objects": [
        {"mesh": "m.obj"}, {"mesh": "m.obj", "material": "lace"}]})",
                                      folder.path() / "scene.json", {});
    ASSERT_EQ(scene->notes.size(), 2u);
    EXPECT_TRUE(contains(scene->notes[1], "object 2 (a mesh): material 'lace': no holes are cut in 3 triangles"))
        << scene->notes[1];
    for (const Object& object : scene->objects) {
        EXPECT_TRUE(hasHoles(*scene, object));
        EXPECT_TRUE(isInHole(*scene, object, 0, dvec3(1.0 / 3)));
        EXPECT_FALSE(isInHole(*scene, object, 1, dvec3(1.0 / 3)));
    }
}

} // namespace
} // namespace shadowlab::scene
