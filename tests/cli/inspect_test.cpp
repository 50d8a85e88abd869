// `inspect`: the numbers of small meshes that can be counted by hand, and a scene.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "techniques/registry.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::json;

constexpr const char* kBoxVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
constexpr const char* kFiveFaces = "f 5 6 7 8\nf 1 5 8 4\nf 2 3 7 6\nf 1 2 6 5\nf 4 8 7 3\n";
constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr const char* kSheet = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n";

struct Counts {
    int triangles = 0, degenerate = 0, duplicate = 0, vertices = 0, welded = 0, edges = 0, boundary = 0, multiple = 0,
        inconsistent = 0, components = 0;
    bool closed = false;
};

struct MeshCase {
    std::string name; ///< of the test
    std::string obj;
    Counts counts;
};

void PrintTo(const MeshCase& mesh, std::ostream* stream) { *stream << mesh.name; }

class InspectTest : public CommandTest {
protected:
    Json inspected(const std::string& file) const {
        const ProgramResult result = succeed({"inspect", file, "--json"});
        EXPECT_EQ(result.err, "");
        const Json json = Json::parse(result.out);
        EXPECT_TRUE(json.is_object());
        return json;
    }
    Json mesh(const std::string& obj) const {
        folder.write("mesh.obj", obj);
        return inspected("mesh.obj").at("meshes").at(0);
    }
    static std::string remark(const Json& json, const std::string& technique, const std::string& mesh) {
        for (const Json& entry : json.at("remarks"))
            if (entry.at("technique") == technique && entry.at("mesh") == mesh) return entry.at("remark");
        return {};
    }
};

class InspectMesh : public InspectTest, public ::testing::WithParamInterface<MeshCase> {};

TEST_P(InspectMesh, Counts) {
    const Counts& expected = GetParam().counts;
    const Json counted = mesh(GetParam().obj);
    EXPECT_EQ(counted.at("triangles"), expected.triangles);
    EXPECT_EQ(counted.at("degenerateTriangles"), expected.degenerate);
    EXPECT_EQ(counted.at("duplicateTriangles"), expected.duplicate);
    EXPECT_EQ(counted.at("vertices"), expected.vertices);
    EXPECT_EQ(counted.at("weldedVertices"), expected.welded);
    EXPECT_EQ(counted.at("edges"), expected.edges);
    EXPECT_EQ(counted.at("boundaryEdges"), expected.boundary);
    EXPECT_EQ(counted.at("multipleEdges"), expected.multiple);
    EXPECT_EQ(counted.at("inconsistentEdges"), expected.inconsistent);
    EXPECT_EQ(counted.at("components"), expected.components);
    EXPECT_EQ(counted.at("closed"), expected.closed);
}

const std::vector<MeshCase> kMeshes = {
    {"ClosedBox",
     std::string(kBoxVertices) + kFiveFaces + "f 1 4 3 2\n",
     {.triangles = 12, .vertices = 24, .welded = 8, .edges = 18, .components = 1, .closed = true}},
    {"BoxWithoutAFace",
     std::string(kBoxVertices) + kFiveFaces,
     {.triangles = 10, .vertices = 20, .welded = 8, .edges = 17, .boundary = 4, .components = 1}},
    {"FlippedFace", // its four sides disagree with their neighbours, its diagonal does not
     std::string(kBoxVertices) + kFiveFaces + "f 1 2 3 4\n",
     {.triangles = 12, .vertices = 24, .welded = 8, .edges = 18, .inconsistent = 4, .components = 1}},
    {"OpenSheet", kSheet, {.triangles = 2, .vertices = 4, .welded = 4, .edges = 5, .boundary = 4, .components = 1}},
    {"ThreeSheetsOnOneEdge",
     "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 1\nv -1 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
     {.triangles = 3, .vertices = 9, .welded = 5, .edges = 7, .boundary = 6, .multiple = 1, .components = 1}},
    {"DuplicateFaceInAnotherOrder",
     std::string(kTetrahedron) + "f 3 4 2\n",
     {.triangles = 5, .duplicate = 1, .vertices = 12, .welded = 4, .edges = 6, .multiple = 3, .components = 1}},
    {"DuplicateFaceTurnedOver",
     std::string(kTetrahedron) + "f 4 3 2\n",
     {.triangles = 5, .duplicate = 1, .vertices = 15, .welded = 4, .edges = 6, .multiple = 3, .components = 1}},
    {"DuplicateOfOtherVertices", // the same places, written once more
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 5 6 4\nf 6 5 4\n",
     {.triangles = 3, .duplicate = 2, .vertices = 6, .welded = 3, .edges = 3, .multiple = 3, .components = 1}},
    {"TwoComponentsThatTouchInAPoint",
     std::string(kTetrahedron) + "v -1 0 0\nv 0 -1 0\nv 0 0 -1\nf 1 6 5\nf 1 5 7\nf 1 7 6\nf 5 6 7\n",
     {.triangles = 8, .vertices = 21, .welded = 7, .edges = 12, .components = 2, .closed = true}},
    {"DegenerateFaces", // a point, a line there and back, three points in a row
     std::string(kSheet) + "v 1 0 0\nf 1 1 1\nf 1 2 1\nf 1 5 2\n",
     {.triangles = 2, .degenerate = 3, .vertices = 4, .welded = 4, .edges = 5, .boundary = 4, .components = 1}},
};
INSTANTIATE_TEST_SUITE_P(All, InspectMesh, ::testing::ValuesIn(kMeshes),
                         [](const auto& param) { return param.param.name; });

TEST_F(InspectTest, AMeshIsNotStaged) {
    folder.write("SHEET.OBJ", kSheet);
    const Json json = inspected("SHEET.OBJ");
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"coinciding", "emitters", "file", "kind", "materialLooks", "materials", "meshes",
                                              "name", "notes", "remarks", "scene", "triangles"}));
    EXPECT_EQ(json["file"], "SHEET.OBJ");
    EXPECT_EQ(json["kind"], "mesh");
    EXPECT_EQ(json["name"], "SHEET");
    EXPECT_EQ(json["triangles"], 2);
    EXPECT_TRUE(json["scene"].is_null());
    EXPECT_EQ(json["meshes"].size(), 1u);
    EXPECT_EQ(json["meshes"][0]["sizeMetres"], Json({2.0, 1.0, 0.0}));
    EXPECT_EQ(json["meshes"][0]["originOffset"], Json({0.0, 0.0, 0.0}));
    EXPECT_EQ(json["meshes"][0]["scale"], "ordinary");
}

TEST_F(InspectTest, ScaleAndOrigin) {
    const auto sheetAt = [&](const std::string& from, const std::string& to) {
        return mesh("v " + from + " 0 0\nv " + to + " 0 0\nv " + from + " 0 0.0001\nf 1 2 3\n");
    };
    EXPECT_EQ(sheetAt("0", "0.0009")["scale"], "tiny");
    EXPECT_EQ(sheetAt("0", "0.0011")["scale"], "ordinary");
    EXPECT_EQ(sheetAt("0", "9999")["scale"], "ordinary");
    EXPECT_EQ(sheetAt("0", "10001")["scale"], "huge");
    EXPECT_NE(succeed({"inspect", "mesh.obj"}).out.find("larger than ten kilometres"), std::string::npos);
    EXPECT_NE(sheetAt("1000000", "1000001")["originOffset"][0], 0.0);
    EXPECT_NE(succeed({"inspect", "mesh.obj"}).out.find("far from its origin"), std::string::npos);
    // In a scene it is the object's size that counts.
    folder.write("small.obj", "v 0 0 0\nv 0.0005 0 0\nv 0 0.0005 0\nf 1 2 3\n");
    folder.write(
        "scene.json",
        sceneText(kCamera, kTwoLights, R"("objects": [{"mesh": "small.obj"}, {"mesh": "small.obj", "scale": 1000}])"));
    const Json json = inspected("scene.json");
    EXPECT_EQ(json["meshes"][0]["scale"], "ordinary");
    EXPECT_DOUBLE_EQ(json["meshes"][0]["largestInWorld"], 1000.0 * static_cast<double>(0.0005f));
}

TEST_F(InspectTest, StepsPiecesAndOutliers) {
    const Json home = mesh(kSheet);
    EXPECT_EQ(home["stepMetres"], std::ldexp(1.0, -22)); // of numbers from 2 on
    EXPECT_EQ(home["shortestEdge"], 1.0);
    EXPECT_EQ(home["origins"], Json({{0.0, 0.0, 0.0}}));
    EXPECT_EQ(home["outlierCount"], 0);

    // A grid of posts in the coordinates of a country, and a triangle left over at zero.
    std::string text;
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 4; ++k)
            text += "v " + std::to_string(500000.0 + 2 * (i % 4) + (k == 1 ? 0.15 : 0)) + " " + (k == 2 ? "1" : "0") + " " +
                    std::to_string(5400000.0 + 2 * (i / 4) + (k == 3 ? 0.15 : 0)) + "\n";
    text += "\nv 0 0 0\nv 1 0 0\nv 0 0 1\n";
    for (int i = 0; i < 16; ++i) {
        const auto corner = [&](int k) { return " " + std::to_string(4 * i + k); };
        text += "f" + corner(1) + corner(2) + corner(3) + "\nf" + corner(1) + corner(3) + corner(4) + "\n";
    }
    const Json wide = mesh(text + "f 65 67 66\n");
    EXPECT_EQ(wide["triangles"], 33);
    EXPECT_EQ(wide["components"], 17);
    EXPECT_EQ(wide["origins"].size(), 2u);
    EXPECT_LT(wide["stepMetres"].get<double>(), 1e-6);
    EXPECT_NEAR(wide["shortestEdge"].get<double>(), 0.15, 1e-6);
    EXPECT_EQ(wide["outlierCount"], 3);
    EXPECT_EQ(wide["outliers"][0]["vertex"], 65);
    EXPECT_EQ(wide["outliers"][0]["line"], 66);
    EXPECT_NEAR(wide["outliers"][0]["distance"].get<double>(), 5.4e6, 10);
    EXPECT_NEAR(wide["sizeWithoutOutliers"][0].get<double>(), 6.15, 1e-5);
    EXPECT_EQ(wide["scale"], "ordinary");
    EXPECT_EQ(wide["objects"].size(), 1u);
    const std::string out = succeed({"inspect", "mesh.obj"}).out;
    for (const char* part : {"in 2 pieces", "v at line 66 (number 65) lies 5.4e+06 m from where most are", "measures 6.15 x 1 x 6.15 m"})
        EXPECT_NE(out.find(part), std::string::npos) << part << " in " << out;

    folder.write("scene.json", sceneText(kCamera, kTwoLights, R"("objects": [{"mesh": "mesh.obj", "translate": [-500000, 0, -5400000]}])"));
    const Json scene = inspected("scene.json");
    EXPECT_EQ(scene["scene"]["objects"], 1);
    EXPECT_EQ(scene["triangles"], 33);
    EXPECT_EQ(scene["meshes"].size(), 1u);
    EXPECT_EQ(scene["meshes"][0]["objects"].size(), 1u);

    // A strip of quads of 20 cm and 20 km hangs together.
    std::string strip;
    for (int x = 0; x <= 20000; ++x) {
        strip += "v " + std::to_string(x) + " 0 0\nv " + std::to_string(x) + " 0 0.2\n";
        if (x > 0) strip += "f -4 -3 -1 -2\n";
    }
    const Json road = mesh(strip);
    EXPECT_EQ(road["origins"].size(), 1u);
    EXPECT_EQ(road["stepMetres"], std::ldexp(1.0, -10)); // 10 km from the middle
    EXPECT_NE(succeed({"inspect", "mesh.obj"}).out.find("hangs together and cannot be kept in pieces"), std::string::npos);
}

TEST_F(InspectTest, ASceneWithAllItsParts) {
    folder.write("sheet.obj", std::string(kSheet) + "f 1 2 1\n");
    folder.write("all.json", R"({"camera": {"position": [3, 2, 4], "target": [0, 0, 0]},
  "lights": [{"type": "point", "position": [2, 5, 3]}, {"type": "point", "position": [1, 5, 3]},
             {"type": "rect", "position": [0, 4, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1]}],
  "materials": {"red": {"diffuse": [1, 0, 0]}, "sign": {"emission": [1, 0, 0]}, "tube": {"emission": [1, 1, 1], "emits": "both"}},
  "objects": [{"name": "one", "shape": "box", "size": [1, 1, 1]},
              {"name": "two", "shape": "box", "size": [1, 1, 1], "material": "red", "castsShadow": false},
              {"mesh": "sheet.obj", "receivesShadow": false}]})");
    const Json json = inspected("all.json");
    EXPECT_EQ(json["kind"], "scene");
    EXPECT_EQ(json["name"], "all");
    EXPECT_EQ(json["triangles"], 12 + 12 + 2);
    EXPECT_EQ(json["scene"]["objects"], 3);
    EXPECT_EQ(json["scene"]["cameras"], 1);
    EXPECT_EQ(json["scene"]["lights"],
              Json({{"point", 2}, {"directional", 0}, {"spot", 0}, {"rect", 1}, {"sphere", 0}}));
    EXPECT_EQ(json["scene"]["castNoShadow"], Json({"two"}));
    EXPECT_EQ(json["scene"]["receiveNoShadow"], Json({"sheet"}));
    EXPECT_EQ(json["materials"][0], "white");
    EXPECT_EQ(json["materials"][1], "red");
    EXPECT_EQ(json["emitters"],
              Json::parse(R"([{"material": "sign", "emits": "front"}, {"material": "tube", "emits": "both"}])"))
        << "the surface of the rect light is not one of the scene's own";
    ASSERT_EQ(json["meshes"].size(), 2u);
    EXPECT_EQ(json["meshes"][0]["objects"], Json({"one", "two"}));
    EXPECT_EQ(json["meshes"][0]["triangles"], 12);
    EXPECT_EQ(json["meshes"][1]["degenerateTriangles"], 1);
    ASSERT_EQ(json["notes"].size(), 1u);
    EXPECT_NE(json["notes"][0].get<std::string>().find("dropped 1 degenerate triangle"), std::string::npos);
    EXPECT_NE(remark(json, "shadow-volume-zfail", "one").find("closed"), std::string::npos);
    EXPECT_NE(remark(json, "shadow-volume-zfail", "sheet").find("4 boundary"), std::string::npos);

    const std::string text = succeed({"inspect", "all.json"}).out;
    for (const char* part : {"all.json: a scene\n", "objects            3\n", "triangles          26\n",
                             "lights             2 point, 1 rect\n", "cast no shadow     two\n",
                             "emitters           sign (front), tube (both)\n", "receive no shadow  sheet\n",
                             "[sheet]\n", "note: ", "What that means\n"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(InspectTest, WhoHonoursHolesAndWhoDoesNot) {
    const auto honours = [](const std::string& sentence) {
        return sentence.find("alpha map cuts") != std::string::npos;
    };
    const auto castsAsSolid = [](const std::string& sentence) {
        return sentence.find("holes cut by its alpha map are cast as solid") != std::string::npos;
    };
    const std::string screen = SHADOWLAB_SOURCE_DIR "/assets/models/screen.obj";
    for (const auto& [file, name] : {std::pair(std::string("lattice"), "screen"), std::pair(screen, "screen")}) {
        const Json json = inspected(file);
        int perforated = 0;
        for (const Json& mesh : json["meshes"])
            perforated += mesh["holes"] == true && mesh["name"] == name;
        EXPECT_EQ(perforated, 1) << file;
        for (const char* technique : {"planar", "shadow-map", "ray-traced"})
            EXPECT_TRUE(honours(remark(json, technique, name))) << file << ", " << technique;
        for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"})
            EXPECT_TRUE(castsAsSolid(remark(json, technique, name))) << file << ", " << technique;
    }
    const Json json = inspected("lattice");
    for (const Json& mesh : json["meshes"])
        EXPECT_EQ(mesh["holes"], mesh["name"] == "screen") << mesh["name"];
    EXPECT_FALSE(honours(remark(json, "shadow-map", "ball")));
    EXPECT_FALSE(castsAsSolid(remark(json, "shadow-volume", "ball")));
}

TEST_F(InspectTest, TheTableOfAMesh) {
    folder.write("sheet.obj", kSheet);
    const ProgramResult result = succeed({"inspect", "sheet.obj"});
    EXPECT_EQ(result.err, "");
    for (const char* part : {"sheet.obj: a mesh\n", "\ntriangles        2\n", "\n  boundary       4  of one face",
                             "\nclosed          no  ", "\nsize: 2 x 1 x 0 m\n",
                             "\nTo see these edges: shadowlab capture sheet.obj --stage mesh-edges -o edges.png\n"})
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const bool says = !technique.info->make()->remark({}, {}).empty();
        EXPECT_EQ(result.out.find("\n" + std::string(technique.info->id) + " ") != std::string::npos, says);
    }
}

TEST_F(InspectTest, EdgesAreShownOnlyWhereThereAreSome) {
    folder.write("closed.obj", kTetrahedron);
    EXPECT_EQ(succeed({"inspect", "closed.obj"}).out.find("mesh-edges"), std::string::npos);
    folder.write("sheet.obj", kSheet);
    succeed({"capture", "sheet.obj", "--stage", "mesh-edges", "-o", "edges.png", "--size", "64x48"}); // as it says
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "edges.png"));
    succeed({"capture", "sheet.obj", "--stage", "mesh-edges", "-t", "shadow-map,ray-traced", "--layout", "split", "-o",
             "both.png", "--size", "64x48"});
}

TEST_F(InspectTest, NeedsNoGraphics) {
    const ProgramSetting none{.environment = {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"DISPLAY", ""}}};
    const ProgramResult result = run({"inspect", "still-life"}, none);
    EXPECT_EQ(result.status, 0) << result.shown();
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, succeed({"inspect", "still-life"}).out);
    for (const char* scene : {"colonnade", "three-lights", "room-with-lamps"})
        EXPECT_GT(inspected(scene)["meshes"].size(), 0u);
}

TEST_F(InspectTest, NamesThatAreNoText) {
    const std::string name = "a\nb\xff.obj";
    folder.write(name, kSheet);
    const std::string text = succeed({"inspect", name}).out;
    EXPECT_EQ(text.substr(0, text.find('\n')), "a\\x0ab\\xff.obj: a mesh");
    EXPECT_EQ(inspected(name)["meshes"].size(), 1u);
}

TEST_F(InspectTest, Errors) {
    folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    folder.write("bad.json", "{");
    folder.write("text.txt", "no mesh");
    expectRefused({"inspect"}, 2, {"FILE is missing", "shadowlab inspect"});
    expectRefused({"inspect", ""}, 2, {"FILE: an empty text"});
    expectRefused({"inspect", "box.json", "more"}, 2, {"'more' is one argument too many"});
    expectRefused({"inspect", "box.json", "--jsno"}, 2, {"no option '--jsno'", "\"--json\""});
    expectRefused({"inspcet", "box.json"}, 2, {"did you mean \"inspect\"?"});
    for (const std::string file : {"missing.obj", "missing.json", "text.txt", "still-lief"})
        expectRefused({"inspect", file, "--json"}, 3, {file});
    expectRefused({"inspect", "bad.obj"}, 3, {"bad.obj:2"});
    expectRefused({"inspect", "bad.json"}, 3, {"bad.json:1"});
    expectOneLine(shell("\"$SHADOWLAB\" inspect box.json >/dev/full"), 4, {"standard output"});
}

TEST_F(InspectTest, MeshesOfAllowedFolders) {
    folder.write("meshes/sheet.obj", kSheet);
    folder.write("scenes/scene.json",
                 sceneText(kCamera, kTwoLights, R"("objects": [{"mesh": "../meshes/sheet.obj"}])"));
    expectRefused({"inspect", "scenes/scene.json"}, 3, {"--allow DIR"});
    EXPECT_EQ(succeed({"inspect", "scenes/scene.json", "--allow", "meshes"}).err, "");
}

} // namespace
} // namespace shadowlab::testing
