// Materials of OBJ files: what is read, what is noted, and which files are never opened.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/model/holes.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kTriangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(Mtl, ValuesAreReadAndTrianglesGroupedByMaterial) {
    const TempFolder folder;
    folder.write("two.mtl", "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 90\nKe 2 0 0\nd 0.25\nNi 1.33\n"
                            "newmtl blue sky\r\nKd 0 0 1\nTr 0.5\n");
    const auto file = folder.write("mesh.obj", "mtllib two.mtl\n" + kTriangles +
                                                   "f 1 2 3\nusemtl blue sky\nf 1 2 4\nusemtl red\nf 1 3 4\n"
                                                   "usemtl blue sky\nf 2 3 4\n");
    const ObjFile obj = loadObj(file, NormalMode::file, {});
    EXPECT_TRUE(obj.notes.empty());
    ASSERT_EQ(obj.materials.size(), 2u);
    const Material& red = obj.materials[0];
    EXPECT_EQ(red.name, "red");
    EXPECT_EQ(red.diffuse, vec3(1, 0, 0));
    EXPECT_EQ(red.specular, vec3(0.5f));
    EXPECT_EQ(red.shininess, 90.0f);
    EXPECT_EQ(red.emission, vec3(2, 0, 0));
    EXPECT_EQ(red.emits, EmittingSides::both) << "the file cannot say which side";
    EXPECT_EQ(red.transparency, 0.75);
    EXPECT_EQ(red.ior, 1.33);
    EXPECT_EQ(obj.materials[1].name, "blue sky");
    EXPECT_EQ(obj.materials[1].transparency, 0.5);

    ASSERT_EQ(obj.mesh.parts.size(), 3u);
    EXPECT_EQ(obj.mesh.parts[0].materialName, "");
    EXPECT_EQ(obj.mesh.parts[1].materialName, "blue sky");
    EXPECT_EQ(obj.mesh.parts[1].firstTriangle, 1u);
    EXPECT_EQ(obj.mesh.parts[1].triangleCount, 2u);
    EXPECT_EQ(obj.mesh.parts[2].materialName, "red");
}

TEST(Mtl, ValuesOutOfRangeAreClampedWithANote) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl a\nKd 1e38 -1 0.5\nd 2\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(obj.materials[0].diffuse, vec3(1, 0, 0.5f));
    EXPECT_EQ(obj.materials[0].transparency, 0.0);
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "m.mtl:2: Kd 1e+38 is clamped to 0..1 (and 2 more values)")) << obj.notes[0];
}

TEST(Mtl, AMaterialWithoutKdIsTheDefaultGrey) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl a\nmap_Kd wood.png\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(obj.materials[0].diffuse, vec3(0.8f));
    EXPECT_EQ(obj.materials[0].transparency, 0.0);
}

TEST(Mtl, WhatIsIgnoredAndWouldChangeTheLookIsOneNotePerKind) {
    const TempFolder folder;
    const std::string text =
        "# head\nKd 1 0 0\nKd 1 0 0\nillum 2\nnewmtl a\nKa 1 0.5 1\nKd xyz 1 1 1\nKs spectral a.rfl\n"
        "map_Kd wood.png\nd -halo 0.5\nmap_Kd wood.png\nmap_Kd wood.png\nbump wood.png\n";
    const std::string mtl = folder.write("m.mtl", text).string();
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(obj.notes,
              (std::vector<std::string>{mtl + ":2: Kd stands before the first newmtl and is ignored (and 1 more time)",
                                        mtl + ":4: illum stands before the first newmtl and is ignored",
                                        mtl + ":7: Kd xyz is not supported and ignored",
                                        mtl + ":8: Ks spectral is not supported and ignored",
                                        mtl + ":10: d -halo is not supported and ignored",
                                        mtl + ":13: bump is not supported and ignored",
                                        mtl + ":6: Ka is not supported and ignored; ambient light is reflected as Kd says",
                                        mtl + ":12: material 'a': map_Kd \"wood.png\" is ignored: it cannot be read: No such file or directory"}));
}

TEST(Mtl, AmbientColoursThatNobodyChoseNeedNoNote) {
    const TempFolder folder;
    const auto notes = [&](const std::string& statements) {
        folder.write("m.mtl", "newmtl a\n" + statements);
        return loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {}).notes;
    };
    for (const std::string usual : {"Ka 0.5 0.4 0.3\nKd 0.5 0.4 0.3\n", "Ka 1 1 1\nKd 0.5 0.4 0.3\n", "Ka 0 0 0\n", "Ka 0.2 0.2 0.2\n"})
        EXPECT_TRUE(notes(usual).empty()) << usual << notes(usual).front();
    ASSERT_EQ(notes("Ka 1 0.5 0.2\nKd 0.5 0.4 0.3\n").size(), 1u);
    EXPECT_TRUE(contains(notes("Ka 1 0.5 0.2\n")[0], "Ka is not supported"));
}

TEST(Mtl, ColouredGlassLetsTheMeanPass) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl a\nillum 7\nTf 0.9 0.6 0.3\nnewmtl b\nillum 7\nTf 0.5 0.7 0.3\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n"), NormalMode::file, {});
    ASSERT_EQ(obj.materials.size(), 2u);
    EXPECT_NEAR(obj.materials[0].transparency, 0.6, 1e-12);
    EXPECT_NEAR(obj.materials[1].transparency, 0.5, 1e-12);
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "m.mtl:3: the colours of Tf are not supported; its mean is used (and 1 more time)")) << obj.notes[0];
}

TEST(Mtl, WhatMapsDropIsNoted) {
    const TempFolder folder;
    const std::string mtl = folder
                                .write("m.mtl", "newmtl a\nmap_Kd -boost 2 a.png\nmap_Kd -texres 512 b.png\nmap_kd c.png\nMap_D c.png\n"
                                                "newmtl b\nKd 1 1 1\n")
                                .string();
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(obj.notes,
              (std::vector<std::string>{
                  mtl + ":2: option -boost of map_Kd is not supported and ignored",
                  mtl + ":3: option -texres of map_Kd is not supported and ignored",
                  mtl + ":3: a further map_Kd of one material takes the place of the one before it, which is ignored",
                  mtl + ":4: \"map_kd\" is no statement of MTL and is ignored; map_Kd may be meant",
                  mtl + ":5: \"Map_D\" is no statement of MTL and is ignored; map_d may be meant",
                  mtl + ":3: material 'a': map_Kd \"b.png\" is ignored: it cannot be read: No such file or directory"}));
}

TEST(Mtl, AFurtherMapOfTheSameImageIsNoted) {
    const TempFolder folder;
    const std::string mtl = folder.write("m.mtl", "newmtl a\nmap_Kd -s 2 2 a.png\nmap_Kd a.png\n").string();
    const ObjFile obj = loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    ASSERT_FALSE(obj.notes.empty());
    EXPECT_EQ(obj.notes[0], mtl + ":3: a further map_Kd of one material takes the place of the one before it, which is ignored");
}

TEST(Mtl, AChannelOfAColourAndOneThatDoesNotExistAreNoted) {
    const TempFolder folder;
    const std::string mtl =
        folder.write("m.mtl", "newmtl a\nmap_Kd -imfchan r a.png\nmap_d -imfchan q a.png\nmap_d -imfchan z a.png\n").string();
    const ObjFile obj = loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    ASSERT_GE(obj.notes.size(), 2u);
    EXPECT_EQ(obj.notes[0], mtl + ":2: option -imfchan of map_Kd is not supported and ignored");
    EXPECT_EQ(obj.notes[1], mtl + ":3: option -imfchan of map_d is not supported and ignored");
}

TEST(Mtl, ABackslashBehindABlankContinuesAStatement) {
    const TempFolder folder;
    const auto notes = [&](const std::string& text) {
        folder.write("m.mtl", "newmtl a\n" + text);
        const ObjFile obj =
            loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
        EXPECT_EQ(obj.materials.at(0).diffuse, vec3(1, 0.5f, 0)) << text;
        return obj.notes;
    };
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const auto found = notes("map_Kd -s 2 2 2 \\" + end + "  the \\" + end + "leaf.png" + end + "Kd 1 \\" + end + " 0.5 0" + end);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_TRUE(contains(found[0], "m.mtl:2: material 'a': map_Kd \"the  leaf.png\" is ignored")) << found[0];
    }
    const auto windows = notes("map_Kd C:\\tex\\\nKd 1 0.5 0\n");
    ASSERT_EQ(windows.size(), 1u) << "the Kd after a path that ends in a backslash is read";
}

TEST(Mtl, FilesAreNamedAsGiven) {
    const TempFolder folder;
    folder.write("in/m.mtl", "newmtl a\nKd 2 0 0\n");
    folder.write("in/bad.mtl", "newmtl a\nKd red\n");
    folder.write("in/m.obj", "mtllib ./m.mtl\n" + kTriangles + "f 1 2 3\n");
    folder.write("in/bad.obj", "mtllib bad.mtl\n" + kTriangles + "f 1 2 3\n");
    const std::filesystem::path given = std::filesystem::relative(folder.path() / "in");
    const ObjFile obj = loadObj(given / "m.obj", NormalMode::file, {});
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(obj.notes[0].starts_with((given / "./m.mtl").string() + ":2: ")) << obj.notes[0];
    const std::string message = errorOf([&] { (void)loadObj(given / "bad.obj", NormalMode::file, {}); }).what();
    EXPECT_TRUE(message.starts_with((given / "bad.mtl").string() + ":2: ")) << message;
}

TEST(Mtl, NumbersThatAreNoneAreErrorsOfTheMtlFile) {
    const TempFolder folder;
    const auto file = folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "f 1 2 3\n");
    for (const auto& [text, place] :
         {std::pair{"newmtl a\nKd nan 0 0\n", "m.mtl:2: \"nan\""},
          std::pair{"newmtl a\n\nNs many\n", "m.mtl:3: \"many\""},
          std::pair{"newmtl a\nKd\n", "m.mtl:2: Kd has no number"},
          std::pair{"newmtl a\nKd \u22121\n", "m.mtl:2: \"\u22121\" in Kd is not a finite number: "
                                              "it holds a minus sign (U+2212)"},
          std::pair{"newmtl a\nKd\u00a0 1\n", "m.mtl:2: \"Kd\u00a0\" is no statement of MTL"},
          std::pair{"newmtl a\n\ufeffnewmtl b\n", "m.mtl:2: "},
          std::pair{"newmtl a\nNewMtl b\n", "m.mtl:2: \"NewMtl\" is no statement"}}) {
        folder.write("m.mtl", text);
        const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
        EXPECT_TRUE(contains(error.what(), place)) << error.what();
        EXPECT_EQ(error.status(), ExitStatus::badInput);
    }
}

TEST(Mtl, MissingFileAndUnknownMaterialsAreOneNoteEach) {
    const TempFolder folder;
    const ObjFile obj = loadObj(folder.write("m.obj", "# head\nmtllib none.mtl\n" + kTriangles +
                                                          "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\nusemtl a\nf 1 3 4\n"),
                                NormalMode::file, {});
    ASSERT_EQ(obj.notes.size(), 2u);
    EXPECT_TRUE(contains(obj.notes[0], "m.obj:2: material file \"none.mtl\" is missing")) << obj.notes[0];
    EXPECT_TRUE(contains(obj.notes[1], "m.obj:7: no material file defines 'a' (and 1 other)")) << obj.notes[1];
}

TEST(Mtl, PathsOutsideTheFolderAreRefusedAndTheOptionNamed) {
    const TempFolder folder;
    folder.write("outside.mtl", "newmtl a\n");
    std::filesystem::create_directories(folder.path() / "in");
    std::filesystem::create_symlink(folder.path() / "outside.mtl", folder.path() / "in/link.mtl");
    for (const std::string& name : {std::string("../../../../../../etc/passwd"), std::string("/etc/passwd"),
                                    std::string("../outside.mtl"), std::string("link.mtl"), std::string("..")}) {
        const auto file = folder.write("in/m.obj", "mtllib " + name + "\n" + kTriangles + "f 1 2 3\n");
        const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_TRUE(contains(error.what(), "m.obj:1: ")) << error.what();
        EXPECT_TRUE(contains(error.what(), "--allow DIR")) << error.what();
    }
    LoadOptions options;
    options.allowed = {folder.path()};
    const auto file = folder.write("in/m.obj", "mtllib ../outside.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n");
    EXPECT_EQ(loadObj(file, NormalMode::file, options).materials.size(), 1u);
}

TEST(Mtl, AFifoADeviceOrAFolderDoesNotHang) {
    const TempFolder folder;
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.mtl").c_str(), 0600), 0);
    std::filesystem::create_directory(folder.path() / "folder.mtl");
    for (const auto& [name, message] :
         {std::pair{"pipe.mtl", "m.obj:1: material file \"pipe.mtl\" is not a regular file; name a readable file"},
          std::pair{"folder.mtl", "m.obj:1: material file \"folder.mtl\" is a folder; name a file in it"},
          std::pair{".", "m.obj:1: material file \".\" is a folder; name a file in it"}}) {
        const auto file = folder.write("m.obj", "mtllib " + std::string(name) + "\n" + kTriangles + "f 1 2 3\n");
        const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        EXPECT_TRUE(contains(error.what(), message)) << error.what();
    }
}

TEST(Mtl, FilesBeyondSixteenMegabytesAreRefused) {
    const TempFolder folder;
    folder.write("huge.mtl", std::string((16u << 20) + 1, '\n'));
    const auto file = folder.write("m.obj", "mtllib huge.mtl\n" + kTriangles + "f 1 2 3\n");
    EXPECT_EQ(errorOf([&] { (void)loadObj(file, NormalMode::file, {}); }).status(), ExitStatus::overLimit);
}

TEST(Mtl, StrangeFolderAndFileNamesWork) {
    for (const std::string& name :
         {std::string("a:b"), std::string("a;b"), std::string("a b"), std::string("\xc3\xa4"), std::string("a\nb")}) {
        const TempFolder folder;
        folder.write(name + "/my file.mtl", "newmtl a\nKd 1 0 0\n");
        const auto file = folder.write(name + "/m.obj", "mtllib my file.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n");
        const ObjFile obj = loadObj(file, NormalMode::file, {});
        ASSERT_EQ(obj.materials.size(), 1u) << name;
        EXPECT_EQ(obj.materials[0].diffuse, vec3(1, 0, 0));
    }
}

TEST(Mtl, OneLineMayNameSeveralLibraries) {
    const TempFolder folder;
    folder.write("a.mtl", "newmtl a\n");
    folder.write("b.mtl", "newmtl b\n");
    const auto file = folder.write("m.obj", "mtllib a.mtl b.mtl\nmtllib a.mtl b.mtl\n" + kTriangles + "f 1 2 3\n");
    EXPECT_EQ(loadObj(file, NormalMode::file, {}).materials.size(), 2u);
}

TEST(Mtl, AlphaMapsAreKeptWhenTheyMayBeRead) {
    const TempFolder folder;
    const std::vector<std::uint8_t> png = image::encodePng(image::Image(1, 1), {.opaque = false, .text = {}});
    folder.write("leaf.png", {png.begin(), png.end()});
    folder.write("m.mtl",
                 "newmtl a\nmap_d -clamp on leaf.png\nnewmtl b\nmap_d ../../etc/passwd\nnewmtl c\nmap_d none.png\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(obj.materials[0].alphaMap, (folder.path() / "leaf.png").string());
    ASSERT_NE(obj.materials[0].alphaMask, nullptr);
    EXPECT_TRUE(obj.materials[0].alphaMask->isHole({0.5, 0.5}, false));
    EXPECT_EQ(obj.materials[1].alphaMap, "");
    EXPECT_EQ(obj.materials[1].alphaMask, nullptr);
    EXPECT_EQ(obj.materials[2].alphaMask, nullptr);
    ASSERT_EQ(obj.notes.size(), 3u);
    EXPECT_TRUE(contains(obj.notes[0], "m.mtl:4: material 'b': map_d \"../../etc/passwd\" is ignored: it lies outside"))
        << obj.notes[0];
    EXPECT_TRUE(contains(obj.notes[1], "m.mtl:6: material 'c': map_d \"none.png\" is ignored: ")) << obj.notes[1];
    EXPECT_TRUE(contains(obj.notes[2], "no holes are cut in 1 triangle without texture coordinates")) << obj.notes[2];
}

TEST(Mtl, ANoteOnAnAlphaMapNamesTheLineThatCounts) {
    const TempFolder folder;
    folder.write("a.mtl", "newmtl a\nmap_d first.png\nmap_d last.png\nnewmtl a\nmap_d again.png\n");
    folder.write("b.mtl", "newmtl a\nmap_d other.png\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib a.mtl b.mtl\n" + kTriangles + "f 1 2 3\n"), NormalMode::file, {});
    std::size_t named = 0;
    for (const std::string& note : obj.notes)
        if (contains(note, "map_d \"")) { // not the note that a further one replaces it
            EXPECT_TRUE(contains(note, "a.mtl:3: material 'a': map_d \"last.png\" is ignored: ")) << note;
            ++named;
        }
    EXPECT_EQ(named, 1u);
}

} // namespace
} // namespace shadowlab::scene
