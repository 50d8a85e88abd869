// `pack`: the folder loads from anywhere without --allow, and draws the same bytes as what it was packed from.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n";

class PackTest : public CommandTest {
protected:
    PackTest() {
        image::Image half(2, 1); // one half of it is a hole
        half.rgba = {255, 255, 255, 255, 255, 255, 255, 0};
        const std::vector<std::uint8_t> png = image::encodePng(half, {.opaque = false, .text = {}});
        const std::string mask(png.begin(), png.end());
        // Two meshes of one name, each with a library of one name, and images of one name, spread over folders.
        folder.write("scenes/mine.json", R"({
  // kept, as all that is written here
  "camera": {"position": [3, 2, 4], "target": [0.5, 0.5, 0]}, "ambient": [0.1, 0.1, 0.1],
  "lights": [{"type": "point", "position": [2, 5, 3], "intensity": 40}],
  "materials": {"leaf": {"diffuse": [0.2, 0.6, 0.2], "alphaMap": "leaf.png"}},
  "objects": [{"shape": "quad", "size": [6, 6], "material": "leaf"},
              {"mesh": "../models/a/thing.obj"}, {"mesh": "..\/models/b/thing.obj", "translate": [2, 0, 0]},
              {"mesh": "../models/a/thing.obj", "translate": [-2, 0, 0], "normals": "smooth"}]
})");
        folder.write("scenes/leaf.png", mask);
        for (const std::string name : {"a", "b"}) {
            folder.write("models/" + name + "/thing.obj",
                         "# mesh " + name + "\nmtllib ../shared mats/m " + name + ".mtl\n" + kTetrahedron +
                             "usemtl m\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 1/1 4/2 3/3\nf 2/1 3/2 4/3\n");
            folder.write("models/shared mats/m " + name + ".mtl",
                         "newmtl m\r\nKd 0.8 0.2 0." + std::string(name == "a" ? "1" : "9") +
                             "\r\nmap_d -clamp on ../images/leaf.png\r\nmap_Ks gone.png\r\n");
        }
        folder.write("models/images/leaf.png", mask);
    }

    /// The bytes of a picture of the scene; `arguments` after it.
    std::string picture(const std::string& scene, const Words& arguments) const {
        Words words{"capture", scene, "-o", "x.png", "--size", "96x64"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        succeed(words);
        return fileContent(folder.path() / "x.png");
    }

    void moveAway(const std::string& from, const std::string& to) const {
        std::filesystem::create_directories((folder.path() / to).parent_path());
        std::filesystem::rename(folder.path() / from, folder.path() / to);
    }
};

TEST_F(PackTest, DrawsTheSameBytesFromElsewhereWithoutAllow) {
    const Words techniques[] = {
        {"-t", "shadow-map"}, {"-t", "ray-traced"}, {"-t", "planar"}, {"-t", "shadow-volume"}, {"-t", "radiosity"}};
    std::vector<std::string> before;
    for (Words words : techniques) {
        words.insert(words.end(), {"--allow", "models"});
        before.push_back(picture("scenes/mine.json", words));
    }
    const ProgramResult result = succeed({"pack", "scenes/mine.json", "--allow", "models", "-o", "packed"});
    EXPECT_EQ(
        result.out,
        "Written: packed/mine.json and 7 files that it is made of\n"); // 2 meshes, each with library and image, and the scene's own image
    moveAway("packed", "far/away");
    std::filesystem::remove_all(folder.path() / "models");
    std::filesystem::remove_all(folder.path() / "scenes");
    for (std::size_t i = 0; i < std::size(techniques); ++i)
        EXPECT_EQ(picture("far/away/mine.json", techniques[i]), before[i]) << techniques[i][1];
    EXPECT_TRUE(
        scene::contains(fileContent(folder.path() / "far/away/mine.json"), "// kept, as all that is written here"));
    for (const auto& [name, content] : listing())
        if (name.starts_with("far/") && !name.ends_with(".png")) {
            EXPECT_FALSE(scene::contains(content, "../models")) << name;
        }
}

TEST_F(PackTest, ABareMeshIsPackedAsItIsStaged) {
    // Parts with a material of the file, and one without, which is clay.
    folder.write("models/a/part.obj",
                 std::string("mtllib part.mtl\n") + kTetrahedron + "f 1 3 2\nf 1 2 4\nusemtl red\nf 1 4 3\nf 2 3 4\n");
    folder.write("models/a/part.mtl", "newmtl red\nKd 0.8 0.1 0.1\n");
    const std::string before = picture("models/a/part.obj", {"-t", "ray-traced"});
    EXPECT_EQ(succeed({"pack", "models/a/part.obj", "-o", "packed/"}).err, "");
    std::filesystem::remove_all(folder.path() / "models");
    EXPECT_EQ(picture("packed/part.json", {"-t", "ray-traced"}), before);
}

TEST_F(PackTest, FilesAreFoundUnderTheSpellingsThatLoadingFinds) {
    folder.write("models/a/other.mtl", "newmtl m\nKd 0.8 0.2 0.1\nmap_d -clamp \\\n on \"..\\Images\\leaf.png\" # a comment\n");
    folder.write("models/a/thing.obj", std::string("mtllib OTHER.mtl\n") + kTetrahedron + "usemtl m\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\n");
    folder.write("models/s.json", R"({"camera": {"position": [3, 2, 4], "target": [0.5, 0.5, 0]}, "ambient": [0.5, 0.5, 0.5],
  "materials": {"leaf": {"alphaMap": "Images\\LEAF.png"}},
  "objects": [{"shape": "quad", "size": [6, 6], "material": "leaf"}, {"mesh": "a\\Thing%2Eobj"}]})");
    const std::string before = picture("models/s.json", {"-t", "ray-traced"});
    succeed({"pack", "models/s.json", "-o", "packed"});
    std::filesystem::remove_all(folder.path() / "models");
    EXPECT_EQ(picture("packed/s.json", {"-t", "ray-traced"}), before);
    for (const char* file : {"meshes/thing.obj", "meshes/other.mtl", "meshes/textures/leaf.png", "textures/leaf.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "packed" / file)) << file;
    EXPECT_TRUE(scene::contains(fileContent(folder.path() / "packed/meshes/other.mtl"), "map_d -clamp   on textures/leaf.png\n"));
}

TEST_F(PackTest, ABuiltInSceneNeedsNoAssets) {
    const std::string before = picture("still-life", {"-t", "shadow-map"});
    succeed({"pack", "still-life", "-o", "packed"});
    EXPECT_EQ(picture("packed/still-life.json", {"-t", "shadow-map"}), before);
    EXPECT_FALSE(scene::contains(fileContent(folder.path() / "packed/still-life.json"), "\"../"));
}

TEST_F(PackTest, WritesOverNothing) {
    folder.write("there/inner.txt", "mine");
    expectRefused({"pack", "box.json", "-o", "there"}, 4, {"there", "already"});
    expectRefused({"pack", "box.json", "-o", "box.json"}, 4, {"box.json", "already"});
    expectRefused({"pack", "box.json", "-o", "no/such/folder"}, 4, {"no/such/folder"});
}

TEST_F(PackTest, LeavesNothingBehindWhereItFails) {
    expectRefused({"pack", "box.json"}, 2, {"-o"});
    expectRefused({"pack", "none.json", "-o", "packed"}, 3, {"none.json"});
    expectRefused({"pack", "scenes/mine.json", "-o", "packed"}, 3, {"mine.json:7", "--allow"});
}

} // namespace
} // namespace shadowlab::testing
