// glTF files on the command line: the same picture as the same scene in other files, views, `inspect`, `pack`.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"
#include "tests/foundation/scene/gltf/gltf_file.h"

namespace shadowlab::testing {
namespace {

using scene::Json;
using scene::MadeGltf;
using Words = std::vector<std::string>;

/// A tetrahedron on a floor, wound outward, with one normal for each face.
MadeGltf tetrahedron() {
    MadeGltf made;
    made.primitive()["attributes"]["POSITION"] = made.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 5126, "VEC3", 4);
    made.primitive()["indices"] = made.add<std::uint8_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 5121, "SCALAR", 12);
    return made;
}

class GltfCommandTest : public CommandTest {
protected:
    /// The bytes of a small picture.
    std::string picture(const Words& arguments) const {
        Words words{"capture", "-o", "x.png", "--size", "96x64", "-t", "shadow-map"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        succeed(words);
        const std::string bytes = fileContent(folder.path() / "x.png");
        EXPECT_EQ(headerOf(bytes).width, 96u);
        return bytes;
    }
};

TEST_F(GltfCommandTest, ABareFileIsDrawnAsTheSameObjFileIs) {
    folder.write("t.gltf", tetrahedron().text());
    folder.write("t.glb", tetrahedron().glb());
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::string obj = picture({"t.obj"});
    EXPECT_TRUE(picture({"t.gltf"}) == obj);
    EXPECT_TRUE(picture({"t.glb"}) == obj);
}

/// Lights, camera, materials and two nodes, as a glTF file and as a scene file.
TEST_F(GltfCommandTest, AWholeFileIsDrawnAsTheSameSceneFileIs) {
    MadeGltf made = tetrahedron();
    made.material()["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
    made.addNode({{"mesh", 0}, {"translation", {2, 0, 0}}, {"scale", {1, 2, 1}}});
    made.light({{"translation", {1, 4, 3}}}) = {{"type", "point"}, {"intensity", 40}};
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.5}}}}};
    made.addNode({{"camera", 0}, {"translation", {1, 0.5, 6}}});
    folder.write("m.gltf", made.text());
    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder.write("m.json", R"({"camera": {"position": [1, 0.5, 6], "target": [1, 0.5, 0], "fovYDegrees": 57.29577951308232, "near": 0.5},
        "ambient": [0.09, 0.09, 0.09], "background": [0.32, 0.33, 0.35],
        "lights": [{"type": "point", "position": [1, 4, 3], "intensity": 40}],
        "materials": {"m": {"diffuse": [0.5, 0.25, 0.125], "specular": [0.04, 0.04, 0.04], "shininess": 0}},
        "objects": [{"mesh": "m.obj", "material": "m"}, {"mesh": "m.obj", "material": "m", "translate": [2, 0, 0], "scale": [1, 2, 1]}]})");
    EXPECT_TRUE(picture({"m.gltf"}) == picture({"m.json"}));
}

TEST_F(GltfCommandTest, ViewsAreChosenByName) {
    MadeGltf made = tetrahedron();
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    made.addNode({{"camera", 0}, {"name", "near"}, {"translation", {0.3, 0.3, 4}}});
    made.addNode({{"camera", 0}, {"name", "far"}, {"translation", {0.3, 0.3, 9}}});
    folder.write("v.glb", made.glb());
    const std::string near = picture({"v.glb"});
    EXPECT_TRUE(picture({"v.glb", "--view", "near"}) == near) << "the first is the scene's";
    EXPECT_FALSE(picture({"v.glb", "--view", "far"}) == near);
    expectRefused({"capture", "v.glb", "--view", "fra", "-o", "y.png"}, 2, {"--view: \"fra\" is no view of v.glb", "far"});
    expectRefused({"measure", "box.json", "--view", "near"}, 2, {"it has none beside its own camera"});
}

TEST_F(GltfCommandTest, InspectListsWhatIsThereAndWhatIsNotShown) {
    MadeGltf made = tetrahedron();
    made.material()["name"] = "red";
    made.light({{"name", "lamp"}}) = {{"type", "point"}};
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    made.addNode({{"camera", 0}, {"name", "eye"}, {"translation", {0, 0, 4}}});
    made.json["animations"] = {Json::object()};
    folder.write("i.gltf", made.text());
    const Json json = Json::parse(succeed({"inspect", "i.gltf", "--json"}).out);
    EXPECT_EQ(json.at("kind"), "gltf");
    EXPECT_EQ(json.at("triangles"), 4);
    EXPECT_EQ(json.at("materials"), Json({"red"}));
    EXPECT_EQ(json.at("scene").at("nodes"), 3);
    EXPECT_EQ(json.at("scene").at("lights").at("point"), 1);
    EXPECT_EQ(json.at("scene").at("cameras"), 1);
    EXPECT_EQ(json.at("scene").at("views"), Json({"eye"}));
    EXPECT_EQ(json.at("meshes").at(0).at("closed"), true);
    EXPECT_EQ(json.at("notes").size(), 1u);
    const std::string text = succeed({"inspect", "i.gltf"}).out;
    for (const char* part : {"i.gltf: a glTF file", "1 point", "eye", "red", "animations are left out"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST_F(GltfCommandTest, PackedFilesDrawTheSame) {
    image::Image two(2, 1);
    two.rgba = {255, 0, 0, 255, 0, 255, 0, 255};
    const std::vector<std::uint8_t> png = image::encodePng(two, {});
    folder.write("in/tex/a b.png", {png.begin(), png.end()});
    MadeGltf made = tetrahedron();
    made.primitive()["attributes"]["TEXCOORD_0"] = made.add<float>({0, 0, 1, 0, 0, 1, 1, 1}, 5126, "VEC2", 4);
    made.material()["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    made.json["textures"] = {{{"source", 0}}};
    made.json["images"] = {{{"uri", "tex/a%20b.png"}}};
    made.addNode({{"mesh", 0}, {"translation", {2, 0, 0}}});
    folder.write("in/beside.bin", made.buffer);
    folder.write("in/g.glb", made.glb()); // its image is beside it
    made.json["buffers"] = {{{"byteLength", made.buffer.size()}, {"uri", "beside.bin"}}};
    folder.write("in/j.gltf", made.text());
    for (const std::string name : {"g.glb", "j.gltf"}) {
        const std::string before = picture({"in/" + name}), stem = name.substr(0, 1);
        succeed({"pack", "in/" + name, "-o", "packed-" + stem});
        EXPECT_TRUE(std::filesystem::exists(folder.path() / ("packed-" + stem) / "meshes/textures/a b.png")) << name;
        EXPECT_TRUE(picture({"packed-" + stem + "/" + stem + ".json"}) == before) << name;
    }
}

} // namespace
} // namespace shadowlab::testing
