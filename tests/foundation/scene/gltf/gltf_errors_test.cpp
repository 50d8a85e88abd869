// Bad glTF files: each is refused with one line that names the place and the way out.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <limits>

#include "tests/foundation/scene/gltf/gltf_file.h"

namespace shadowlab::scene {
namespace {

/// A file with one of everything that can be spoiled.
MadeGltf whole() {
    MadeGltf made;
    made.primitive()["attributes"]["NORMAL"] = made.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3", 3);
    made.primitive()["indices"] = made.add<std::uint16_t>({0, 1, 2}, 5123, "SCALAR", 3);
    made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 1};
    made.light()["type"] = "point";
    made.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    made.addNode({{"camera", 0}, {"translation", {0, 0, 5}}});
    return made;
}

Error refusal(const MadeGltf& made, const LoadOptions& options = {}) {
    return errorOf([&] { (void)made.parsed(NormalMode::file, options); });
}

void expectOneLine(const Error& error, ExitStatus status, const std::string& part) {
    const std::string message = error.what();
    EXPECT_EQ(error.status(), status) << message;
    EXPECT_TRUE(contains(message, part)) << part << " is not in\n" << message;
    EXPECT_TRUE(message.starts_with("made.gl")) << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
    EXPECT_TRUE(message.find("; ") != std::string::npos || message.find(": ", 10) != std::string::npos) << message << ": and what to do?";
}

TEST(GltfErrors, TheWholeFileIsTaken) {
    const GltfFile file = whole().parsed();
    EXPECT_EQ(file.objects.size(), 1u);
    EXPECT_EQ(file.lights.size(), 1u);
    EXPECT_EQ(file.viewpoints.size(), 1u);
    EXPECT_EQ(joinedNotes(file.notes), "");
}

TEST(GltfErrors, EachNamesItsPlace) {
    struct Case {
        std::string expected;
        std::function<void(MadeGltf&)> spoil;
    };
    const auto set = [](const char* pointer, const Json& value) {
        return [=](MadeGltf& made) { made.json[Json::json_pointer(pointer)] = value; };
    };
    const std::vector<Case> cases{
        {"glTF version \"1.0\", and only 2.0 is read", set("/asset/version", "1.0")},
        {"needs glTF version \"2.1\" (minVersion), and only 2.0 is read", set("/asset/minVersion", "2.1")},
        {"\"asset\" with its \"version\" is missing", set("/asset", Json::object())},
        {"extensionsRequired names \"KHR_draco_mesh_compression\"", set("/extensionsRequired", {"KHR_draco_mesh_compression"})},
        {"extensionsRequired names \"EXT_meshopt_compression\"",
         set("/extensionsRequired", {"KHR_texture_transform", "EXT_meshopt_compression"})},
        {"accessors is an object; it must be an array", set("/accessors", Json::object())},
        {"accessors[0] is a number; it must be an object", set("/accessors/0", 3)},
        {"accessors[0].count is a string; it must be a number", set("/accessors/0/count", "3")},
        {"accessors[0].count is 2.5; it must be a whole number from 1 on", set("/accessors/0/count", 2.5)},
        {"accessors[0].count is -3", set("/accessors/0/count", -3)},
        {"accessors[0].count is 0", set("/accessors/0/count", 0)},
        {"accessors[0].componentType is 5124; it must be one of", set("/accessors/0/componentType", 5124)},
        {"accessors[0].type is \"VEC9\"; it must be one of", set("/accessors/0/type", "VEC9")},
        {"accessors[0].bufferView is 9, but the file has 3 elements in \"bufferViews\"", set("/accessors/0/bufferView", 9)},
        {"accessors[0] has elements that reach beyond their buffer view: 4 elements of 12 bytes", set("/accessors/0/count", 4)},
        {"accessors[0] has elements that reach beyond", set("/accessors/0/byteOffset", 4)},
        {"accessors[0] has elements that reach beyond", set("/accessors/0/byteOffset", 9007199254740991)},
        {"accessors[0] has elements that reach beyond", set("/accessors/0/count", 9007199254740991)},
        {"accessors[0] has elements of 12 bytes, but they lie only 4 apart", set("/bufferViews/0/byteStride", 4)},
        {"bufferViews[0].byteStride is 3; it must be a whole number from 4 to 252", set("/bufferViews/0/byteStride", 3)},
        {"bufferViews[0].byteStride is 14; it must be a multiple of 4", set("/bufferViews/0/byteStride", 14)},
        {"bufferViews[0] reaches beyond its buffer", set("/bufferViews/0/byteLength", 9999)},
        {"bufferViews[2] reaches beyond its buffer", set("/bufferViews/2/byteOffset", 9007199254740991)},
        {"bufferViews[0].buffer is 1, but the file has 1 element in \"buffers\"", set("/bufferViews/0/buffer", 1)},
        {"buffers[0] is said to have 9999 bytes, but only 3 are there",
         set("/buffers", {{{"byteLength", 9999}, {"uri", "data:;base64,AAAA"}}})},
        {"buffers[0] has a data: URI that is not well-formed base64",
         set("/buffers", {{{"byteLength", 3}, {"uri", "data:application/octet-stream;base64,A!AA"}}})},
        {"buffers[0] has a data: URI that is not well-formed base64",
         set("/buffers", {{{"byteLength", 3}, {"uri", "data:text/plain,abc"}}})},
        {"buffers[0] has no uri, and the file has no binary chunk", set("/buffers", {{{"byteLength", 3}}})},
        {"buffers[0] names \"no such.bin\", which cannot be read: No such file",
         set("/buffers", {{{"byteLength", 3}, {"uri", "no such.bin"}}})},
        {"buffers[0] names \"https://x.org/a.bin\", which is an address",
         set("/buffers", {{{"byteLength", 3}, {"uri", "https://x.org/a.bin"}}})},
        {"buffers[0] names \"file:///etc/passwd\", which is an address",
         set("/buffers", {{{"byteLength", 3}, {"uri", "file:///etc/passwd"}}})},
        {"which lies outside the folders this scene may read",
         set("/buffers", {{{"byteLength", 3}, {"uri", "..%2f..%2f..%2f..%2fetc/passwd"}}})},
        {"meshes[0].primitives[0].attributes.POSITION is 99, but the file has 3 elements in \"accessors\"",
         set("/meshes/0/primitives/0/attributes/POSITION", 99)},
        {"meshes[0].primitives[0].material is -1, but the file has 1 element in \"materials\"",
         set("/meshes/0/primitives/0/material", -1)},
        {"meshes[0].primitives[0].mode is 7; it must be a whole number from 0 to 6", set("/meshes/0/primitives/0/mode", 7)},
        {"meshes[0].primitives[0] has no \"attributes\"", set("/meshes/0/primitives/0", Json::object())},
        {"has a NORMAL (accessors[1]) with fewer elements, 2, than the 3 positions", set("/accessors/1/count", 2)},
        {"has a NORMAL (accessors[2]) that is no VEC3", set("/meshes/0/primitives/0/attributes/NORMAL", 2)},
        {"has indices that are no unsigned whole numbers (accessors[0])", set("/meshes/0/primitives/0/indices", 0)},
        {"nodes[0].mesh is 4, but the file has 1 element in \"meshes\"", set("/nodes/0/mesh", 4)},
        {"nodes[0].rotation has 3 numbers; it must have 4", set("/nodes/0/rotation", {0, 0, 1})},
        {"nodes[0] has a rotation without a direction", set("/nodes/0/rotation", {0, 0, 0, 0})},
        {"nodes[0].matrix has 4 numbers; it must have 16", set("/nodes/0/matrix", {1, 0, 0, 1})},
        {"nodes[0] has a matrix whose last row is not 0 0 0 1", set("/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})},
        {"nodes[0] is its own ancestor", set("/nodes/0/children", {0})},
        {"nodes[1] is a child of nodes[0] and of nodes[2]",
         [](MadeGltf& made) {
             made.json["nodes"][0]["children"] = {1};
             made.json["nodes"][2]["children"] = {1};
         }},
        {"scenes[0] names nodes[1], which is a child of nodes[0]", set("/nodes/0/children", {1})},
        {"scenes[0] names nodes[0] twice", set("/scenes/0/nodes", {0, 0})},
        {"scene is 3, but the file has 1 element in \"scenes\"", set("/scene", 3)},
        {"nodes[0] reaches beyond 1e+15 m from the origin", set("/nodes/0/translation", {1e16, 0, 0})},
        {"where no numbers are left",
         [](MadeGltf& made) {
             made.json["nodes"][0]["scale"] = {1e200, 1, 1};
             made.addNode({{"scale", {1e200, 1, 1}}, {"children", {0}}});
             made.json["scenes"][0]["nodes"].erase(0);
         }},
        {"materials[0].alphaMode is \"SEE\"; it must be one of OPAQUE, MASK, BLEND", set("/materials/0/alphaMode", "SEE")},
        {"materials[0].pbrMetallicRoughness.baseColorFactor has 3 numbers; it must have 4",
         set("/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1})},
        {"materials[0].pbrMetallicRoughness.baseColorTexture.index is 0, but the file has no \"textures\"",
         set("/materials/0/pbrMetallicRoughness/baseColorTexture", {{"index", 0}})},
        {"cameras[0] has a yfov of 4 radians", set("/cameras/0/perspective/yfov", 4)},
        {"cameras[0] sees from znear 0 to zfar 0", set("/cameras/0/perspective/znear", 0)},
        {"cameras[0] is of type \"orthographic\" and has no \"orthographic\"", set("/cameras/0/type", "orthographic")},
        {"lights[0].type is \"sun\"; it must be one of directional, point, spot",
         set("/extensions/KHR_lights_punctual/lights/0/type", "sun")},
        {"lights[0] is of type \"spot\" and has no \"spot\"", set("/extensions/KHR_lights_punctual/lights/0/type", "spot")},
        {"lights[0] is a spot light whose cone is from 2 to 1 radians",
         set("/extensions/KHR_lights_punctual/lights/0", {{"type", "spot"}, {"spot", {{"innerConeAngle", 2}, {"outerConeAngle", 1}}}})},
        {"nodes[1].extensions.KHR_lights_punctual.light is 7", set("/nodes/1/extensions/KHR_lights_punctual/light", 7)},
        {"has no triangles to show (meshes[0]: points have no surface", set("/meshes/0/primitives/0/mode", 0)},
    };
    for (const Case& bad : cases) {
        MadeGltf made = whole();
        bad.spoil(made);
        expectOneLine(refusal(made), ExitStatus::badInput, bad.expected);
    }
    EXPECT_GE(cases.size(), 55u);
}

TEST(GltfErrors, ThePlaceHasItsLine) {
    MadeGltf made = whole();
    made.json["accessors"][1]["count"] = "x";
    const std::string text = made.text(), message = refusal(made).what();
    const std::size_t at = text.find("\"x\"");
    ASSERT_NE(at, std::string::npos);
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_TRUE(message.starts_with("made.gltf:" + std::to_string(line) + ":")) << message;
}

TEST(GltfErrors, NumbersThatAreNoPlacesAreRefused) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e16f}) {
        MadeGltf made;
        made.primitive()["attributes"]["POSITION"] = made.add<float>({0, 0, 0, 1, bad, 0, 0, 1, 0}, 5126, "VEC3", 3);
        expectOneLine(refusal(made), ExitStatus::badInput, "meshes[0].primitives[0] has the position 1 ");
    }
    MadeGltf unused; // a vertex that no triangle uses harms nobody
    unused.primitive()["attributes"]["POSITION"] = unused.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, std::nanf(""), 0, 0}, 5126, "VEC3", 4);
    unused.primitive()["indices"] = unused.add<std::uint8_t>({0, 1, 2}, 5121, "SCALAR", 3);
    EXPECT_EQ(unused.parsed().objects.size(), 1u);
}

TEST(GltfErrors, AnIndexBeyondTheVerticesIsRefused) {
    MadeGltf made;
    made.primitive()["indices"] = made.add<std::uint16_t>({0, 1, 65535}, 5123, "SCALAR", 3);
    expectOneLine(refusal(made), ExitStatus::badInput, "has the index 65535 (number 2 of accessors[1]), but its POSITION has only 3");
}

TEST(GltfErrors, SparseIndicesRiseAndStayWithin) {
    const auto with = [](const std::vector<std::uint16_t>& indices, int count) {
        MadeGltf made;
        const int at = made.view(bytesOf(indices)), values = made.view(bytesOf<float>({0, 0, 0, 0, 0, 0}));
        made.json["accessors"][0]["sparse"] = {
            {"count", count}, {"indices", {{"bufferView", at}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
        return made;
    };
    expectOneLine(refusal(with({2, 1}, 2)), ExitStatus::badInput, "accessors[0] has the sparse index 1 after 2; they must rise");
    expectOneLine(refusal(with({1, 3}, 2)), ExitStatus::badInput, "accessors[0] has the sparse index 3 after 1");
    expectOneLine(refusal(with({0, 1}, 3)), ExitStatus::badInput, "accessors[0] has sparse index");
    expectOneLine(refusal(with({0, 1}, 4)), ExitStatus::badInput, "accessors[0] has 4 sparse elements, more than the 3");
}

TEST(GltfErrors, ContainersAreWhole) {
    const std::string good = MadeGltf().glb();
    const auto refusedGlb = [](const std::string& bytes) {
        return errorOf([&] { (void)parseGltf(bytes, "made.glb", NormalMode::file, {}); });
    };
    const auto changed = [&](std::size_t at, std::uint32_t value) {
        std::string bytes = good;
        return bytes.replace(at, 4, bytesOf<std::uint32_t>({value}));
    };
    EXPECT_EQ(parseGltf(good, "made.glb", NormalMode::file, {}).objects.size(), 1u);
    EXPECT_EQ(parseGltf(good + "behind", "made.glb", NormalMode::file, {}).objects.size(), 1u) << "what is behind is no part of it";
    expectOneLine(refusedGlb(good.substr(0, 10)), ExitStatus::badInput, "byte 10: the file ends within the header");
    expectOneLine(refusedGlb(good.substr(0, good.size() - 4)), ExitStatus::badInput, "byte 8: the header says");
    expectOneLine(refusedGlb(changed(4, 1)), ExitStatus::badInput, "byte 4: is a .glb of version 1");
    expectOneLine(refusedGlb(changed(8, 0xffffffffu)), ExitStatus::badInput, "byte 8: the header says");
    expectOneLine(refusedGlb(changed(8, 12)), ExitStatus::badInput, "holds no chunk of JSON");
    expectOneLine(refusedGlb(changed(12, 0xfffffff0u)), ExitStatus::badInput, "byte 12: a chunk is said to have");
    expectOneLine(refusedGlb(changed(16, 0x004e4942)), ExitStatus::badInput, "byte 16: the first chunk of a .glb must be the JSON one");
}

TEST(GltfErrors, NoJsonIsSaidToBeNone) {
    const auto refused = [](const std::string& text) {
        return errorOf([&] { (void)parseGltf(text, "made.gltf", NormalMode::file, {}); });
    };
    for (const std::string text :
         {"", "v 0 0 0\n", "[1, 2", "{\"asset\": }", "[]", "{}", "{\"asset\": {\"version\": \"2.0\"}, \"asset\": 1}"})
        expectOneLine(refused(text), ExitStatus::badInput, "made.gltf:1:");
    expectOneLine(refused("{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + std::string(5000, '[') + std::string(5000, ']') + "}"),
                  ExitStatus::overLimit, "nested deeper than 64 levels");
    expectOneLine(refused("{\"asset\": {\"version\": \"2.0\"}, \"extras\": 1e999}"), ExitStatus::badInput, "made.gltf:1:");
}

TEST(GltfErrors, LimitsHoldBeforeAnythingIsBuilt) {
    LoadOptions few;
    few.limits.triangles = 1;
    MadeGltf twice = whole();
    twice.addNode({{"mesh", 0}});
    expectOneLine(refusal(twice, few), ExitStatus::overLimit, "brings the file to 2 triangles, more than the limit of 1");
    LoadOptions one;
    one.limits.objects = 1;
    expectOneLine(refusal(twice, one), ExitStatus::overLimit, "is one object more than the limit of 1");
    LoadOptions dark;
    dark.limits.lights = 0;
    expectOneLine(refusal(whole(), dark), ExitStatus::overLimit, "has 1 light, more than the limit of 0");
    LoadOptions small;
    small.limits.fileBytes = 10;
    expectOneLine(refusal(whole(), small), ExitStatus::overLimit, "buffers[0] brings the buffers to");
    LoadOptions poor;
    poor.limits.memoryBytes = kBytesAtRest + 1000;
    expectOneLine(refusal(whole(), poor), ExitStatus::overLimit, "of memory are needed");
    MadeGltf zeros; // no view: all are zero, as many as one likes
    zeros.json["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 3000000000000}};
    expectOneLine(refusal(zeros), ExitStatus::overLimit, "brings the file to 1000000000000 triangles");
}

TEST(GltfErrors, UnknownKeysAndExtensionsAreNoted) {
    MadeGltf made = whole();
    made.json["nodes"][0]["postion"] = {1, 2, 3};
    made.json["nodes"][1]["postion"] = {1, 2, 3};
    made.json["nodes"][0]["extras"] = {{"anything", nullptr}};
    made.json["materials"][0]["extensions"]["KHR_materials_sheen"] = Json::object();
    const std::string notes = joinedNotes(made.parsed().notes);
    EXPECT_TRUE(contains(notes, "nodes[0]: the unknown key \"postion\" is ignored (2 times in the file)")) << notes;
    EXPECT_TRUE(contains(notes, "materials[0]: the extension \"KHR_materials_sheen\" is left out")) << notes;
    EXPECT_FALSE(contains(notes, "extras")) << notes;
    made.json["extensionsUsed"] = {"KHR_materials_sheen", "KHR_lights_punctual", "EXT_meshopt_compression"};
    const std::string more = joinedNotes(made.parsed().notes);
    EXPECT_TRUE(contains(more, "extensionsUsed: the extension \"EXT_meshopt_compression\" is left out")) << more;
    EXPECT_FALSE(contains(more, "extensionsUsed: the extension \"KHR")) << more << "\nnoted where it is used, or served";
}

TEST(GltfErrors, KindsOfNotesHaveAnEnd) {
    MadeGltf made = whole();
    for (int i = 0; i < 100; ++i)
        made.json["nodes"][0]["key " + std::to_string(i)] = i;
    const std::vector<std::string> notes = made.parsed().notes;
    ASSERT_EQ(notes.size(), 41u);
    EXPECT_TRUE(contains(notes.back(), "more is left out, of further kinds (60 times in the file)")) << notes.back();
}

TEST(GltfErrors, ManyThingsOfOneNameTakeNoLongerForThat) {
    MadeGltf made = whole(); // some seconds each, were every number tried for every name
    made.json["materials"] = Json::array();
    for (int i = 0; i < 20000; ++i)
        made.json["materials"].push_back({{"name", "m"}});
    const GltfFile file = made.parsed();
    EXPECT_EQ(file.materials.back().name, "m 20000");
}

TEST(GltfErrors, WholeNumbersMayBeWrittenWithAPoint) {
    std::string text = whole().text();
    const std::size_t at = text.find("\"count\": 3");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 10, "\"count\": 3.0"); // tinygltf takes it for no number
    EXPECT_EQ(parseGltf(text, "made.gltf", NormalMode::file, {}).objects.size(), 1u);
}

} // namespace
} // namespace shadowlab::scene
