// `export` on the command line: a whole folder or none, every format, and refusals with their exit status.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

/// Enough to be taken for three.js.
constexpr const char* kModule = "import { Color } from './three.core.js';\nclass WebGLRenderer {}\nconst end = '</script>';\nexport { WebGLRenderer };\n";

class ExportTest : public CommandTest {
protected:
    [[nodiscard]] std::vector<std::string> filesIn(const std::string& name) const {
        std::vector<std::string> files;
        for (const auto& [file, text] : listing())
            if (file.starts_with(name + "/") && !text.empty()) files.push_back(file.substr(name.size() + 1));
        return files;
    }
    [[nodiscard]] std::string content(const std::string& file) const { return fileContent(folder.path() / file); }
};

TEST_F(ExportTest, WritesTheFilesOfEachFormat) {
    const std::vector<std::pair<std::string, Words>> expected{
        {"gltf", {"README.md", "calibration.glb", "scene.glb"}},
        {"three", {"README.md", "calibration.html", "scene.html"}},
        {"pov", {"README.md", "calibration.pov", "scene.pov"}},
        {"blender", {"README.md", "calibration.py", "scene.py"}}};
    for (const auto& [format, files] : expected) {
        const ProgramResult result = succeed({"export", "box.json", "-o", format, "--to", format});
        EXPECT_TRUE(scene::contains(result.out, "Written: " + format)) << result.out;
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(filesIn(format), files);
        EXPECT_TRUE(scene::contains(content(format + "/README.md"), "shadowlab export box.json -o " + format + " --to " + format + " --size 640x360\n"));
    }
    succeed({"export", "box.json", "-o", "mitsuba", "--to", "mitsuba"});
    EXPECT_EQ(filesIn("mitsuba").size(), 4u + 2 + 38); // README, two scenes, a script; two meshes, and the 38 of the board
}

TEST_F(ExportTest, AGltfFileOfItDrawsTheSameShadows) {
    succeed({"export", "box.json", "-o", "out", "--to", "gltf"});
    const auto shadows = [&](const std::string& scene) {
        succeed({"capture", scene, "-t", "ray-traced", "--stage", "visibility", "--light", "key", "--size", "96x64", "-o", "v.png"});
        return content("v.png");
    };
    const image::DecodedPng a = decoded(shadows("box.json")), b = decoded(shadows("out/scene.glb"));
    ASSERT_EQ(a.image.rgba.size(), b.image.rgba.size());
    std::size_t differ = 0, dark = 0;
    for (std::size_t i = 0; i < a.image.rgba.size(); i += image::kChannels) {
        differ += a.image.rgba[i] != b.image.rgba[i];
        dark += a.image.rgba[i] == 0;
    }
    EXPECT_EQ(differ, 0u);
    EXPECT_GE(dark, 300u);
}

TEST_F(ExportTest, TheReadmeTakesOptionsOfTheSceneAlong) {
    folder.write("views.json", R"({"camera": {"position": [0, 2, 6], "target": [0, 0, 0]}, "views": {"from above": {"position": [0, 9, 1], "target": [0, 0, 0]}},
        "lights": [{"name": "a lamp", "type": "point", "position": [2, 5, 3]}], "objects": [{"shape": "quad", "size": [2, 2]}]})");
    succeed({"export", "views.json", "--view", "from above", "-o", "out", "--to", "pov", "--size", "320x200"});
    const std::string readme = content("out/README.md");
    for (const char* part : {"export views.json --view 'from above'", "--light 'a lamp'", "+W320 +H200", "+Ovisibility-a-lamp.png\n", "| position | 0, 9, 1 |"})
        EXPECT_TRUE(scene::contains(readme, part)) << part;
}

TEST_F(ExportTest, TheJudgeLineOfTheReadmeRunsInItsFolder) {
    const auto judgeLine = [&](const std::string& file) {
        const std::string readme = content(file);
        const std::size_t from = readme.find("    shadowlab judge ");
        return from == std::string::npos ? "" : readme.substr(from, readme.find('\n', from) - from);
    };
    folder.write("in/scenes/box.json", content("box.json"));
    const std::string place = (std::filesystem::absolute(folder.path()) / "in").lexically_normal().string();
    succeed({"export", "in/scenes/../scenes/box.json", "-o", "out", "--to", "pov", "--allow", "in"});
    const std::string line = judgeLine("out/README.md");
    EXPECT_TRUE(scene::contains(line, "judge visibility-key.png " + place + "/scenes/box.json --allow " + place + " --light key ")) << line;
    succeed({"export", "still-life", "-o", "built-in", "--to", "pov"});
    EXPECT_TRUE(scene::contains(judgeLine("built-in/README.md"), "visibility-key.png still-life --light key ")) << "no file, but a name";
}

TEST_F(ExportTest, ThePageCarriesTheLibrary) {
    folder.write("three/three.module.js", kModule);
    folder.write("three/three.core.js", "export class Color {}\n");
    succeed({"export", "box.json", "-o", "out", "--to", "three", "--three-module", "three/three.module.js"});
    for (const char* file : {"out/scene.html", "out/calibration.html"}) {
        const std::string page = content(file);
        EXPECT_TRUE(scene::contains(page, "id=\"three-core\">export class Color {}"));
        EXPECT_TRUE(scene::contains(page, "class WebGLRenderer {}"));
        EXPECT_TRUE(scene::contains(page, "'<\\/script>'")) << "else the page would end there";
    }
}

TEST_F(ExportTest, RefusesWhatItCannotDoAndLeavesNothing) {
    folder.write("there/inner.txt", "mine");
    folder.write("no.js", "const nothing = 0;\n");
    folder.write("alone/three.module.js", kModule);
    expectRefused({"export", "box.json", "-o", "there", "--to", "pov"}, 4, {"there", "already"});
    expectRefused({"export", "box.json", "-o", "box.json", "--to", "gltf"}, 4, {"box.json", "already"});
    expectRefused({"export", "box.json", "-o", "no/such/folder", "--to", "blender"}, 4, {"no/such/folder"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "obj"}, 2, {"--to", "obj", "gltf"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "blendr"}, 2, {"blender"});
    expectRefused({"export", "box.json", "-o", "out"}, 2, {"--to"});
    expectRefused({"export", "box.json", "--to", "pov"}, 2, {"-o"});
    expectRefused({"export", "-o", "out", "--to", "pov"}, 2, {"SCENE"});
    expectRefused({"export", "none.json", "-o", "out", "--to", "pov"}, 3, {"none.json"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "pov", "--size", "12"}, 2, {"--size"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "pov", "--size", "99999x12"}, 6, {"--size", "picture-side"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "pov", "--size", "40x30"}, 3, {"40"}); // the board needs more pixels
    expectRefused({"export", "box.json", "-o", "out", "--to", "pov", "--three-module", "no.js"}, 2, {"--three-module", "--to three"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "three", "--three-module", "none.js"}, 3, {"none.js"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "three", "--three-module", "no.js"}, 3, {"no.js", "no module of three.js"});
    expectRefused({"export", "box.json", "-o", "out", "--to", "three", "--three-module", "alone/three.module.js"}, 3, {"three.core.js"});
    expectRefused({"export", "box.json", "--view", "top", "-o", "out", "--to", "pov"}, 2, {"top"});
}

} // namespace
} // namespace shadowlab::testing
