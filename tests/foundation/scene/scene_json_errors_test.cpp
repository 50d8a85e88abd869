// What a scene file may not say. Every refusal names file, line and column, says why, and what to write instead.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

struct BadScene {
    const char* name;
    std::string text; ///< CAMERA stands for a good camera, on line 1
    std::string place;
    const char* phrase;
    ExitStatus status = ExitStatus::badInput;
};
void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

std::string expanded(std::string text) {
    const std::string camera = R"("camera": {"position": [0, 1, 5], "target": [0, 0, 0]})";
    if (const std::size_t at = text.find("CAMERA"); at != std::string::npos) text.replace(at, 6, camera);
    return text;
}

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedWithLineColumnAndReason) {
    const Error error = errorOf([] { (void)parseSceneJson(expanded(GetParam().text), "x.json", {}); });
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("x.json:" + GetParam().place + ": ")) << message;
    EXPECT_TRUE(contains(message, GetParam().phrase)) << message;
    EXPECT_TRUE(contains(message, "; ")) << "says what to do: " << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
    EXPECT_EQ(error.status(), GetParam().status) << message;
}

std::string nameOf(const testing::TestParamInfo<BadScene>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Syntax, BadScenes,
    testing::Values(BadScene{"Empty", "", "1:1", "holds no JSON value"},
                    BadScene{"OnlyComment", "// nothing\n", "2:1", "holds no JSON value"},
                    BadScene{"NotAnObject", "[1, 2]", "1:1", "the scene is an array of 2; it must be an object"},
                    BadScene{"TrailingComma", "{CAMERA,\n}", "2:1", "unexpected '}'"},
                    BadScene{"MissingColon", "{CAMERA,\n \"ambient\" [0,0,0]}", "2:12", "unexpected '['"},
                    BadScene{"CutOff", "{CAMERA,\n \"lights\": [", "2:13", "unexpected end of input"},
                    BadScene{"TextAfterTheEnd", "{CAMERA}\nmore", "2:1", "expected end of input"},
                    BadScene{"UnclosedComment", "{CAMERA}\n/* ...", "2:7", "missing closing '*/'"},
                    BadScene{"IllFormedUtf8", "{\"\xff\": 1}", "1:3", "ill-formed UTF-8"},
                    BadScene{"NulByte", std::string("{\0}", 3), "1:2", "binary data"},
                    BadScene{"NotANumber", "{CAMERA, \"exposure\":\n NaN}", "2:2", "invalid literal"},
                    BadScene{"NumberTooLarge", "{CAMERA, \"exposure\":\n 1e400}", "2:2", "1e400"},
                    BadScene{"DuplicateKey", "{CAMERA,\n \"exposure\": 1,\n \"exposure\": 2}", "3:2",
                             "\"exposure\" appears twice in one object, first at x.json:2:2"},
                    BadScene{"DuplicateMaterial", "{CAMERA, \"materials\": {\n\"a\": {},\n  \"a\": {}}}", "3:3",
                             "first at x.json:2:1"},
                    BadScene{"TooDeep", std::string(65, '['), "1:65", "nested deeper than 64", ExitStatus::overLimit},
                    BadScene{"VeryDeep", std::string(200000, '['), "1:65", "nested deeper", ExitStatus::overLimit},
                    BadScene{"LineCountedThroughCrLf", "{CAMERA,\r\n\r\n\"x\": 1}", "3:1", "unknown key"},
                    BadScene{"NulInAText", "{CAMERA, \"materials\":\n{\"a\\u0000b\": {}}}", "2:2", "NUL character"},
                    BadScene{"LineCountedThroughCr", "{CAMERA,\r\r\"x\": 1}", "3:1", "unknown key"},
                    BadScene{"ColumnsCountCharacters", "{CAMERA,\n/* \xc3\xa4\xc3\xb6 */ \"x\": 1}", "2:10",
                             "unknown key"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Camera, BadScenes,
    testing::Values(
        BadScene{"NoCamera", "{\n}", "1:1", "the scene has no \"camera\""},
        BadScene{"NoTarget", "{\"camera\":\n {\"position\": [0,0,1]}}", "2:2", "the camera has no \"target\""},
        BadScene{"Misspelt", "{\"camera\": {\n\"postion\": [0,0,1]}}", "2:1", "did you mean \"position\"?"},
        BadScene{"UnknownTopKey", "{CAMERA,\n \"ligths\": []}", "2:2", "did you mean \"lights\"?"},
        BadScene{"FovAsText", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"fovYDegrees\": \"45\"}}",
                 "2:16", "is the string \"45\"; it must be a number above 0 and below 180"},
        BadScene{"FovZero", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"fovYDegrees\": 0}}", "2:16",
                 "above 0 and below 180"},
        BadScene{"Fov180", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"fovYDegrees\": 180}}", "2:16",
                 "is 180"},
        BadScene{"NearZero", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"near\": 0}}", "2:9",
                 "above 0"},
        BadScene{"FarNotBeyondNear",
                 "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"near\": 2, \"far\": 2}}", "2:19",
                 "larger than near, which is 2"},
        BadScene{"FarNull", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"far\": null}}", "2:8",
                 "is null"},
        BadScene{"TargetIsPosition", "{\"camera\": {\"position\": [0,0,1],\n\"target\": [0,0,1]}}", "2:11",
                 "camera's own position"},
        BadScene{"UpAlongView", "{\"camera\": {\"position\": [0,9,0], \"target\": [0,0,0],\n\"up\": [0,2,0]}}", "2:7",
                 "parallel to the view"},
        BadScene{"DefaultUpAlongView", "{\"camera\":\n {\"position\": [0,9,0], \"target\": [0,0,0]}}", "2:2",
                 "choose another up"},
        BadScene{"UpZero", "{\"camera\": {\"position\": [0,0,1], \"target\": [0,0,0],\n\"up\": [0,0,0]}}", "2:7",
                 "has no length"},
        BadScene{"TwoCoordinates", "{\"camera\": {\"position\":\n [0,1], \"target\": [0,0,0]}}", "2:2",
                 "an array of 2; it must be an array of 3 numbers"},
        BadScene{"TextAmongCoordinates", "{\"camera\": {\"position\": [0,\n \"1\", 2], \"target\": [0,0,0]}}", "2:2",
                 "must be a number"},
        BadScene{"TooFarAway", "{\"camera\": {\"position\": [0,\n 1e16, 2], \"target\": [0,0,0]}}", "2:2", "1e+15"},
        BadScene{"ExposureZero", "{CAMERA,\n \"exposure\": 0}", "2:14", "above 0"},
        BadScene{"ExposureTooLarge", "{CAMERA,\n \"exposure\": 1e300}", "2:14",
                 "is 1e+300; it must be a number above 0 and at most 1e+15"},
        BadScene{"AmbientNegative", "{CAMERA,\n \"ambient\": [0,-1,0]}", "2:16", "from 0 to 1e+15"},
        BadScene{"BackgroundNumber", "{CAMERA,\n \"background\": 1}", "2:16", "an array of 3 numbers"}),
    nameOf);

#define LIGHT(keys) "{CAMERA, \"lights\": [\n{" keys "}]}"

INSTANTIATE_TEST_SUITE_P(
    Lights, BadScenes,
    testing::Values(
        BadScene{"NotAnArray", "{CAMERA,\n \"lights\": {}}", "2:12", "must be an array"},
        BadScene{"NotAnObject", "{CAMERA,\n \"lights\": [7]}", "2:13", "light 1 is 7; it must be an object"},
        BadScene{"NoType", LIGHT("\"position\": [0,1,0]"), "2:1", "light 1 has no \"type\""},
        BadScene{"UnknownType", LIGHT("\"type\": \"spott\""), "2:10", "did you mean \"spot\""},
        BadScene{"NoPosition", LIGHT("\"type\": \"point\""), "2:1", "has no \"position\""},
        BadScene{"NoDirection", LIGHT("\"type\": \"directional\""), "2:1", "has no \"direction\""},
        BadScene{"KeyOfAnotherType", LIGHT("\"type\": \"point\", \"position\": [0,1,0], \"radius\": 1"), "2:40",
                 "unknown key \"radius\" in light 1 (type point)"},
        BadScene{"DirectionZero", LIGHT("\"type\": \"directional\", \"direction\": [0,0,0]"), "2:38", "has no length"},
        BadScene{"ConeTooWide", LIGHT("\"type\": \"spot\", \"position\": [0,1,0], \"coneDegrees\": 180"), "2:54",
                 "below 180"},
        BadScene{"EdgeBeyondHalfTheCone",
                 LIGHT("\"type\": \"spot\", \"position\": [0,1,0], \"coneDegrees\": 40, \"edgeDegrees\": 21"), "2:73",
                 "from 0 to 20"},
        BadScene{"RadiusZero", LIGHT("\"type\": \"sphere\", \"position\": [0,1,0], \"radius\": 0"), "2:51",
                 "above 1e-15"},
        BadScene{"EdgesParallel", LIGHT("\"type\": \"rect\", \"position\": [0,1,0], \"edgeV\": [-2,0,0]"), "2:48",
                 "parallel to edgeU"},
        BadScene{"IntensityNegative", LIGHT("\"type\": \"point\", \"position\": [0,1,0], \"intensity\": -1"), "2:53",
                 "from 0 to 1e+15"},
        BadScene{"IntensityTooLarge", LIGHT("\"type\": \"point\", \"position\": [0,1,0], \"intensity\": 1e300"), "2:53",
                 "is 1e+300; it must be a number from 0 to 1e+15"},
        BadScene{"ColorNegative", LIGHT("\"type\": \"point\", \"position\": [0,1,0], \"color\": [1,1,-1]"), "2:54",
                 "from 0 to 1e+15"},
        BadScene{"NameEmpty", LIGHT("\"name\": \"\", \"type\": \"point\", \"position\": [0,1,0]"), "2:10", "is empty"},
        BadScene{"NameWithNewline", LIGHT("\"name\": \"a\\nb\", \"type\": \"point\", \"position\": [0,1,0]"), "2:10",
                 "control character"},
        BadScene{"TwoOfOneName",
                 "{CAMERA, \"lights\": [\n{\"name\": \"a\", \"type\": \"point\", \"position\": [0,1,0]},\n{\"name\": "
                 "\"a\", \"type\": \"point\", \"position\": [0,1,0]}]}",
                 "3:10", "two lights are named \"a\", the first at x.json:2:10"},
        BadScene{"NameTakenByAnUnnamedOne",
                 "{CAMERA, \"lights\": [\n{\"type\": \"point\", \"position\": [0,1,0]},\n{\"name\": \"light1\", "
                 "\"type\": \"point\", \"position\": [0,1,0]}]}",
                 "3:10", "the first at x.json:2:1"}),
    nameOf);

#define MATERIAL(keys) "{CAMERA, \"materials\": {\"a\": {\n" keys "}}}"

INSTANTIATE_TEST_SUITE_P(
    Materials, BadScenes,
    testing::Values(BadScene{"NotAnObject", "{CAMERA,\n \"materials\": []}", "2:15", "must be an object"},
                    BadScene{"UnknownKey", MATERIAL("\"difuse\": [1,1,1]"), "2:1", "did you mean \"diffuse\"?"},
                    BadScene{"DiffuseAboveOne", MATERIAL("\"diffuse\": [1,1.5,1]"), "2:15",
                             "\"diffuse\" of material 'a' is 1.5; it must be a number from 0 to 1"},
                    BadScene{"ShininessNegative", MATERIAL("\"shininess\": -1"), "2:14", "from 0 to"},
                    BadScene{"ReflectivityAboveOne", MATERIAL("\"reflectivity\": 2"), "2:17", "from 0 to 1"},
                    BadScene{"TransparencyNegative", MATERIAL("\"transparency\": -0.1"), "2:17", "from 0 to 1"},
                    BadScene{"IorZero", MATERIAL("\"ior\": 0"), "2:8", "from 0.1 to 10"},
                    BadScene{"PriorityNotWhole", MATERIAL("\"priority\": 1.5"), "2:13", "whole number"},
                    BadScene{"GlossTooWide", MATERIAL("\"glossDegrees\": 91"), "2:17", "from 0 to 90"},
                    BadScene{"EmissionNegative", MATERIAL("\"emission\": [0,0,-1]"), "2:18", "from 0 to 1e+15"},
                    BadScene{"EmitsFromNowhere", MATERIAL("\"emits\": \"back\""), "2:10",
                             R"("emits" of material 'a' is "back"; it must be "front" or "both")"},
                    BadScene{"AlphaMapMissing", MATERIAL("\"alphaMap\": \"none.png\""), "2:13", "No such file"},
                    BadScene{"AlphaMapOutside", MATERIAL("\"alphaMap\": \"/etc/passwd\""), "2:13", "--allow DIR"}),
    nameOf);

#define OBJECT(keys) "{CAMERA, \"objects\": [\n{" keys "}]}"

INSTANTIATE_TEST_SUITE_P(
    Objects, BadScenes,
    testing::Values(
        BadScene{"Neither", OBJECT("\"name\": \"a\""), "2:1", "neither \"mesh\" nor \"shape\""},
        BadScene{"Both", OBJECT("\"shape\": \"quad\", \"mesh\": \"a.obj\""), "2:27", "keep one of the two"},
        BadScene{"UnknownShape", OBJECT("\"shape\": \"spher\""), "2:11", "did you mean \"sphere\"?"},
        BadScene{"MisspeltShape", OBJECT("\"shpae\": \"quad\""), "2:2", "did you mean \"shape\"?"},
        BadScene{"NoSize", OBJECT("\"shape\": \"quad\""), "2:1", "object 1 (a quad) has no \"size\""},
        BadScene{"NoRadius", OBJECT("\"shape\": \"sphere\""), "2:1", "has no \"radius\""},
        BadScene{"NoRadii", OBJECT("\"shape\": \"torus\""), "2:1", "has no \"radii\""},
        BadScene{"KeyOfAnotherShape", OBJECT("\"shape\": \"box\", \"radius\": 1"), "2:18",
                 "unknown key \"radius\" in object 1 (a box)"},
        BadScene{"SizeOfAMesh", OBJECT("\"mesh\": \"a.obj\", \"size\": [1,1]"), "2:19",
                 "unknown key \"size\" in object 1 (a mesh)"},
        BadScene{"SizeNegative", OBJECT("\"shape\": \"quad\", \"size\": [1,-1]"), "2:30", "is -1"},
        BadScene{"SizeZero", OBJECT("\"shape\": \"box\", \"size\": [1,0,1]"), "2:29", "is 0"},
        BadScene{"BoxWithTwo", OBJECT("\"shape\": \"box\", \"size\": [1,1]"), "2:26", "array of 3 numbers"},
        BadScene{"SegmentsTooFew", OBJECT("\"shape\": \"sphere\", \"radius\": 1, \"segments\": 2"), "2:46",
                 "whole number from 3 to 4096"},
        BadScene{"SegmentsTooMany", OBJECT("\"shape\": \"sphere\", \"radius\": 1, \"segments\": 5000"), "2:46",
                 "from 3 to 4096"},
        BadScene{"SegmentsNotWhole", OBJECT("\"shape\": \"torus\", \"radii\": [1,0.3], \"segments\": [8,4.5]"), "2:50",
                 "write whole numbers"},
        BadScene{"TorusCutsItself", OBJECT("\"shape\": \"torus\", \"radii\": [1,1]"), "2:29",
                 "minor radius must be smaller"},
        BadScene{"ScaleZero", OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"scale\": [1,0,1]"), "2:43",
                 "is 0 along y"},
        BadScene{"ScaleText", OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"scale\": \"2\""), "2:43",
                 "must be a number"},
        BadScene{"CastsShadowNumber", OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"castsShadow\": 1"), "2:49",
                 "must be true or false"},
        BadScene{"UnknownMaterial", OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"material\": \"whit\""), "2:46",
                 "did you mean \"white\"?"},
        BadScene{"UnknownNormals", OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"normals\": \"smoth\""), "2:45",
                 "did you mean \"smooth\"?"},
        BadScene{"BeyondTheLimit",
                 OBJECT("\"shape\": \"quad\", \"size\": [1,1], \"scale\": 1e10, \"translate\": [1e15,0,0]"), "2:1",
                 "reaches beyond"},
        BadScene{"MeshMissing", OBJECT("\"mesh\": \"none.obj\""), "2:10", "No such file or directory"},
        BadScene{"MeshOutside", OBJECT("\"mesh\": \"/etc/passwd\""), "2:10", "--allow DIR"},
        BadScene{"MeshAbove", OBJECT("\"mesh\": \"../../../../../../etc/passwd\""), "2:10", "outside the folders"},
        BadScene{"MeshOwnFolder", OBJECT("\"mesh\": \".\""), "2:10", "\".\" is a folder; name a file in it"},
        BadScene{"MeshEmpty", OBJECT("\"mesh\": \"\""), "2:10", "is empty"},
        BadScene{"MeshNumber", OBJECT("\"mesh\": 7"), "2:10", "must be a string"}),
    nameOf);

TEST(SceneJsonErrors, MeshesOutsideTheSceneFolderNeedLeave) {
    const TempFolder folder;
    folder.write("models/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto file = folder.write("scenes/s.json", "");
    std::filesystem::create_symlink(folder.path() / "models", folder.path() / "scenes/link");
    const std::string camera = R"({"camera": {"position": [0,1,5], "target": [0,0,0]}, "objects": [{"mesh": ")";
    for (const std::string& mesh : {std::string("../models/t.obj"), std::string("link/t.obj")}) {
        const std::string text = camera + mesh + "\"}]}";
        EXPECT_TRUE(contains(errorOf([&] { (void)parseSceneJson(text, file, {}); }).what(), "--allow DIR")) << mesh;
        LoadOptions options;
        options.allowed = {folder.path() / "models"};
        EXPECT_EQ(parseSceneJson(text, file, options)->objects.size(), 1u);
        options = {};
        options.assetsRoot = folder.path();
        EXPECT_EQ(parseSceneJson(text, file, options)->objects.size(), 1u);
    }
}

TEST(SceneJsonErrors, FaultsInsideAMeshNameTheMeshFileAndItsLine) {
    const TempFolder folder;
    folder.write("bad.obj", "v 0 0 0\nv 1 0 z\n");
    const auto file = folder.write("s.json", "");
    const std::string message =
        errorOf([&] {
            (void)parseSceneJson(expanded("{CAMERA, \"objects\": [{\"mesh\": \"bad.obj\"}]}"), file, {});
        }).what();
    EXPECT_TRUE(message.starts_with((folder.path() / "bad.obj").string() + ":2: \"z\" is not a number")) << message;
}

TEST(SceneJsonErrors, AFifoAsMeshDoesNotHang) {
    const TempFolder folder;
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.obj").c_str(), 0600), 0);
    const auto file = folder.write("s.json", "");
    const std::string message =
        errorOf([&] {
            (void)parseSceneJson(expanded("{CAMERA, \"objects\": [{\"mesh\": \"pipe.obj\"}]}"), file, {});
        }).what();
    EXPECT_TRUE(contains(message, "is not a regular file")) << message;
}

TEST(SceneJsonErrors, CountsBeyondTheLimitsEndWithTheirOwnStatus) {
    LoadOptions options;
    options.limits.lights = 1;
    options.limits.objects = 1;
    const std::string light = R"({"type": "directional", "direction": [0,-1,0]})",
                      box = R"({"shape": "box", "size": [1,1,1]})";
    for (const std::string& list :
         {"\"lights\": [" + light + "," + light + "]", "\"objects\": [" + box + "," + box + "]"})
        EXPECT_EQ(
            errorOf([&] { (void)parseSceneJson(expanded("{CAMERA, " + list + "}"), "x.json", options); }).status(),
            ExitStatus::overLimit);

    options = {};
    options.limits.triangles = 30;
    const std::string boxes = "\"objects\": [" + box + "," + box + "," + "\n" + box + "]";
    const Error error = errorOf([&] { (void)parseSceneJson(expanded("{CAMERA, " + boxes + "}"), "x.json", options); });
    EXPECT_EQ(error.status(), ExitStatus::overLimit);
    EXPECT_TRUE(contains(error.what(), "x.json:2:1: object 3 (a box) brings the scene to 36 triangles"))
        << error.what();

    options = {};
    options.limits.memoryBytes = kBytesAtRest + 30 * kBytesPerTriangle;
    const Error memory = errorOf([&] { (void)parseSceneJson(expanded("{CAMERA, " + boxes + "}"), "x.json", options); });
    EXPECT_EQ(memory.status(), ExitStatus::overLimit);
    EXPECT_TRUE(contains(memory.what(), "x.json:2:1: object 3 (a box) brings the scene to 36 triangles, for which"))
        << memory.what();
    EXPECT_TRUE(contains(memory.what(), "--limit memory")) << memory.what();
}

} // namespace
} // namespace shadowlab::scene
