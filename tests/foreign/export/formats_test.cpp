// Every format of every built-in scene, written and read again: by the program's own glTF reader, by a parser of JSON, of XML, of PLY, and by
// counting in POV-Ray's language. That renderers draw what was written is for tests/systems/foreign_check.py.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <charconv>
#include <fstream>
#include <regex>

#include <nlohmann/json.hpp>

#include "app/context/assets.h"
#include "app/foreign/export/export_scene.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/numbers.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::foreign {
namespace {

using Json = nlohmann::json;

scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream.good()) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

/// What stands between the first `begin` and the next `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return "";
    const std::size_t to = text.find(end, from + begin.size());
    return to == std::string::npos ? "" : text.substr(from + begin.size(), to - from - begin.size());
}

/// Calls with each built-in scene and the folder of its export.
template <typename Check>
void forEveryScene(const Format& format, const Check& check) {
    int scenes = 0;
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        SCOPED_TRACE(name);
        const scene::Snapshot scene = scene::loadScene(name, loading());
        const scene::TempFolder folder;
        exportScene(*scene, {&format, name, "shadowlab export " + name, {160, 90}, {}}, folder.path());
        check(*scene, plainScene(*scene), folder.path());
        const std::string readme = content(folder.path() / "README.md");
        for (const scene::Light& light : scene->lights)
            EXPECT_TRUE(scene::contains(readme, light.name));
        EXPECT_EQ(scene::contains(readme, "images of materials"), !plainScene(*scene).images.empty());
        EXPECT_TRUE(scene::contains(readme, "visibility-" + scene->lights.front().name + ".png " + name)) << "the judge line takes the first light's picture";
        for (const char* part : {"shadowlab export", "--calibration calibration.png", "## What is not said here", "right-handed", "160"})
            EXPECT_TRUE(scene::contains(readme, part)) << part;
        ++scenes;
    }
    EXPECT_GE(scenes, 13);
}

void expectNear(const dvec3& a, const dvec3& b, double tolerance) { EXPECT_LE(glm::length(a - b), tolerance) << text(a) << " is not " << text(b); }

TEST(ExportFormats, GltfIsReadBackAsTheSameScene) {
    std::size_t triangles = 0;
    forEveryScene(kGltf, [&](const scene::Scene& scene, const PlainScene& plain, const std::filesystem::path& folder) {
        const scene::Snapshot read = scene::loadScene((folder / "scene.glb").string(), loading());
        std::vector<const PlainMesh*> expected;
        for (const PlainMesh& mesh : plain.meshes)
            if (mesh.emitterOfLight < 0) expected.push_back(&mesh);
        ASSERT_EQ(read->objects.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const scene::Mesh& mesh = *read->objects[i].mesh;
            ASSERT_EQ(mesh.triangles.size(), expected[i]->triangles.size());
            const dmat4 worldFromMesh = scene::worldFromMesh(read->objects[i]);
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (int corner = 0; corner < 3; ++corner) {
                    const dvec3 position = transformPoint(worldFromMesh, dvec3(mesh.positionsMesh[mesh.triangles[t][corner]]));
                    ASSERT_LE(glm::length(position - dvec3(expected[i]->positions[expected[i]->triangles[t][corner]])), 1e-5); // floats of 120 m
                }
            triangles += mesh.triangles.size();
            const scene::Material& material = read->materials[read->objects[i].partMaterials[0]];
            const PlainMaterial& source = plain.materials[expected[i]->material];
            const bool isOptical = source.values.reflectivity > 0 || source.values.transparency > 0;
            if (!isOptical) EXPECT_EQ(material.diffuse, source.values.diffuse) << source.values.name;
            EXPECT_EQ(material.alphaMask != nullptr, source.hasHoles);
            if (source.values.emission != vec3(0)) expectNear(dvec3(material.emission), dvec3(source.values.emission), 1e-6);
        }
        expectNear(read->camera.positionWorld, scene.camera.positionWorld, 1e-9);
        expectNear(glm::normalize(read->camera.targetWorld - read->camera.positionWorld),
                   glm::normalize(scene.camera.targetWorld - scene.camera.positionWorld), 1e-9);
        EXPECT_NEAR(read->camera.fovYDegrees, scene.camera.fovYDegrees, 1e-9);
        EXPECT_DOUBLE_EQ(read->camera.near, scene.camera.near);
        ASSERT_EQ(read->lights.size(), scene.lights.size());
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const scene::Light &a = read->lights[i], &b = scene.lights[i];
            EXPECT_NEAR(a.intensity * double(a.color.g), scene::pointIntensity(b) * double(b.color.g), 1e-6 * scene::pointIntensity(b));
            if (b.type != scene::LightType::directional) expectNear(a.positionWorld, b.positionWorld, 1e-9);
            if (b.type == scene::LightType::directional || b.type == scene::LightType::spot) expectNear(a.directionWorld, b.directionWorld, 1e-9);
            if (b.type == scene::LightType::spot) EXPECT_NEAR(a.coneDegrees, b.coneDegrees, 1e-6);
        }
        const scene::Snapshot board = scene::loadScene((folder / "calibration.glb").string(), loading());
        EXPECT_EQ(scene::triangleCount(*board), 2u * 38u); // 8 squares, 10 greys, 3 colours, 16 cells of the code, and the black behind them
    });
    EXPECT_GE(triangles, 200'000u);
}

/// The same numbers, to the last bit: the shortest text of a float reads back as that float.
template <typename Vector>
void expectNumbers(const std::string& list, const std::vector<Vector>& vectors) {
    const char *at = list.data(), *const end = at + list.size();
    for (const Vector& vector : vectors)
        for (int axis = 0; axis < Vector::length(); ++axis) {
            typename Vector::value_type value{};
            const auto [after, error] = std::from_chars(at, end, value);
            ASSERT_TRUE(error == std::errc{} && value == vector[axis]) << "not " << vector[axis] << " at " << at - list.data();
            at = after == end ? end : after + 1; // a blank
        }
    EXPECT_EQ(at, end);
}

/// What the page and the script for Blender carry.
void expectSameScene(const Json& json, const PlainScene& plain) {
    ASSERT_EQ(json.at("meshes").size(), plain.meshes.size());
    for (std::size_t i = 0; i < plain.meshes.size(); ++i) {
        const Json& mesh = json.at("meshes")[i];
        expectNumbers(mesh.at("positions").get_ref<const std::string&>(), plain.meshes[i].positions);
        expectNumbers(mesh.at("normals").get_ref<const std::string&>(), plain.meshes[i].normals);
        expectNumbers(mesh.at("triangles").get_ref<const std::string&>(), plain.meshes[i].triangles);
        EXPECT_EQ(mesh.at("castsShadow").get<bool>(), plain.meshes[i].castsShadow);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(json.at("camera").at("position")[static_cast<std::size_t>(axis)].get<double>(), plain.eye.position[axis]);
        EXPECT_EQ(json.at("camera").at("back")[static_cast<std::size_t>(axis)].get<double>(), plain.eye.back[axis]);
    }
    ASSERT_EQ(json.at("lights").size(), plain.lights.size());
    for (std::size_t i = 0; i < plain.lights.size(); ++i) {
        EXPECT_EQ(json.at("lights")[i].at("name").get<std::string>(), plain.lights[i].name);
        EXPECT_EQ(json.at("lights")[i].at("word"), plain.lights[i].name); // built-in names are plain
        EXPECT_EQ(json.at("lights")[i].at("intensity").get<double>(), plain.lights[i].intensity);
    }
}

TEST(ExportFormats, TheScriptForBlenderCarriesTheScene) {
    forEveryScene(kBlender, [](const scene::Scene&, const PlainScene& plain, const std::filesystem::path& folder) {
        for (const char* file : {"scene.py", "calibration.py"}) {
            const std::string script = content(folder / file);
            EXPECT_EQ(count(script, "@"), 1u) << "a mark that was not filled in, beside the one that multiplies matrices";
            const Json json = Json::parse(between(script, "json.loads(r\"\"\"", "\"\"\")"));
            EXPECT_EQ(json.at("size"), (Json{160, 90}));
            if (std::string(file) == "scene.py") expectSameScene(json, plain);
        }
        for (const PlainImage& image : plain.images)
            EXPECT_TRUE(std::filesystem::exists(folder / image.file));
    });
}

TEST(ExportFormats, ThePageForThreeCarriesTheSceneAndItsImages) {
    forEveryScene(kThree, [](const scene::Scene&, const PlainScene& plain, const std::filesystem::path& folder) {
        const std::string page = content(folder / "scene.html");
        const Json json = Json::parse(between(page, "id=\"scene\">", "</script>"));
        expectSameScene(json, plain);
        ASSERT_EQ(json.at("images").size(), plain.images.size());
        for (const Json& image : json.at("images"))
            EXPECT_TRUE(image.get<std::string>().starts_with("data:image/png;base64,"));
        EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
        EXPECT_EQ(count(page, "three-module\">"), 0u); // no library was given
        EXPECT_FALSE(scene::contains(page, "http"));   // nothing is fetched from elsewhere
        EXPECT_EQ(count(page, "@"), 0u) << "a mark that was not filled in";
        EXPECT_EQ(count(page, "function pictureByRays("), 1u);
        EXPECT_EQ(count(page, "canvas = pictureByRays("), 1u);
        const std::string readme = content(folder / "README.md");
        EXPECT_EQ(scene::contains(readme, "With `&shadows=rays` at the end of an address"), !plain.lights.empty());
        EXPECT_EQ(count(readme, "picture=visibility&shadows=rays&light=" + plain.lights.front().name), 1u) << "the command for the judged picture";
    });
}

std::string withoutComments(const std::string& file) {
    std::istringstream lines(file);
    std::string code;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("//")) code += line + "\n";
    return code;
}

/// Each length of camera and lights, and each mesh, is multiplied by Metre: one that is not would stand a hundred times nearer than the rest.
void expectLengthsInMetres(const std::string& code, const PlainScene& plain) {
    EXPECT_EQ(count(code, "#declare Metre = 100;\n"), 1u);
    EXPECT_EQ(count(code, "\n  scale Metre\n}"), plain.meshes.size());
    const std::regex length("(?:location|light_source \\{|point_at|fade_distance|area_light) (?:<[^>]*>|[^ ]+)( \\* Metre)?(, <[^>]*>( \\* Metre)?)?");
    std::size_t lengths = 0;
    const std::string beforeMeshes = code.substr(0, code.find("mesh2 {"));
    for (std::sregex_iterator at(beforeMeshes.begin(), beforeMeshes.end(), length), none; at != none; ++at) {
        EXPECT_TRUE((*at)[1].matched && (*at)[2].matched == (*at)[3].matched) << at->str();
        ++lengths;
    }
    EXPECT_GE(lengths, 1 + 3 * plain.lights.size()); // the eye's; two places of each light, and where it is directed or fades
}

TEST(ExportFormats, ThePovRayFileIsBalancedAndHasAllTriangles) {
    std::size_t files = 0;
    forEveryScene(kPov, [&](const scene::Scene&, const PlainScene& plain, const std::filesystem::path& folder) {
        const std::string file = content(folder / "scene.pov");
        const std::string code = withoutComments(file);
        for (const auto& [open, close] : {std::pair{"{", "}"}, {"<", ">"}, {"[", "]"}})
            EXPECT_EQ(count(code, open), count(code, close)) << open;
        EXPECT_EQ(count(file, "#if") + count(file, "#macro"), count(file, "#end"));
        EXPECT_EQ(count(file, "mesh2 {"), plain.meshes.size());
        std::size_t triangles = 0, at = 0;
        for (const PlainMesh& mesh : plain.meshes) {
            at = file.find("face_indices { ", at) + 15;
            EXPECT_EQ(std::stoul(file.substr(at)), mesh.triangles.size());
            triangles += std::stoul(file.substr(at));
        }
        EXPECT_GE(triangles, 14u);
        EXPECT_TRUE(scene::contains(file, "location <" + text(plain.eye.position) + ">"));
        expectLengthsInMetres(code, plain);
        EXPECT_EQ(count(file, "light_source {"), 2 * plain.lights.size()); // as it is, and white
        const auto casters = static_cast<std::size_t>(std::ranges::count_if(plain.meshes, [](const PlainMesh& m) { return m.castsShadow; }));
        EXPECT_EQ(count(file, " no_shadow\n"), plain.meshes.size() - casters);
        EXPECT_EQ(count(file, "#if (Picture = 2) no_shadow #end\n"), casters) << "of the one light none casts a shadow there, and it keeps its cone";
        ++files;
    });
    EXPECT_GE(files, 13u);
}

/// Whether each element is closed by its own name, in order, and has no stray sign.
bool isWellFormed(const std::string& xml) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([A-Za-z_?!-][^\\s/>]*)((?:\\s+[\\w]+=\"[^\"<]*\")*)\\s*(\\??/?)>|<!--(?:[^-]|-[^-])*-->");
    std::size_t end = 0, elements = 0;
    for (std::sregex_iterator at(xml.begin(), xml.end(), tag), none; at != none; ++at) {
        const std::string before = xml.substr(end, static_cast<std::size_t>(at->position()) - end);
        if (before.find_first_not_of(" \n") != std::string::npos) return false; // these files have no text between tags
        end = static_cast<std::size_t>(at->position() + at->length());
        const std::string name = (*at)[2];
        if (name.empty() || name.starts_with('?')) continue;
        ++elements;
        if ((*at)[1] == "/") {
            if (open.empty() || open.back() != name) return false;
            open.pop_back();
        } else if ((*at)[4] != "/") {
            open.push_back(name);
        }
    }
    return open.empty() && elements > 10 && xml.substr(end) == "\n";
}

TEST(ExportFormats, TheMitsubaFilesAreWellFormedAndHaveAllTriangles) {
    EXPECT_FALSE(isWellFormed("<scene><a></scene></a>\n"));
    std::size_t meshes = 0;
    forEveryScene(kMitsuba, [&](const scene::Scene&, const PlainScene& plain, const std::filesystem::path& folder) {
        for (const char* file : {"scene.xml", "calibration.xml"})
            EXPECT_TRUE(isWellFormed(content(folder / file))) << file;
        const std::string xml = content(folder / "scene.xml");
        for (std::size_t i = 0; i < plain.meshes.size(); ++i) {
            const std::string name = "meshes/scene-" + std::to_string(i + 1) + ".ply", ply = content(folder / name);
            EXPECT_EQ(count(xml, "\"" + name + "\""), 1u);
            EXPECT_EQ(std::stoul(between(ply, "element vertex ", "\n")), plain.meshes[i].positions.size());
            EXPECT_EQ(std::stoul(between(ply, "element face ", "\n")), plain.meshes[i].triangles.size());
            const std::size_t floats = plain.meshes[i].texcoords.empty() ? 6 : 8;
            EXPECT_EQ(ply.size(), ply.find("end_header\n") + 11 + 4 * floats * plain.meshes[i].positions.size() + 13 * plain.meshes[i].triangles.size());
            ++meshes;
        }
        const Json json = Json::parse(between(content(folder / "visibility.py"), "json.loads(r\"\"\"", "\"\"\")"));
        EXPECT_EQ(json.at("meshes").size(), plain.meshes.size());
    });
    EXPECT_GE(meshes, 70u);
}

/// A scene with everything that some format leaves out.
scene::Snapshot oddScene() {
    return scene::parseSceneJson(R"({"camera": {"position": [0, 2, 6], "target": [0, 0, 0]}, "exposure": 2, "ambient": [0.1, 0.1, 0.1], "background": [0.2, 0.2, 0.2],
        "lights": [{"name": "a \"lamp\" --> </script>", "type": "rect", "position": [0, 3, 0]},
                   {"name": "cone", "type": "spot", "position": [2, 3, 0], "edgeDegrees": 5}],
        "materials": {"glass": {"transparency": 0.9, "reflectivity": 0.1}, "mirror": {"diffuse": [0, 0, 0], "reflectivity": 0.9, "glossDegrees": 3},
                      "shiny @FILE@": {"specular": [0.2, 0.2, 0.2], "emission": [1, 1, 1]}},
        "objects": [{"shape": "quad", "size": [9, 9], "receivesShadow": false}, {"name": "nameless -- '\" </script>", "shape": "box", "size": [1, 1, 1], "castsShadow": false, "material": "glass"},
                    {"shape": "sphere", "radius": 0.5, "translate": [2, 1, 0], "material": "mirror"},
                    {"shape": "sphere", "radius": 0.5, "translate": [-2, 1, 0], "material": "shiny @FILE@"}]})",
                                 "odd.json", loading());
}

TEST(ExportFormats, TheReadmeNamesWhatThisSceneLosesAndNothingElse) {
    const PlainScene odd = plainScene(*oddScene()), plain = plainScene(*scene::loadScene("sphere-on-plane", loading()));
    const std::vector<std::pair<const Format*, std::vector<const char*>>> expected{
        {&kBlender, {"never shadowed", "along another curve", "by its surface", "Beckmann", "GGX", "no priority"}},
        {&kThree, {"shadow maps", "is a point at its centre", "no cosine", "with the cosine", "mirrors nothing", "lets nothing through", "Schlick"}},
        {&kPov, {"never shadowed", "shines to all sides", "9 x 9", "both sides", "no cosine", "clear", "lets light through"}},
        {&kMitsuba, {"pixel centres", "ambient light", "background", "exposure", "casts no shadow", "never shadowed", "no highlight", "Fresnel"}},
        {&kGltf, {"ambient light", "background", "exposure", "casts no shadow", "never shadowed", "spot of half a turn", "index of refraction"}}};
    for (const auto& [format, parts] : expected) {
        std::string all;
        for (const std::string& sentence : format->leftOut(odd))
            all += sentence + "\n";
        for (const char* part : parts)
            EXPECT_TRUE(scene::contains(all, part)) << format->name << ": " << part << "\n" << all;
    }
    EXPECT_EQ(kBlender.leftOut(plain).size(), 0u);
    EXPECT_EQ(kPov.leftOut(plain).size(), 0u);
    EXPECT_EQ(kThree.leftOut(plain).size(), 1u);   // its shadows are maps
    EXPECT_EQ(kGltf.leftOut(plain).size(), 2u);    // ambient light and background
    EXPECT_EQ(kMitsuba.leftOut(plain).size(), 3u); // these and pixel centres
}

/// The folder of the odd scene in that format.
class OddFolder {
public:
    explicit OddFolder(const Format& format) { exportScene(*odd, {&format, "odd.json", "shadowlab export odd.json", {160, 90}, {}}, folder.path()); }
    [[nodiscard]] std::string text(const char* file) const { return content(folder.path() / file); }

    scene::Snapshot odd = oddScene();
    scene::TempFolder folder;
};

TEST(ExportFormats, NamesMayHoldAnyCharacters) {
    const std::string page = OddFolder(kThree).text("scene.html");
    EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
    const OddFolder blender(kBlender);
    for (const Json& json : {Json::parse(between(page, "id=\"scene\">", "</script>")),
                             Json::parse(between(blender.text("scene.py"), "json.loads(r\"\"\"", "\"\"\")"))}) {
        EXPECT_EQ(json.at("lights")[0].at("name"), blender.odd->lights[0].name);
        EXPECT_EQ(json.at("meshes")[1].at("name"), blender.odd->objects[1].name);
        EXPECT_EQ(json.at("materials")[3].at("name"), "shiny @FILE@");
    }
    EXPECT_TRUE(isWellFormed(OddFolder(kMitsuba).text("scene.xml")));
    EXPECT_TRUE(scene::contains(OddFolder(kPov).text("scene.pov"), "// nameless -- '\" </script>\nmesh2"));
    EXPECT_EQ(scene::loadScene((OddFolder(kGltf).folder.path() / "scene.glb").string(), loading())->lights.size(), 2u);
}

std::vector<std::string> wordsOf(const std::vector<std::string>& names) {
    std::vector<scene::Light> lights(names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        lights[i].name = names[i];
    return lightWords(lights);
}

TEST(ExportFormats, LightsHaveWordsThatAnyCommandLineTakes) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(wordsOf({"key", "left_2"}), (Words{"key", "left_2"}));
    EXPECT_EQ(wordsOf({"a--b-", "a -- b -"}), (Words{"a--b-", "a-b"}));
    EXPECT_EQ(wordsOf({"Key & Fill #1", "Sun/1", "--help", "100% \u00e9", "../../x", "-o"}), (Words{"Key-Fill-1", "Sun-1", "help", "100", "x", "o"}));
    EXPECT_EQ(wordsOf({"\u65e5", "\u5149", "light"}), (Words{"light-1", "light-2", "light"})) << "the one with that name keeps it";
    EXPECT_EQ(wordsOf({"sun", "Sun", "SUN", "Sun-2"}), (Words{"sun", "Sun-3", "SUN-4", "Sun-2"})) << "some file systems know no capitals";
    EXPECT_EQ(wordsOf({std::string(300, 'a')}), (Words{std::string(64, 'a')}));
    EXPECT_EQ(wordsOf({std::string(63, 'a') + " b"}), (Words{std::string(63, 'a')}));
    EXPECT_EQ(lightOption("key"), " --light key");
    EXPECT_EQ(lightOption("a b"), " --light 'a b'");
    EXPECT_EQ(lightOption("--help"), " --light=--help");
}

TEST(ExportFormats, CommandsOfTheReadmeNameFilesAndLightsByWords) {
    for (const Format* format : formats()) {
        const std::string readme = OddFolder(*format).text("README.md");
        EXPECT_TRUE(scene::contains(readme, "judge visibility-a-lamp-script.png odd.json --light 'a \"lamp\" --> </script>' --by-centre ")) << readme;
        std::istringstream lines(readme);
        std::size_t named = 0;
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with("    ")) continue;
            const bool takesNames = scene::contains(line, "shadowlab "); // the program's own commands know names alone
            EXPECT_TRUE(takesNames || !scene::contains(line, "lamp\"")) << line;
            EXPECT_FALSE(scene::contains(line, "visibility.png")) << line;
            named += scene::contains(line, "a-lamp-script");
        }
        EXPECT_GE(named, format == &kGltf ? 2u : 2u + (format == &kMitsuba ? 0 : 2)) << format->name;
        EXPECT_FALSE(scene::contains(readme, "commands below"));
        EXPECT_FALSE(scene::contains(readme, "textures/")) << "it has no images";
        EXPECT_TRUE(scene::contains(readme, "so that the board of another is refused"));
    }
}

TEST(ExportFormats, NumbersReadBackAsTheyWere) {
    EXPECT_EQ(text(0.1f), "0.1");
    EXPECT_EQ(text(-0.0), "0");
    EXPECT_EQ(text(dvec3(1, 0.5, 1.0 / 3)), "1, 0.5, 0.3333333333333333");
    EXPECT_EQ(shellWord("key"), "key");
    EXPECT_EQ(shellWord("a lamp's"), "'a lamp'\\''s'");
    EXPECT_EQ(shellWord(""), "''");
}

} // namespace
} // namespace shadowlab::foreign
