// What an OBJ file and its materials look like: images and their options, colours of vertices, smoothing groups, mirrors and glass.
// SPDX-License-Identifier: MIT
#include <array>
#include <set>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/colored.h"

namespace shadowlab::scene {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string kImaged = "mtllib m.mtl\n" + kSquare + "usemtl m\nf 1/1 2/2 3/3 4/4\n";

/// A picture of two columns: red, and green.
std::string redAndGreen(std::uint8_t alphaOfGreen = 255) {
    image::Image picture(2, 1);
    picture.set(0, 0, {255, 0, 0, 255});
    picture.set(1, 0, {0, 255, 0, alphaOfGreen});
    const std::vector<std::uint8_t> bytes = image::encodePng(picture, {.opaque = alphaOfGreen == 255, .text = {}});
    return {bytes.begin(), bytes.end()};
}

ObjFile loaded(const std::string& mtl, const std::string& obj = kImaged) {
    const TempFolder folder;
    folder.write("two.png", redAndGreen());
    folder.write("leaf.png", redAndGreen(0));
    folder.write("m.mtl", "newmtl m\n" + mtl);
    return loadObj(folder.write("m.obj", obj), NormalMode::file, {});
}

TEST(ColorImage, InterpolatesInLinearLightBetweenCentresOfTexels) {
    const auto image = testing::imageOf({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}); // red green over blue white
    EXPECT_EQ(image->at({0.25, 0.75}, false), vec3(1, 0, 0)) << "the first row of the file is the upper one";
    EXPECT_EQ(image->at({0.25, 0.25}, false), vec3(0, 0, 1));
    EXPECT_EQ(image->at({0.5, 0.75}, false), vec3(0.5f, 0.5f, 0)) << "half of the light of each, and not half of the stored numbers";
    EXPECT_EQ(image->at({0.0, 0.75}, false), vec3(0.5f, 0.5f, 0)) << "repeated: the other end of the row is the neighbour";
    EXPECT_EQ(image->at({0.0, 0.75}, true), vec3(1, 0, 0)) << "clamped: the border goes on";
    EXPECT_EQ(image->at({-7.75, 1e9 + 0.25}, false), vec3(0, 0, 1));
}

TEST(MapKd, IsMultipliedWithKdAndStandsAloneWithoutOne) {
    const ObjFile both = loaded("Kd 0.5 0.5 0.5\nmap_Kd two.png\n"), alone = loaded("map_Kd two.png\n"), black = loaded("Kd 0 0 0\nmap_Kd two.png\n");
    for (const ObjFile* file : {&both, &alone, &black})
        ASSERT_NE(file->materials[0].colorImage, nullptr);
    EXPECT_EQ(both.materials[0].diffuse, vec3(0.5f));
    EXPECT_EQ(alone.materials[0].diffuse, vec3(1.0f));
    EXPECT_EQ(black.materials[0].diffuse, vec3(1.0f)) << "black would hide the image";
    EXPECT_EQ(both.materials[0].colorImage->at({0.25, 0.5}, false), vec3(1, 0, 0));
    EXPECT_TRUE(both.notes.empty());
}

TEST(MapKd, TransparentPartsAreDrawnOpaqueAndThatIsNoted) {
    const ObjFile twice = loaded("map_Kd leaf.png\nnewmtl n\nmap_Kd leaf.png\n", kImaged + "usemtl n\nf 1/1 2/2 3/3\n");
    ASSERT_EQ(twice.materials.size(), 2u);
    EXPECT_EQ(twice.materials[0].colorImage->at({0.75, 0.5}, false), vec3(0, 1, 0));
    ASSERT_EQ(twice.notes.size(), 1u);
    EXPECT_TRUE(twice.notes[0].ends_with("m.mtl:2: material 'm': map_Kd \"leaf.png\" has transparent parts, which are drawn opaque; to cut "
                                         "them out, name the image with map_d as well (and 1 more material)"))
        << twice.notes[0];
    EXPECT_TRUE(loaded("map_Kd leaf.png\nmap_d leaf.png\n").notes.empty()) << "they are cut out";
}

TEST(MapKd, TakesOptionsBeforeAndAfterTheName) {
    for (const std::string statement : {"map_Kd -s 8 2 1 -o 0.5 0.25 -clamp on two.png\n", "map_Kd two.png -s 8 2 -o 0.5 0.25 -clamp on\n"}) {
        const ObjFile file = loaded(statement);
        ASSERT_NE(file.materials[0].colorImage, nullptr) << statement;
        EXPECT_EQ(file.materials[0].colorPlacement, (ImagePlacement{{8, 2}, {0.5, 0.25}, true})) << statement;
        EXPECT_EQ(file.materials[0].colorPlacement.at({0.5, 0.5}), dvec2(4.5, 1.25));
    }
    const ObjFile inverted = loaded("map_Kd -mm 1 -1 two.png\n");
    EXPECT_EQ(inverted.materials[0].colorImage->at({0.25, 0.5}, false), vec3(0, 1, 1));
    const ObjFile noted = loaded("map_Kd -t 1 1 two.png\nmap_Kd -t 2 two.png\n");
    ASSERT_EQ(noted.notes.size(), 1u);
    EXPECT_TRUE(noted.notes[0].ends_with("m.mtl:2: option -t of map_Kd is not supported and ignored (and 1 more time)")) << noted.notes[0];
    EXPECT_NE(loaded("map_Kd -bm 0.3 two.png\n").materials[0].colorImage, nullptr);
}

TEST(MapD, TakesTheChosenChannelAndItsPlace) {
    const auto holeAt = [](const std::string& options, const dvec2& place) {
        const ObjFile file = loaded("map_d " + options + "two.png\n");
        EXPECT_NE(file.materials[0].alphaMask, nullptr) << options;
        const Material& material = file.materials[0];
        return material.alphaMask && material.alphaMask->isHole(material.alphaPlacement.at(place), material.alphaPlacement.clamped);
    };
    EXPECT_FALSE(holeAt("-imfchan r ", {0.25, 0.5}));
    EXPECT_TRUE(holeAt("-imfchan r ", {0.75, 0.5}));
    EXPECT_TRUE(holeAt("-imfchan g ", {0.25, 0.5}));
    EXPECT_TRUE(holeAt("-imfchan r -mm 1 -1 ", {0.25, 0.5}));
    EXPECT_TRUE(holeAt("-imfchan r -o 0.5 ", {0.25, 0.5}));
    EXPECT_FALSE(holeAt("-imfchan g -clamp on ", {1.25, 0.5})) << "the border goes on";
    EXPECT_TRUE(holeAt("-imfchan g ", {1.25, 0.5})) << "it repeats";
}

TEST(VertexColors, AreSrgbAndGoWithTheMaterialOfTheFile) {
    const std::string corners = "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\n";
    const ObjFile file = loaded("Kd 1 1 1\n", corners + "f 1 2 3\n");
    ASSERT_EQ(file.mesh.colors.size(), 3u);
    EXPECT_EQ(file.mesh.colors[0], vec3(1, 0, 0));
    EXPECT_NEAR(file.mesh.colors[1].g, 0.21404, 1e-5) << "0.5 of sRGB as light";
    EXPECT_EQ(file.mesh.colors[2], vec3(1)) << "none: white";
    EXPECT_EQ(file.materials[materialsByName(file.materials).at(file.mesh.parts[0].materialName)].diffuse, vec3(1.0f));
    const ObjFile bytes = loaded("Kd 1 1 1\n", "v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 255\nf 1 2 3\n");
    EXPECT_EQ(bytes.mesh.colors[0], vec3(1, 0, 0));
    ASSERT_EQ(bytes.notes.size(), 1u);
    EXPECT_TRUE(bytes.notes[0].ends_with("m.obj:1: vertex colours above 1 are taken to count to 255")) << bytes.notes[0];
    EXPECT_EQ(withNormals(file.mesh, NormalMode::smooth).colors.size(), 3u);
}

TEST(VertexColors, BeyondTheirRangeAreNoted) {
    const ObjFile below = loaded("", "v 0 0 0 1 -0.5 0\nv 1 0 0 0 1 -1\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(below.mesh.colors[0], vec3(1, 0, 0));
    ASSERT_EQ(below.notes.size(), 1u);
    EXPECT_TRUE(below.notes[0].ends_with("m.obj:1: a vertex colour below 0 is read as 0 (and 1 more time)")) << below.notes[0];
    const ObjFile above = loaded("", "v 0 0 0 300 0 0\nv 1 0 0 0 255 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(above.mesh.colors[0], vec3(1, 0, 0));
    ASSERT_EQ(above.notes.size(), 2u);
    EXPECT_TRUE(above.notes[0].ends_with("m.obj:1: a vertex colour above 255 is read as 255")) << above.notes[0];
}

// A roof of two squares that meet at a right angle along an edge, which the file lists twice.
TEST(SmoothingGroups, RoundAnEdgeOnlyWithinAGroup) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 1 0 -1\nv 1 1 -1\nv 1 1 0\n";
    const auto normalsAtEdge = [&](const std::string& faces) {
        const Mesh mesh = loaded("", corners + faces).mesh;
        std::set<std::array<float, 3>> normals;
        for (std::size_t i = 0; i < mesh.positionsMesh.size(); ++i)
            if (mesh.positionsMesh[i] == vec3(1, 0, 0)) normals.insert({mesh.normalsMesh[i].x, mesh.normalsMesh[i].y, mesh.normalsMesh[i].z});
        return normals;
    };
    const std::string one = "f 1 2 3 4\n", other = "f 5 6 7 8\n";
    constexpr float kHalf = 0.70710678f;
    EXPECT_EQ(normalsAtEdge(one + other).size(), 2u) << "no group: flat";
    const auto smooth = normalsAtEdge("s 1\n" + one + other);
    ASSERT_EQ(smooth.size(), 1u);
    EXPECT_NEAR((*smooth.begin())[0], kHalf, 1e-6);
    EXPECT_NEAR((*smooth.begin())[2], kHalf, 1e-6);
    EXPECT_EQ(normalsAtEdge("s 1\n" + one + "s 2\n" + other).size(), 2u);
    EXPECT_EQ(normalsAtEdge("s 1\n" + one + "s off\n" + other).size(), 2u);
    EXPECT_EQ(normalsAtEdge("s on\n" + one + other).size(), 1u);
    const ObjFile hexadecimal = loaded("", corners + "s 0x1\n" + one + "s -1\n" + other);
    ASSERT_EQ(hexadecimal.notes.size(), 1u);
    EXPECT_TRUE(hexadecimal.notes[0].ends_with("m.obj:9: s without a group's number (0 to 4294967295, on or off) is read as s off (and 1 more time)"))
        << hexadecimal.notes[0];
    EXPECT_EQ(normalsAtEdge("vn 0 0 1\ns 1\nf 1//1 2//1 3//1 4//1\n" + other).size(), 2u) << "a normal of the file stays";
}

TEST(MtlOptics, MirrorsGlassMetalAndRoughness) {
    const auto material = [](const std::string& mtl) { return loaded(mtl).materials[0]; };
    EXPECT_DOUBLE_EQ(material("Ks 0.9 0.9 0.9\nillum 3\n").reflectivity, dvec3(vec3(0.9f)).x);
    EXPECT_EQ(material("Ks 0.9 0.9 0.9\nillum 2\n").reflectivity, 0.0);
    EXPECT_EQ(material("Ks 0.9 0.9 0.9\nillum 1\n").specular, vec3(0.0f));
    const Material glass = material("Kd 0 0 0\nKs 1 1 1\nTf 0.9 0.9 0.9\nNi 1.5\nillum 7\n");
    EXPECT_DOUBLE_EQ(glass.transparency, 0.9);
    EXPECT_NEAR(glass.reflectivity, 0.04, 1e-12) << "((1.5 - 1) / (1.5 + 1))^2";
    EXPECT_EQ(material("illum 6\n").transparency, 1.0);
    EXPECT_EQ(material("d 0.25\nillum 6\n").transparency, 0.75);
    EXPECT_EQ(material("Tf 0.9 0.9 0.9\nillum 2\n").transparency, 0.0) << "without glass Tf says nothing";
    const Material metal = material("Kd 0.8 0.6 0.2\nPm 1\nPr 0.5\n");
    EXPECT_EQ(metal.diffuse, vec3(0.0f));
    EXPECT_EQ(metal.specular, vec3(0.8f, 0.6f, 0.2f));
    EXPECT_FLOAT_EQ(metal.shininess, 30.0f) << "2 / 0.5^4 - 2";
    EXPECT_FLOAT_EQ(material("Pr 0.5\nNs 7\n").shininess, 7.0f);
}

TEST(MtlOptics, DWinsOverTrInEitherOrderAndTrAloneIsSaid) {
    EXPECT_EQ(loaded("d 1\nTr 1\n").materials[0].transparency, 0.0);
    EXPECT_EQ(loaded("Tr 1\nd 1\n").materials[0].transparency, 0.0);
    const ObjFile alone = loaded("Tr 1\n");
    EXPECT_EQ(alone.materials[0].transparency, 1.0);
    ASSERT_EQ(alone.notes.size(), 1u);
    EXPECT_NE(alone.notes[0].find("m.mtl:2: Tr 1 makes material 'm' wholly transparent"), std::string::npos) << alone.notes[0];
}

} // namespace
} // namespace shadowlab::scene
