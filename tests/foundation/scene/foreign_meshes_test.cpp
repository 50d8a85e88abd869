// OBJ and MTL files as other programs and other systems write them: what is harmless is taken, and said once.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/model/holes.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kTriangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"; // lines 1 to 4
const std::string kRed = "newmtl red\nKd 1 0 0\n";

std::size_t notesWith(const ObjFile& obj, const std::string& part) {
    return static_cast<std::size_t>(
        std::ranges::count_if(obj.notes, [&](const std::string& note) { return contains(note, part); }));
}

/// Of the material of the mesh's first part; -1 where no file defines it.
float firstRed(const ObjFile& obj) {
    const MaterialsByName known = materialsByName(obj.materials);
    const auto found = known.find(obj.mesh.parts.front().materialName);
    return found == known.end() ? -1.0f : obj.materials[found->second].diffuse.x;
}

TEST(ForeignMeshes, NamelessStatementsAreNotedAndHarmless) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl\nKd 0 1 0\nnewmtl \nKd 0 0 1\n" + kRed);
    const auto file = folder.write("m.obj", kTriangles + "mtllib\nmtllib m.mtl\nusemtl red\nf 1 2 3\nusemtl\nf 1 2 4\n"
                                                         "usemtl  \nf 1 3 4\n");
    const ObjFile obj = loadObj(file, NormalMode::file, {});
    ASSERT_EQ(obj.mesh.parts.size(), 2u);
    EXPECT_EQ(obj.mesh.parts[0].materialName, "red");
    EXPECT_EQ(obj.mesh.parts[1].materialName, ""); // the default, and no material of no name
    EXPECT_EQ(obj.mesh.parts[1].triangleCount, 2u);
    EXPECT_EQ(firstRed(obj), 1.0f);
    EXPECT_EQ(obj.materials.size(), 1u);
    EXPECT_EQ(notesWith(obj, "m.obj:5: mtllib has no name"), 1u);
    EXPECT_EQ(notesWith(obj, "m.obj:9: usemtl has no name; the faces after it get the default material (and 1 more"),
              1u);
    EXPECT_EQ(notesWith(obj, "m.mtl:1: newmtl has no name; its material cannot be used (and 1 more time)"), 1u);
    EXPECT_EQ(obj.notes.size(), 3u);
}

TEST(ForeignMeshes, NanInTextureCoordinatesAndNormalsIsHarmlessHoweverItIsWritten) {
    const TempFolder folder;
    for (const std::string nan : {"nan", "-nan(ind)", "inf", "1.#QNAN", "-1.#QNAN", "1.#QNAN0", "-1.#IND", "-1.#IND00",
                                  "1.#INF", "-1.#INF", "+1.#INF00", "1.#SNAN", "1.#R", "-1.#J", "1.#QNAN0e+000"}) {
        const std::string vt = "vt 0 0\nvt " + nan + " " + nan + "\nvn 0 0 1\nvn " + nan + " 0 " + nan + "\n";
        const ObjFile obj =
            loadObj(folder.write("m.obj", kTriangles + vt + "f 1/1/1 2/2/1 3/1/1\nf 1/1/1 2/1/2 4/1/1\n"),
                    NormalMode::file, {});
        ASSERT_EQ(obj.mesh.triangles.size(), 2u) << nan;
        EXPECT_EQ(std::ranges::count_if(obj.mesh.parts, &MeshPart::hasTexcoords), 1) << nan; // the second triangle
        EXPECT_EQ(notesWith(obj, "m.obj:8: 1 normal (vn) without a direction"), 1u) << nan;
    }
}

TEST(ForeignMeshes, FoIsAFaceAndOtherGeometryIsNotedOncePerKind) {
    const TempFolder folder;
    const auto file =
        folder.write("m.obj", kTriangles + "fo 1 2 3\nl 1 2\nl 2 3\np 1\ncstype bezier\ndeg 1 1\n"
                                           "surf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\ng a\no b\ns 1\nf 1 2 4\n"
                                           "curv 0 1 1 2\nbzp 1 2 3\nhello there\nhello again\n");
    const std::string place = file.string() + ":";
    EXPECT_EQ(loadObj(file, NormalMode::file, {}).notes,
              (std::vector<std::string>{
                  place + "6: l (lines) is not drawn (and 1 more time)", place + "8: p (points) is not drawn",
                  place + "11: surf (free-form surfaces) is not drawn",
                  place + "18: curv (free-form curves) is not drawn", place + "19: bzp (Bezier patches) is not drawn",
                  place + "20: \"hello\" is no statement of OBJ and is ignored (and 1 more time)"}));
    EXPECT_EQ(loadObj(file, NormalMode::file, {}).mesh.triangles.size(), 2u);
}

TEST(ForeignMeshes, ThousandsOfUnknownStatementsAreFewNotes) {
    const TempFolder folder;
    std::string text = kTriangles + "f 1 2 3\n";
    for (int i = 0; i < 3000; ++i)
        text += "x" + std::to_string(i) + "\n";
    EXPECT_LE(loadObj(folder.write("m.obj", text), NormalMode::file, {}).notes.size(), 5u);
}

TEST(ForeignMeshes, ABlankLineOrACommentBehindAnInvisibleCharacterIsNothing) {
    const TempFolder folder;
    const auto file = folder.write("m.obj", kTriangles + "\u00a0\n\ufeff# second half\n\u00a0\u200b \nf 1 2 3\n");
    EXPECT_TRUE(loadObj(file, NormalMode::file, {}).notes.empty());
}

/// What mtllib says, for a file Scene.mtl beside the mesh and sub/Other One.mtl below.
TEST(ForeignMeshes, LibrariesAreFoundUnderOtherSpellings) {
    const TempFolder folder;
    folder.write("Scene.mtl", kRed);
    folder.write("sub/Other One.mtl", kRed);
    folder.write("W\u00fcrfel.mtl", kRed);
    folder.write("no#3.mtl", kRed);
    folder.write("hash #4.mtl", kRed);
    const auto loaded = [&](const std::string& named) {
        return loadObj(folder.write("m.obj", "mtllib " + named + "\n" + kTriangles + "usemtl red\nf 1 2 3\n"),
                       NormalMode::file, {});
    };
    for (const std::string named :
         {"Scene.mtl", "./Scene.mtl", "Scene.mtl \t", "Scene.mtl # exported 2019", "Scene.mtl #1", "no#3.mtl",
          "hash #4.mtl", "sub/Other One.mtl", "sub/../Scene.mtl"}) {
        const ObjFile obj = loaded(named);
        EXPECT_EQ(firstRed(obj), 1.0f) << named;
        EXPECT_TRUE(obj.notes.empty()) << named << ": " << obj.notes.front();
    }
    for (const std::string named : {"\"Scene.mtl\"",
                                    "'Scene.mtl'",
                                    "\u201cScene.mtl\u201d",
                                    "\"Scene.mtl",
                                    "Scene.mtl\"",
                                    "scene.MTL",
                                    "SCENE.MTL",
                                    "\"scene.mtl\" # exported 2019",
                                    "scene.mtl # exported 2019",
                                    "C:\\Users\\me\\My Models\\Scene.mtl",
                                    "c:/models/SCENE.mtl",
                                    "\\\\server\\share\\Scene.mtl",
                                    "/models/Scene.mtl",
                                    ".\\Scene.mtl",
                                    "Scene.mtl\u00a0",
                                    "sub\\Other One.mtl",
                                    "SUB\\other one.mtl",
                                    "sub\\Other\\ One.mtl",
                                    "\"sub/Other One.mtl\"",
                                    "sub/Other\\ One.mtl",
                                    "D:\\x\\sub\\Other One.mtl",
                                    "W\u00dcRFEL.MTL",
                                    "sub/Other%20One.mtl",
                                    "sub%5cOther%20One.mtl",
                                    "file:///C:/models/My%20Models/Scene.mtl",
                                    "file://localhost/models/sub/Other%20One.mtl",
                                    "FILE:Scene.mtl",
                                    "W%C3%BCrfel.mtl",
                                    "sub\\..\\Scene.mtl"}) {
        const ObjFile obj = loaded(named);
        EXPECT_EQ(firstRed(obj), 1.0f) << named;
        EXPECT_EQ(notesWith(obj, "m.obj:1: material file "), 1u) << named;
        EXPECT_EQ(notesWith(obj, " is read in its place"), 1u) << named;
        EXPECT_EQ(obj.notes.size(), 1u) << named;
    }
    for (const std::string named : {"Scene2.mtl", "Scen.mtl", "other/Scene.mtl", "C:Scene.mtl", "Scene%2.mtl", "Scene.mtl%00", "file://"})
        EXPECT_EQ(notesWith(loaded(named), "is missing"), 1u) << named;
    EXPECT_EQ(notesWith(loaded("# Scene.mtl"), "no material file defines 'red'"), 1u);
}

TEST(ForeignMeshes, SeveralLibrariesOnALineAreToldFromANameWithBlanks) {
    const TempFolder folder;
    folder.write("a.mtl", kRed);
    folder.write("b c.mtl", "newmtl blue\n");
    for (const std::string named : {"a.mtl \"b c.mtl\"", "\"a.mtl\" \"b c.mtl\" # both", "A.MTL \"B C.MTL\""}) {
        const auto file = folder.write("m.obj", "mtllib " + named + "\n" + kTriangles + "usemtl red\nf 1 2 3\n");
        EXPECT_EQ(loadObj(file, NormalMode::file, {}).materials.size(), 2u) << named;
    }
    // Two absolute paths are two files, although the line ends like one of them.
    const auto file =
        folder.write("m.obj", "mtllib C:\\x\\a.mtl C:\\x\\A.mtl\n" + kTriangles + "usemtl red\nf 1 2 3\n");
    EXPECT_EQ(firstRed(loadObj(file, NormalMode::file, {})), 1.0f);
}

TEST(ForeignMeshes, SeveralFilesThatDifferInCaseAreNotGuessedBetween) {
    const TempFolder folder;
    folder.write("Scene.mtl", kRed);
    folder.write("SCENE.mtl", kRed);
    const auto file = folder.write("m.obj", "mtllib scene.mtl\n" + kTriangles + "usemtl red\nf 1 2 3\n");
    const std::string note = loadObj(file, NormalMode::file, {}).notes.at(0);
    EXPECT_TRUE(
        contains(note, "\"scene.mtl\" is missing (\"SCENE.mtl\" and \"Scene.mtl\" differ from it in case alone)"))
        << note;
}

TEST(ForeignMeshes, TheSearchStaysInTheAllowedFolders) {
    const TempFolder folder;
    folder.write("Outside.mtl", kRed);
    folder.write("other/Inner.mtl", kRed);
    folder.write("in/readme", "");
    std::filesystem::create_symlink(folder.path() / "Outside.mtl", folder.path() / "in/Link.mtl");
    std::filesystem::create_symlink(folder.path() / "other", folder.path() / "in/Linked");
    for (const std::string named :
         {"..\\Outside.mtl", "../outside.mtl", "..\\other\\inner.mtl", "link.mtl", "LINK.MTL", "linked\\inner.mtl",
          "Linked/inner.mtl", "\"../Outside.mtl\"", "\\..\\Outside.mtl"}) {
        const auto file = folder.write("in/m.obj", "mtllib " + named + "\n" + kTriangles + "usemtl red\nf 1 2 3\n");
        try {
            EXPECT_EQ(loadObj(file, NormalMode::file, {}).materials.size(), 0u) << named;
        } catch (const Error& error) {
            EXPECT_TRUE(contains(error.what(), "--allow DIR")) << error.what();
        }
    }
    LoadOptions options;
    options.allowed = {folder.path()};
    const auto file = folder.write("in/m.obj", "mtllib ..\\outside.MTL\n" + kTriangles + "usemtl red\nf 1 2 3\n");
    EXPECT_EQ(loadObj(file, NormalMode::file, options).materials.size(), 1u); // allowed, so found
}

TEST(ForeignMeshes, AFileOfTheSameNameStandsInForALibraryThatNoLineNames) {
    const TempFolder folder;
    folder.write("chair.mtl", kRed);
    const ObjFile obj = loadObj(folder.write("chair.obj", kTriangles + "usemtl red\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(firstRed(obj), 1.0f);
    EXPECT_EQ(notesWith(obj, "chair.obj:5: no mtllib names a material file; \"chair.mtl\" beside the mesh is read"),
              1u);
    EXPECT_TRUE(loadObj(folder.write("chair.obj", kTriangles + "f 1 2 3\n"), NormalMode::file, {}).notes.empty());
}

/// The name that usemtl writes, the names that newmtl writes, and which of these is meant (-1: none).
TEST(ForeignMeshes, MaterialNamesAreFoundWithoutQuotesAndComments) {
    struct Case {
        std::string used;
        std::vector<std::string> defined;
        int meant;
    };
    const TempFolder folder;
    for (const auto& [used, defined, meant] : {
             Case{"m # the blue one", {"m"}, 0},
             Case{"m", {"m # blue"}, 0},
             Case{"m # used", {"m # defined"}, 0},
             Case{"\"m\"", {"m"}, 0},
             Case{"m", {"\"m\""}, 0},
             Case{"\"m", {"m"}, 0},
             Case{"\u201cm\u201d", {"m"}, 0},
             Case{"M", {"m"}, 0},
             Case{"m\u00a0", {"m"}, 0},
             Case{"Material #25", {"Material #24", "Material #25", "Material"}, 1}, // `#` is part of the name
             Case{"Material #27", {"Material #25"}, -1},
             Case{"Material #27", {"Material #25", "Material"}, 1},
             Case{"Material", {"Material #25", "Material #26"}, -1}, // either might be meant
             Case{"m", {"M", "\"m\""}, 1},
             Case{"mm", {"m", "M"}, -1},
             Case{"xX", {"Xx", "xx"}, -1},
         }) {
        std::string mtl;
        for (std::size_t i = 0; i < defined.size(); ++i)
            mtl += "newmtl " + defined[i] + "\nKd 0." + std::to_string(i + 1) + " 0 0\n";
        folder.write("m.mtl", mtl);
        const ObjFile obj =
            loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl " + used + "\nf 1 2 3\n"),
                    NormalMode::file, {});
        const bool isExact = std::ranges::find(defined, used) != defined.end();
        EXPECT_EQ(firstRed(obj), meant < 0 ? -1.0f : static_cast<float>(0.1 * (meant + 1))) << used;
        EXPECT_EQ(notesWith(obj, "m.obj:6: no material file defines '" + used + "'"), isExact ? 0u : 1u) << used;
        EXPECT_EQ(notesWith(obj, "is taken for it"), isExact || meant < 0 ? 0u : 1u) << used;
    }
    folder.write("m.mtl", kRed);
    const ObjFile none = loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl # none\nf 1 2 3\n"),
                                 NormalMode::file, {});
    EXPECT_EQ(none.mesh.parts[0].materialName, "");
    EXPECT_EQ(notesWith(none, "the default material is taken for it"), 1u);
}

TEST(ForeignMeshes, PicturesAreFoundUnderOtherSpellingsAndBesideTheirMaterials) {
    const TempFolder folder;
    const auto png = [](std::uint8_t side) {
        const auto bytes = image::encodePng(image::Image(side, side), {.opaque = false, .text = {}});
        return std::string(bytes.begin(), bytes.end());
    };
    folder.write("leaf.png", png(1));
    folder.write("tex/Leaf Two.png", png(2));
    folder.write("mats/leaf.png", png(3));
    const auto maskOf = [&](const std::string& library, const std::string& written) {
        folder.write(library, "newmtl red\nmap_d " + written + "\n");
        const ObjFile obj = loadObj(
            folder.write("m.obj", "mtllib " + library + "\n" + kTriangles + "vt 0 0\nusemtl red\nf 1/1 2/1 3/1\n"),
            NormalMode::file, {});
        EXPECT_LE(obj.notes.size(), 1u) << written;
        EXPECT_EQ(notesWith(obj, "red.mtl:2: picture "), obj.notes.size()) << written;
        const auto& mask = obj.materials.at(0).alphaMask;
        return std::pair(mask ? std::sqrt(static_cast<double>(mask->texels().size())) : 0.0, obj.notes.size());
    };
    EXPECT_EQ(maskOf("red.mtl", "leaf.png"), std::pair(1.0, std::size_t{0}));
    EXPECT_EQ(maskOf("mats/red.mtl", "leaf.png"), std::pair(3.0, std::size_t{0})); // beside the file that names it
    EXPECT_EQ(maskOf("mats/red.mtl", "tex/Leaf Two.png"), std::pair(2.0, std::size_t{0}));
    for (const std::string written : {"LEAF.PNG", "\"leaf.png\"", "leaf.png # a leaf", "C:\\pictures\\leaf.png"})
        EXPECT_EQ(maskOf("red.mtl", written), std::pair(1.0, std::size_t{1})) << written;
    for (const std::string written : {"tex\\Leaf Two.png", "-clamp on tex\\leaf two.PNG", "C:\\m\\tex\\Leaf Two.png"})
        EXPECT_EQ(maskOf("red.mtl", written), std::pair(2.0, std::size_t{1})) << written;
    EXPECT_EQ(maskOf("mats/red.mtl", "C:\\pictures\\Leaf.png"), std::pair(3.0, std::size_t{1}));
}

std::string utf16(const std::string& text, bool isBigEndian, bool hasMark) {
    std::string bytes;
    const auto add = [&](char32_t unit) {
        const char low = static_cast<char>(unit & 255), high = static_cast<char>(unit >> 8);
        bytes += isBigEndian ? high : low;
        bytes += isBigEndian ? low : high;
    };
    if (hasMark) add(0xfeff);
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = sequenceLength(std::string_view(text).substr(i));
        const char32_t c = codePoint(std::string_view(text).substr(i, length));
        if (c >= 0x10000) add(0xd800 + ((c - 0x10000) >> 10));
        add(c >= 0x10000 ? 0xdc00 + ((c - 0x10000) & 0x3ff) : c);
        i += length;
    }
    return bytes;
}

TEST(ForeignMeshes, Utf16IsConverted) {
    const TempFolder folder;
    const std::string name = "r\u00f6t \u4e00 \U0001f600"; // of two, three and four bytes in UTF-8
    const std::string mesh = "# \u4e00\u4e00\u4e00\u4e00\u4e00\u4e00 head\r\nmtllib m.mtl\r\n" + kTriangles +
                             "usemtl " + name + "\r\nf 1 2 3\r\n";
    const std::string mtl = "newmtl " + name + "\nKd 1 0 0\n";
    for (const bool isBigEndian : {false, true})
        for (const bool hasMark : {false, true}) {
            folder.write("m.mtl", utf16(mtl, isBigEndian, hasMark));
            const ObjFile obj = loadObj(folder.write("m.obj", utf16(mesh, isBigEndian, hasMark)), NormalMode::file, {});
            EXPECT_EQ(firstRed(obj), 1.0f) << isBigEndian << hasMark;
            EXPECT_TRUE(obj.notes.empty());
            const Error error = errorOf([&] {
                (void)loadObj(folder.write("bad.obj", utf16(kTriangles + "f 1 2 9\n", isBigEndian, hasMark)),
                              NormalMode::file, {});
            });
            EXPECT_TRUE(contains(error.what(), "bad.obj:5: vertex index 9")) << error.what();
        }
}

TEST(ForeignMeshes, StatementsOfMtlInAnotherCaseAreNoted) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl red\nkd 1 0 0\nKD 1 0 0\nkd 1 0 0\n");
    const ObjFile obj =
        loadObj(folder.write("m.obj", "mtllib m.mtl\n" + kTriangles + "usemtl red\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_EQ(notesWith(obj, "m.mtl:2: \"kd\" is no statement of MTL and is ignored; Kd may be meant (and 1 more"), 1u);
    EXPECT_EQ(notesWith(obj, "m.mtl:3: \"KD\" is no statement of MTL"), 1u);
}

TEST(ForeignMeshes, BrokenUtf16IsRefusedOrHarmless) {
    const TempFolder folder;
    const auto messageOf = [&](const std::string& bytes) {
        return std::string(errorOf([&] { (void)loadObj(folder.write("m.obj", bytes), NormalMode::file, {}); }).what());
    };
    const std::string good = utf16(kTriangles + "f 1 2 3\n", false, true);
    EXPECT_TRUE(contains(messageOf(good + "\n"), "m.obj:6: the UTF-16 text ends in half a character"))
        << messageOf(good + "\n");
    EXPECT_TRUE(contains(messageOf(good + std::string(2, '\0')), "m.obj:6: binary data (a NUL byte)"));
    EXPECT_TRUE(contains(messageOf(std::string("\xff\xfe\0\0v\0\0\0", 8)), "m.obj:1: the text is encoded as UTF-32"));
    EXPECT_TRUE(contains(messageOf("\xff\xfe"), "the file is empty"));
    // Half of a surrogate pair: harmless in a comment, and never part of a number.
    const std::string half("\x3d\xd8", 2);
    EXPECT_EQ(loadObj(folder.write("m.obj", good + utf16("# ", false, false) + half), NormalMode::file, {})
                  .mesh.triangles.size(),
              1u);
    EXPECT_TRUE(
        contains(messageOf(good + utf16("v 1", false, false) + half), "m.obj:6: \"1\\xed\\xa0\\xbd\" is not a number"));
}

} // namespace
} // namespace shadowlab::scene
