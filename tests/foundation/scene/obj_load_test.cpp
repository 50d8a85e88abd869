// What an OBJ file may be, and what becomes of it: the same mesh for every way of writing it down.
// SPDX-License-Identifier: MIT
#include <clocale>
#include <cmath>
#include <locale>
#include <set>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

ObjFile load(const std::string& text, NormalMode mode = NormalMode::file) {
    const TempFolder folder;
    return loadObj(folder.write("mesh.obj", text), mode, {});
}

void expectSame(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.originObject, b.originObject);
    EXPECT_EQ(a.positionsMesh, b.positionsMesh);
    EXPECT_EQ(a.normalsMesh, b.normalsMesh);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(ObjLoad, AQuadBecomesTwoTrianglesWithFlatNormals) {
    const Mesh mesh = load(kSquare + "f 1 2 3 4\n").mesh;
    EXPECT_EQ(mesh.triangles, (std::vector<uvec3>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.positionsMesh, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    for (const vec3& normal : mesh.normalsMesh)
        EXPECT_EQ(normal, vec3(0, 0, 1));
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].triangleCount, 2u);
    EXPECT_EQ(mesh.droppedTriangles, 0u);
    EXPECT_EQ(mesh.originObject, dvec3(0.0));
}

TEST(ObjLoad, EveryWayOfWritingGivesTheSameMesh) {
    const Mesh expected = load(kSquare + "f 1 2 3 4\n").mesh;
    const auto replaced = [](std::string text, char from, const std::string& to) {
        for (std::size_t i = 0; (i = text.find(from, i)) != std::string::npos; i += to.size())
            text.replace(i, 1, to);
        return text;
    };
    const std::string plain = kSquare + "f 1 2 3 4\n";
    const std::vector<std::pair<const char*, std::string>> ways{
        {"CR LF", replaced(plain, '\n', "\r\n")},
        {"CR alone", replaced(plain, '\n', "\r")},
        {"byte order mark", "\xef\xbb\xbf" + plain},
        {"no newline at the end", plain.substr(0, plain.size() - 1)},
        {"tabs and many blanks", replaced(plain, ' ', " \t  ")},
        {"blanks around lines", replaced("  " + plain, '\n', " \t\n\n  ")},
        {"comments", "# head\n" + replaced(plain, '\n', " # tail \\\n")},
        {"continuation lines", replaced(plain, ' ', " \\\n")},
        {"negative indices", kSquare + "f -4 -3 -2 -1\n"},
        {"forward references", "f 1 2 3 4\n" + kSquare},
        {"all slashes", kSquare + "vt 0 0\nf 1/1 2/1 3/1 4/1\n"},
        {"empty slashes", kSquare + "f 1// 2// 3/ 4/\n"},
        {"vertex weights", "v 0 0 0 1\nv 1 0 0 2\nv 1 1 0 1\nv 0 1 0 1\nf 1 2 3 4\n"},
        {"vertex colours", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3 4\n"},
        {"other number forms", "v 0.0 -0 +0\nv 1e0 0. .0\nv +1 100E-2 0\nv 0 0.1e+1 1e-400\nf 1 2 3 4\n"},
        {"statements we do not know",
         "o thing\ng a b\ns off\n" + plain + "l 1 2\np 1\nvp 0 0\nvw 1e10 nan\ncurv 0 1 \\\nf 9\n"},
        {"unused faraway vertex", plain + "v 1e9 1e9 1e9\n"},
    };
    for (const auto& [name, text] : ways) {
        SCOPED_TRACE(name);
        expectSame(load(text).mesh, expected);
    }
}

/// Decimal comma and grouped thousands, for C++ streams; needs no locale to be installed.
struct CommaNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(ObjLoad, TheLocaleOfStreamsChangesNothing) {
    const TempFolder folder;
    folder.write("m.mtl", "newmtl a\nKd 0.25 0.5 0.75\nNs 12345.5\n");
    std::string text = "mtllib m.mtl\nusemtl a\n";
    for (int i = 0; i < 2000; ++i)
        text += "v 0.5 0 0\nv 1.25 0 0\nv 0 1.5 0\n"; // indices beyond a thousand
    const auto file = folder.write("m.obj", text + "f 4001 4002 4003\n");
    const ObjFile expected = loadObj(file, NormalMode::file, {});
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
    const ObjFile obj = loadObj(file, NormalMode::file, {});
    std::locale::global(before);
    expectSame(obj.mesh, expected.mesh);
    EXPECT_EQ(obj.materials[0].diffuse, vec3(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(obj.materials[0].shininess, 12345.5f);
}

TEST(ObjLoad, TheLocaleOfCChangesNothing) {
    const Mesh expected = load("v 0.5 0 0\nv 1.25 0 0\nv 0 1.5 0\nf 1 2 3\n").mesh;
    const char* comma = nullptr;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "nl_NL.UTF-8"})
        if (!comma) comma = std::setlocale(LC_ALL, name);
    if (!comma) GTEST_SKIP() << "no locale with a decimal comma is installed";
    const Mesh mesh = load("v 0.5 0 0\nv 1.25 0 0\nv 0 1.5 0\nf 1 2 3\n").mesh;
    std::setlocale(LC_ALL, "C");
    expectSame(mesh, expected);
}

TEST(ObjLoad, ConcavePolygonsKeepTheirArea) {
    const Mesh dart = load("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\nf 2 3 4 1\n").mesh;
    EXPECT_DOUBLE_EQ(area(dart), 8.0) << "a triangle outside the dart would add to the area";
    const Mesh pentagon = load("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n").mesh;
    EXPECT_DOUBLE_EQ(area(pentagon), 10.0);
    EXPECT_EQ(areaVectorSum(pentagon), dvec3(0, 0, 10));
}

TEST(ObjLoad, PolygonsWithMoreThan255CornersAreWhole) {
    std::string text;
    const int n = 3000;
    for (int i = 0; i < n; ++i)
        text += "v " + std::to_string(std::cos(2.0 * 3.14159265358979 * i / n)) + " " +
                std::to_string(std::sin(2.0 * 3.14159265358979 * i / n)) + " 0\n";
    text += "f";
    for (int i = 1; i <= n; ++i)
        text.append(" ").append(std::to_string(i));
    const ObjFile obj = load(text + "\n");
    EXPECT_EQ(obj.mesh.triangles.size() + obj.mesh.droppedTriangles, static_cast<std::size_t>(n - 2));
    EXPECT_NEAR(area(obj.mesh), 3.14159, 1e-4);
}

TEST(ObjLoad, DegenerateTrianglesAreDroppedAndCounted) {
    const ObjFile obj = load(kSquare + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 2 3 3\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 2u);
    EXPECT_EQ(obj.mesh.droppedTriangles, 3u) << "repeated index, straight line, repeated corner of a quad";
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "mesh.obj: dropped 3 degenerate triangles")) << obj.notes[0];
    for (const vec3& normal : obj.mesh.normalsMesh)
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
}

TEST(ObjLoad, DetailFarFromTheOriginSurvives) {
    // Steps of 0.1 mm at 100 km: float alone has steps of 8 mm there.
    std::string text;
    for (int i = 0; i <= 100; ++i) {
        char line[200];
        std::snprintf(line, sizeof line, "v %.4f 100000 -100000\nv %.4f 100000.01 -100000\n", 100000 + 0.0001 * i,
                      100000 + 0.0001 * i);
        text += line;
    }
    for (int i = 0; i < 100; ++i) {
        text += 'f';
        for (const int k : {1, 3, 4, 2})
            text.append(" ").append(std::to_string(2 * i + k));
        text += '\n';
    }
    const Mesh mesh = load(text).mesh;
    EXPECT_EQ(mesh.triangles.size(), 200u);
    EXPECT_NE(mesh.originObject.x, 0.0);
    std::set<float> columns;
    for (const vec3& p : mesh.positionsMesh)
        columns.insert(p.x);
    EXPECT_EQ(columns.size(), 101u);
    double x = 100000.0; // ascending, each where the file has it
    for (const float column : columns) {
        EXPECT_NEAR(mesh.originObject.x + column, x, 2e-9);
        x += 0.0001;
    }
    EXPECT_NEAR(area(mesh), 0.01 * 0.01, 1e-9);
}

TEST(ObjLoad, OrdinaryMeshesKeepTheirExactFloats) {
    const Mesh mesh = load("v 5.1 0.3 0\nv 6.1 0.3 0\nv 5.1 1.3 0.7\nf 1 2 3\n").mesh;
    EXPECT_EQ(mesh.originObject, dvec3(0.0));
    EXPECT_EQ(mesh.positionsMesh[0], vec3(5.1f, 0.3f, 0.0f));
}

TEST(ObjLoad, NormalsOfTheFileAreUsedAndMadeUnit) {
    const Mesh mesh = load(kSquare + "vn 0 3 4\nvn 1e200 0 0\nf 1//1 2//1 3//2\n").mesh;
    EXPECT_EQ(mesh.normalsMesh[0], vec3(0.0f, 0.6f, 0.8f));
    EXPECT_EQ(mesh.normalsMesh[2], vec3(1.0f, 0.0f, 0.0f));
}

TEST(ObjLoad, CornersWithoutAUsableNormalGetTheFlatOne) {
    const ObjFile obj = load(kSquare + "vn 0 0 0\nvn nan 0 1\nvn 1 0 0\nf 1//1 2//2 3\nf 1//3 3//3 4//3\n");
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(obj.mesh.normalsMesh[obj.mesh.triangles[0][i]], vec3(0, 0, 1));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(obj.mesh.normalsMesh[obj.mesh.triangles[1][i]], vec3(1, 0, 0));
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "mesh.obj:5: 2 normals (vn) without a direction")) << obj.notes[0];
}

TEST(ObjLoad, NormalModesFlatAndSmoothIgnoreTheFile) {
    // Two faces of a roof; the ridge is shared.
    const std::string roof = "v 0 0 0\nv 1 1 0\nv 2 0 0\nv 0 0 1\nv 1 1 1\nv 2 0 1\nvn 0 0 1\n"
                             "f 1//1 4//1 5//1 2//1\nf 5//1 6//1 3//1 2//1\n"; // split symmetrically about the ridge
    const Mesh flat = load(roof, NormalMode::flat).mesh;
    EXPECT_EQ(flat.positionsMesh.size(), 8u) << "the ridge is split";
    const Mesh smooth = load(roof, NormalMode::smooth).mesh;
    EXPECT_EQ(smooth.positionsMesh.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i)
        if (smooth.positionsMesh[i].x == 1.0f) {
            EXPECT_LT(glm::length(smooth.normalsMesh[i] - vec3(0, 1, 0)), 1e-6f) << "the ridge points up";
        }
}

TEST(ObjLoad, EqualVerticesAreSharedAndNegativeZeroIsZero) {
    const Mesh mesh = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 -0.0 0\nv 1.0 0 0\nv 0 -1 0\nf 1 2 3\nf 5 4 6\n").mesh;
    EXPECT_EQ(mesh.triangles.size(), 2u);
    std::set<std::array<std::uint32_t, 3>> bits;
    for (const vec3& p : mesh.positionsMesh)
        bits.insert(
            {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y), std::bit_cast<std::uint32_t>(p.z)});
    EXPECT_EQ(bits.size(), 4u);
}

TEST(ObjLoad, TinyMeshesComeWithAWarning) {
    const ObjFile obj = load("v 0 0 0\nv 1e-38 0 0\nv 0 1e-38 0\nf 1 2 3\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 1u);
    ASSERT_EQ(obj.notes.size(), 1u);
    EXPECT_TRUE(contains(obj.notes[0], "scale it up")) << obj.notes[0];
}

TEST(ObjLoad, GroupsWithoutANumberAndWeightsAreNoted) {
    const TempFolder folder;
    const auto file = folder.write("m.obj", "v 0 0 0 1 1 0 0\nv 1 0 0 1 1 0 0\nv 0 1 0\ns foo\nf 1 2 3\ns off\nf 1 2 3\ns -1\nf 1 2 3\n");
    const ObjFile obj = loadObj(file, NormalMode::file, {});
    ASSERT_GE(obj.notes.size(), 2u);
    const std::string name = file.string();
    EXPECT_EQ((std::vector<std::string>(obj.notes.begin(), obj.notes.begin() + 2)),
              (std::vector<std::string>{
                  name + ":1: v with 7 numbers is read as x y z w r g b; w is ignored (and 1 more time)",
                  name + ":4: s without a group's number (0 to 4294967295, on or off) is read as s off (and 1 more time)"}));
}

} // namespace
} // namespace shadowlab::scene
