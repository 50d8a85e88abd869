// Meshes and nodes of glTF files, against corners known beforehand, and against the same mesh as an OBJ file.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/constants.hpp>

#include "tests/foundation/scene/gltf/gltf_file.h"

namespace shadowlab::scene {
namespace {

using Corners = std::vector<dvec3>;

/// Farthest apart of corners in the same places of two lists.
double apart(const Corners& a, const Corners& b) {
    if (a.size() != b.size() || a.empty()) return std::numeric_limits<double>::infinity();
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, glm::length(a[i] - b[i]));
    return most;
}

constexpr double kRounding = 1e-15; // of a few operations in double on numbers about 1

TEST(GltfGeometry, ATriangleIsThereWithAFlatNormal) {
    const GltfFile file = MadeGltf().parsed();
    ASSERT_EQ(file.objects.size(), 1u);
    EXPECT_EQ(cornersWorld(file.objects[0]), (Corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    for (const vec3& normal : file.objects[0].mesh->normalsMesh)
        EXPECT_EQ(normal, vec3(0, 0, 1));
    EXPECT_EQ(file.objects[0].partMaterials, std::vector<std::uint32_t>{GltfObject::kNoMaterial});
    EXPECT_EQ(joinedNotes(file.notes), "");
}

TEST(GltfGeometry, AGlbIsTheSameAsItsJson) {
    MadeGltf made;
    made.primitive()["attributes"]["NORMAL"] = made.add<float>({0, 0, 2, 0, 3, 4, 0, 0, 1}, 5126, "VEC3", 3);
    const GltfFile json = made.parsed(), binary = parseGltf(made.glb(), "made.glb", NormalMode::file, {});
    ASSERT_EQ(json.objects.size(), binary.objects.size());
    EXPECT_EQ(json.objects[0].mesh->positionsMesh, binary.objects[0].mesh->positionsMesh);
    EXPECT_EQ(json.objects[0].mesh->normalsMesh, binary.objects[0].mesh->normalsMesh);
    EXPECT_EQ(json.objects[0].mesh->normalsMesh.at(1), vec3(dvec3(0, 0.6, 0.8))) << "of length one";
}

TEST(GltfGeometry, NodesScaleThenTurnThenMoveAndFollowTheirParents) {
    MadeGltf made;
    const double half = std::sqrt(0.5);
    made.json["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}},
                          {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {3, 1, 1}}, {"translation", {0, 0, 5}}}};
    const GltfFile file = made.parsed();
    ASSERT_EQ(file.objects.size(), 1u);
    // (1,0,0) is scaled to (3,0,0), turned by 90 degrees about z to (0,3,0), moved to (0,3,5), doubled and moved to (10,6,10).
    EXPECT_LT(apart(cornersWorld(file.objects[0]), {{10, 0, 10}, {10, 6, 10}, {8, 0, 10}}), 16 * kRounding);
}

TEST(GltfGeometry, AMatrixIsColumnByColumn) {
    MadeGltf made;
    made.json["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)), (Corners{{7, 8, 9}, {7, 9, 9}, {6, 8, 9}}));
}

TEST(GltfGeometry, AMirroredNodeIsAMirroredObject) {
    MadeGltf made;
    made.json["nodes"][0]["scale"] = {-1, 1, 1};
    const GltfFile file = made.parsed();
    EXPECT_EQ(cornersWorld(file.objects.at(0)), (Corners{{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}}));
    EXPECT_LT(glm::determinant(dmat3(file.objects[0].worldFromNode)), 0);
}

TEST(GltfGeometry, NodesThatShowOneMeshShareIt) {
    MadeGltf made;
    made.json["nodes"][0]["name"] = "leaf";
    made.addNode({{"mesh", 0}, {"name", "leaf"}, {"translation", {1, 0, 0}}});
    made.addNode({{"mesh", 0}});
    const GltfFile file = made.parsed();
    ASSERT_EQ(file.objects.size(), 3u);
    EXPECT_EQ(file.objects[0].mesh, file.objects[1].mesh);
    EXPECT_EQ(file.objects[0].mesh, file.objects[2].mesh);
    EXPECT_EQ(file.objects[0].name, "leaf");
    EXPECT_EQ(file.objects[1].name, "leaf 2");
    EXPECT_EQ(file.objects[2].name, "node 2");
}

TEST(GltfGeometry, StripsAndFansAreTheirTriangles) {
    const std::vector<float> square{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    for (const int mode : {5, 6}) {
        MadeGltf made;
        made.primitive()["attributes"]["POSITION"] = made.add<float>(square, 5126, "VEC3", 4);
        made.primitive()["indices"] =
            mode == 5 ? made.add<std::uint8_t>({0, 1, 2, 3}, 5121, "SCALAR", 4) : made.add<std::uint8_t>({0, 1, 3, 2}, 5121, "SCALAR", 4);
        made.primitive()["mode"] = mode;
        const Mesh mesh = *made.parsed().objects.at(0).mesh;
        EXPECT_EQ(mesh.triangles.size(), 2u) << mode;
        EXPECT_EQ(areaVectorSum(mesh), dvec3(0, 0, 1)) << mode << ": all triangles face the same way";
    }
}

TEST(GltfGeometry, IndicesAreOfAnyUnsignedType) {
    const auto corners = [](auto indices, int type) {
        MadeGltf made;
        made.primitive()["indices"] = made.add(indices, type, "SCALAR", 3);
        return cornersWorld(made.parsed().objects.at(0));
    };
    const Corners expected{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(corners(std::vector<std::uint8_t>{2, 0, 1}, 5121), expected);
    EXPECT_EQ(corners(std::vector<std::uint16_t>{2, 0, 1}, 5123), expected);
    EXPECT_EQ(corners(std::vector<std::uint32_t>{2, 0, 1}, 5125), expected);
}

TEST(GltfGeometry, NumbersMayLieApartInOneView) {
    MadeGltf made; // position and normal of a vertex beside each other
    const int view = made.view(bytesOf<float>({9, 9, 9, 0, 0, 0, 0, 1, 0, 2, 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0}));
    made.json["bufferViews"][view]["byteStride"] = 24;
    made.json["accessors"].push_back({{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
    made.json["accessors"].push_back({{"bufferView", view}, {"byteOffset", 24}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
    made.json["bufferViews"][view]["byteLength"] = 84;
    made.primitive()["attributes"] = {{"POSITION", 1}, {"NORMAL", 2}};
    const GltfFile file = made.parsed();
    EXPECT_EQ(cornersWorld(file.objects.at(0)), (Corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
    EXPECT_EQ(file.objects[0].mesh->normalsMesh, (std::vector<vec3>{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}));
}

TEST(GltfGeometry, NormalizedAndPlainWholeNumbersArePositions) {
    MadeGltf made;
    made.primitive()["attributes"]["POSITION"] = made.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32768, 0}, 5122, "VEC3", 3, true);
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)), (Corners{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
    made.primitive()["attributes"]["POSITION"] = made.add<std::int8_t>({0, 0, 0, 100, 0, 0, 0, -5, 0}, 5120, "VEC3", 3);
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)), (Corners{{0, 0, 0}, {100, 0, 0}, {0, -5, 0}}));
}

TEST(GltfGeometry, SparseValuesReplaceThoseOfTheViewOrZeros) {
    MadeGltf made;
    const int indices = made.view(bytesOf<std::uint16_t>({1, 2})), values = made.view(bytesOf<float>({3, 0, 0, 0, 4, 0}));
    Json& accessor = made.json["accessors"][0];
    accessor["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", indices}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)), (Corners{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}));
    accessor.erase("bufferView");
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)), (Corners{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}));
}

TEST(GltfGeometry, ColoursOfVerticesAreLinear) {
    MadeGltf made;
    made.primitive()["attributes"]["COLOR_0"] =
        made.add<std::uint8_t>({255, 0, 51, 0, 0, 255, 0, 0, 0, 0, 255, 0}, 5121, "VEC4", 3, true);
    const GltfFile file = made.parsed();
    EXPECT_EQ(file.objects.at(0).mesh->colors, (std::vector<vec3>{{1, 0, vec3(dvec3(51 / 255.0)).x}, {0, 1, 0}, {0, 0, 1}}));
    ASSERT_EQ(file.objects[0].partMaterials.size(), 1u);
    EXPECT_EQ(file.materials.at(file.objects[0].partMaterials[0]).diffuse, vec3(1)) << "white: the colours are seen as they are";
    EXPECT_TRUE(contains(joinedNotes(file.notes), "alpha of a vertex's colour is left out (3 times")) << joinedNotes(file.notes);
}

TEST(GltfGeometry, TextureCoordinatesCountFromTheLowerEdge) {
    MadeGltf made;
    made.primitive()["attributes"]["TEXCOORD_0"] = made.add<float>({0, 0, 1, 0.25f, 0.5f, 1}, 5126, "VEC2", 3);
    made.material()["name"] = "m";
    EXPECT_EQ(made.parsed().objects.at(0).mesh->texcoords, (std::vector<vec2>{{0, 1}, {1, 0.75f}, {0.5f, 0}}));
}

TEST(GltfGeometry, EachPrimitiveIsAPartWithItsMaterial) {
    MadeGltf made;
    made.json["materials"] = {{{"name", "red"}}, {{"name", "red"}}};
    made.primitive()["material"] = 1;
    made.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", made.add<float>({0, 0, 1, 1, 0, 1, 0, 1, 1}, 5126, "VEC3", 3)}}}, {"material", 0}});
    const GltfFile file = made.parsed();
    ASSERT_EQ(file.objects.at(0).mesh->parts.size(), 2u);
    EXPECT_EQ(file.objects[0].partMaterials, (std::vector<std::uint32_t>{1, 0}));
    EXPECT_EQ(file.materials[0].name, "red");
    EXPECT_EQ(file.materials[1].name, "red 2") << "names are one's own, or a scene file could not tell them apart";
}

TEST(GltfGeometry, AMeshFarFromItsOriginKeepsItsDetail) {
    MadeGltf made; // 1e6 and a half: floats there are 1/16 apart
    made.primitive()["attributes"]["POSITION"] = made.add<float>({1e6f, 0, 0, 1e6f + 0.5f, 0, 0, 1e6f, 0.5f, 0}, 5126, "VEC3", 3);
    made.json["nodes"][0]["translation"] = {5.4e6, 0.03125, 0};
    const GltfFile file = made.parsed();
    EXPECT_NE(file.objects.at(0).mesh->originObject, dvec3(0));
    EXPECT_EQ(cornersWorld(file.objects[0]), (Corners{{6.4e6, 0.03125, 0}, {6.4e6 + 0.5, 0.03125, 0}, {6.4e6, 0.53125, 0}}));
}

TEST(GltfGeometry, TheSameMeshAsAnObjFileIsTheSameToTheBit) {
    MadeGltf made;
    made.primitive()["attributes"] = {{"POSITION", made.add<float>({0, 0, 0, 1.25f, 0, 0, 1, 1, 0.5f, 0, 1.5f, 0}, 5126, "VEC3", 4)},
                                      {"NORMAL", made.add<float>({0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1}, 5126, "VEC3", 4)},
                                      {"TEXCOORD_0", made.add<float>({0, 1, 1, 1, 1, 0, 0, 0.25f}, 5126, "VEC2", 4)}};
    made.primitive()["indices"] = made.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 6);
    made.material()["name"] = "m";
    const TempFolder folder;
    const ObjFile obj = loadObj(folder.write("m.obj", "v 0 0 0\nv 1.25 0 0\nv 1 1 0.5\nv 0 1.5 0\nvn 0 0 1\nvn 0 1 0\n"
                                                      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.75\nf 1/1/1 2/2/1 3/3/2\nf 1/1/1 3/3/2 4/4/1\n"),
                                NormalMode::file, {});
    const Mesh mesh = *made.parsed().objects.at(0).mesh;
    EXPECT_EQ(mesh.positionsMesh, obj.mesh.positionsMesh);
    EXPECT_EQ(mesh.normalsMesh, obj.mesh.normalsMesh);
    EXPECT_EQ(mesh.texcoords, obj.mesh.texcoords);
    EXPECT_EQ(mesh.triangles, obj.mesh.triangles);
    for (const NormalMode mode : {NormalMode::flat, NormalMode::smooth})
        EXPECT_EQ(made.parsed(mode).objects.at(0).mesh->normalsMesh, withNormals(obj.mesh, mode).normalsMesh);
}

TEST(GltfGeometry, WhatHasNoSurfaceIsNotedAndCounted) {
    MadeGltf made;
    Json& primitives = made.json["meshes"][0]["primitives"];
    for (const int mode : {0, 1, 2, 3})
        primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    primitives.push_back({{"attributes", Json::object()}});
    primitives[0]["attributes"]["COLOR_1"] = 0;
    primitives[0]["attributes"]["TEXCOORD_1"] = 0;
    primitives[0]["targets"] = {{{"POSITION", 0}}};
    made.json["nodes"][0]["skin"] = 0;
    made.json["skins"] = {{{"joints", {0}}}};
    made.json["animations"] = {Json::object()};
    made.addNode({{"mesh", 0}, {"scale", {1, 0, 1}}});
    const GltfFile file = made.parsed();
    EXPECT_EQ(file.objects.size(), 1u);
    const std::string notes = joinedNotes(file.notes);
    for (const char* expected :
         {"meshes[0]: points have no surface", "lines have no surface; they are left out (3 times in the file)",
          "a primitive has no POSITION", "morph targets are left out", "texture coordinates (TEXCOORD_1) are left out",
          "further colours or texture coordinates (COLOR_1) are left out", "skins are left out", "animations are left out",
          "nodes[1]: is flattened by its transform"})
        EXPECT_TRUE(contains(notes, expected)) << expected << " is not among\n" << notes;
    for (const std::string& note : file.notes)
        EXPECT_TRUE(note.starts_with("made.gltf:")) << note;
}

TEST(GltfGeometry, TheFilesSceneIsShownAndTheOthersAreNoted) {
    MadeGltf made;
    made.json["nodes"].push_back({{"mesh", 0}, {"name", "other"}});
    made.json["scenes"].push_back({{"nodes", {1}}});
    made.json["scene"] = 1;
    const GltfFile file = made.parsed();
    ASSERT_EQ(file.objects.size(), 1u);
    EXPECT_EQ(file.objects[0].name, "other");
    EXPECT_TRUE(contains(joinedNotes(file.notes), "scenes[0]: is left out; scenes[1] is shown")) << joinedNotes(file.notes);
    made.json.erase("scene");
    EXPECT_EQ(made.parsed().objects.at(0).name, "node 0");
    made.json.erase("scenes");
    EXPECT_EQ(made.parsed().objects.size(), 2u);
}

TEST(GltfGeometry, DeepHierarchiesAreNoTrouble) {
    MadeGltf made;
    constexpr int kDeep = 20000; // a recursion so deep would use up the stack
    made.json["nodes"] = Json::array();
    for (int i = 0; i < kDeep; ++i)
        made.json["nodes"].push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
    made.json["nodes"].push_back({{"mesh", 0}});
    EXPECT_EQ(cornersWorld(made.parsed().objects.at(0)).at(0), dvec3(kDeep, 0, 0));
}

} // namespace
} // namespace shadowlab::scene
