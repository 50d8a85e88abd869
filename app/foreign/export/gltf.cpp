// glTF 2.0, one binary file (.glb): meshes, materials with their images, a camera, and lights by KHR_lights_punctual.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include <glm/gtc/constants.hpp>

#include "app/foreign/export/format.h"
#include "app/foreign/export/left_out.h"
#include "app/foreign/export/light_words.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::foreign {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;         // component types
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963; // targets
constexpr int kNearest = 9728, kLinear = 9729, kRepeat = 10497, kClamp = 33071;
constexpr double kDielectric = 0.04; // what glTF's surfaces mirror head-on, where nothing is said

Json listOfThree(const dvec3& v) { return {v.x, v.y, v.z}; }

/// The one buffer, and the document that describes it.
class Document {
public:
    explicit Document(const PlainScene& scene) : scene_(scene) {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "Shadowlab"}}}, {"scene", 0}, {"scenes", {{{"name", scene.name}, {"nodes", Json::array()}}}}};
        for (const char* list : {"extensionsUsed", "nodes", "cameras", "materials", "meshes", "accessors", "bufferViews"})
            json_[list] = Json::array();
    }

    void addCamera(ivec2 size);
    void addLights();
    void addMaterials();
    void addMeshes();
    /// The file: header, chunk of JSON, chunk of bytes.
    std::vector<std::uint8_t> glb();

private:
    std::size_t addView(const void* bytes, std::size_t count, int target);
    template <typename Vector>
    std::size_t addVectors(const std::vector<Vector>& vectors, const char* type);
    void addNode(Json node) {
        json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
        json_["nodes"].push_back(std::move(node));
    }
    void use(const std::string& extension) { used_.insert(extension); }
    Json materialJson(const PlainMaterial& plain);
    Json textureOf(const PlainMaterial& plain);
    void addOptics(Json& json, const scene::Material& m);

    const PlainScene& scene_;
    Json json_;
    std::vector<std::uint8_t> bytes_;
    std::set<std::string> used_;
};

std::size_t Document::addView(const void* bytes, std::size_t count, int target) {
    const std::size_t at = bytes_.size();
    const auto* begin = static_cast<const std::uint8_t*>(bytes);
    bytes_.insert(bytes_.end(), begin, begin + count);
    bytes_.resize((bytes_.size() + 3) / 4 * 4); // views of floats begin at multiples of four
    Json view{{"buffer", 0}, {"byteOffset", at}, {"byteLength", count}};
    if (target != 0) view["target"] = target;
    json_["bufferViews"].push_back(view);
    return json_["bufferViews"].size() - 1;
}

template <typename Vector>
std::size_t Document::addVectors(const std::vector<Vector>& vectors, const char* type) {
    json_["accessors"].push_back({{"bufferView", addView(vectors.data(), vectors.size() * sizeof(Vector), kArrayBuffer)},
                                  {"componentType", kFloat},
                                  {"count", vectors.size()},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
}

void Document::addCamera(ivec2 size) {
    const PlainEye& eye = scene_.eye;
    json_["cameras"].push_back({{"type", "perspective"},
                                {"perspective", {{"yfov", glm::radians(eye.fovYDegrees)}, {"aspectRatio", double(size.x) / size.y}, {"znear", eye.near}}}});
    Json matrix = Json::array();
    for (const dvec3& column : {eye.right, eye.up, eye.back, eye.position}) {
        for (int i = 0; i < 3; ++i)
            matrix.push_back(column[i]);
        matrix.push_back(matrix.size() == 15 ? 1 : 0);
    }
    addNode({{"name", "camera"}, {"camera", 0}, {"matrix", matrix}});
}

/// The turn that takes -z to a direction, as glTF's x, y, z, w.
Json turnTo(const dvec3& direction) {
    const dvec3 from(0, 0, -1);
    dvec4 turn(glm::cross(from, direction), 1 + glm::dot(from, direction));
    if (turn.w < 1e-9) turn = dvec4(1, 0, 0, 0); // back: half a turn about x
    turn = glm::normalize(turn);
    return {turn.x, turn.y, turn.z, turn.w};
}

void Document::addLights() {
    if (scene_.lights.empty()) return;
    use("KHR_lights_punctual");
    Json lights = Json::array();
    for (const scene::Light& light : scene_.lights) {
        // Its color is a share, from 0 to 1.
        const auto most = std::max({double(light.color.x), double(light.color.y), double(light.color.z), 1.0});
        const bool isRect = light.type == scene::LightType::rect, isSpot = light.type == scene::LightType::spot || isRect;
        Json json{{"name", light.name},
                  {"type", light.type == scene::LightType::directional ? "directional" : isSpot ? "spot" : "point"},
                  {"color", listOfThree(dvec3(light.color) / most)},
                  {"intensity", scene::pointIntensity(light) * most}};
        if (isSpot) {
            const double outer = isRect ? glm::half_pi<double>() : glm::radians(light.coneDegrees / 2);
            const double soft = std::max(glm::radians(isRect ? 0.0 : light.edgeDegrees), 1e-6 * outer); // the inner cone must be smaller
            json["spot"] = {{"innerConeAngle", outer - soft}, {"outerConeAngle", outer}};
        }
        Json node{{"name", light.name}, {"extensions", {{"KHR_lights_punctual", {{"light", lights.size()}}}}}};
        if (light.type != scene::LightType::directional) node["translation"] = listOfThree(light.positionWorld);
        if (isSpot || light.type == scene::LightType::directional)
            node["rotation"] = turnTo(isRect ? scene::rectNormalWorld(light) : light.directionWorld);
        lights.push_back(json);
        addNode(node);
    }
    json_["extensions"]["KHR_lights_punctual"]["lights"] = lights;
}

Json Document::textureOf(const PlainMaterial& plain) {
    const Json sampler{{"magFilter", plain.hasHoles ? kNearest : kLinear},
                       {"minFilter", plain.hasHoles ? kNearest : kLinear},
                       {"wrapS", plain.clamped ? kClamp : kRepeat},
                       {"wrapT", plain.clamped ? kClamp : kRepeat}};
    json_["samplers"].push_back(sampler);
    json_["textures"].push_back({{"source", plain.image}, {"sampler", json_["samplers"].size() - 1}});
    return {{"index", json_["textures"].size() - 1}};
}

/// Mirrors are metals, glass is transmission; what is both dull and slightly mirroring is a dielectric.
void Document::addOptics(Json& json, const scene::Material& m) {
    Json& pbr = json["pbrMetallicRoughness"];
    if (m.transparency > 0) {
        use("KHR_materials_transmission"), use("KHR_materials_ior"), use("KHR_materials_volume");
        pbr["baseColorFactor"] = {1, 1, 1, 1};
        pbr["roughnessFactor"] = std::sqrt(glm::radians(m.translucencyDegrees));
        json["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", m.transparency}};
        json["extensions"]["KHR_materials_ior"] = {{"ior", std::max(1.0, m.ior)}};
        json["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 1}};
    } else if (m.reflectivity > std::max({m.diffuse.x, m.diffuse.y, m.diffuse.z})) {
        pbr["metallicFactor"] = 1;
        pbr["baseColorFactor"] = {m.reflectivity, m.reflectivity, m.reflectivity, 1};
        pbr["roughnessFactor"] = std::sqrt(glm::radians(m.glossDegrees));
    }
}

Json Document::materialJson(const PlainMaterial& plain) {
    const scene::Material& m = plain.values;
    // The width of Blinn's lobe (1977), whose exponent is 2 / a^2 - 2 with a the square of the roughness (Karis, 2013).
    const double roughness = hasHighlight(plain) ? std::pow(2 / (double(m.shininess) + 2), 0.25) : 1.0;
    Json json{{"name", m.name},
              {"doubleSided", !(shines(plain) && m.emits == scene::EmittingSides::front)},
              {"pbrMetallicRoughness",
               {{"baseColorFactor", {m.diffuse.x, m.diffuse.y, m.diffuse.z, 1}}, {"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
    use("KHR_materials_specular");
    json["extensions"]["KHR_materials_specular"] =
        hasHighlight(plain) ? Json{{"specularColorFactor", listOfThree(dvec3(m.specular) / kDielectric)}} : Json{{"specularFactor", 0}};
    if (shines(plain)) {
        const double most = std::max({1.0, double(m.emission.x), double(m.emission.y), double(m.emission.z)});
        json["emissiveFactor"] = listOfThree(dvec3(m.emission) / most);
        use("KHR_materials_emissive_strength");
        json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", most}};
    }
    if (isMirror(plain) || isGlass(plain)) {
        json["extensions"].erase("KHR_materials_specular");
        addOptics(json, m);
    }
    if (plain.image >= 0) json["pbrMetallicRoughness"]["baseColorTexture"] = textureOf(plain);
    if (plain.hasHoles) json["alphaMode"] = "MASK", json["alphaCutoff"] = 0.5;
    if (json["extensions"].empty()) json.erase("extensions");
    return json;
}

void Document::addMaterials() {
    for (const PlainImage& image : scene_.images) {
        const std::vector<std::uint8_t> png = image::encodePng(image.image, {.opaque = false, .text = {}});
        json_["images"].push_back({{"mimeType", "image/png"}, {"bufferView", addView(png.data(), png.size(), 0)}});
    }
    for (const PlainMaterial& plain : scene_.materials)
        json_["materials"].push_back(materialJson(plain));
}

void Document::addMeshes() {
    for (const PlainMesh& mesh : scene_.meshes) {
        if (mesh.emitterOfLight >= 0) continue; // it would stand before its own light
        Json attributes{{"POSITION", addVectors(mesh.positions, "VEC3")}};
        vec3 lower = mesh.positions.front(), upper = lower;
        for (const vec3& position : mesh.positions)
            lower = glm::min(lower, position), upper = glm::max(upper, position);
        json_["accessors"].back()["min"] = listOfThree(dvec3(lower));
        json_["accessors"].back()["max"] = listOfThree(dvec3(upper));
        attributes["NORMAL"] = addVectors(mesh.normals, "VEC3");
        if (!mesh.texcoords.empty()) {
            std::vector<vec2> fromTop = mesh.texcoords;
            for (vec2& place : fromTop)
                place.y = 1 - place.y;
            attributes["TEXCOORD_0"] = addVectors(fromTop, "VEC2");
        }
        if (!mesh.colors.empty()) attributes["COLOR_0"] = addVectors(mesh.colors, "VEC3");
        const std::size_t indices = addView(mesh.triangles.data(), mesh.triangles.size() * sizeof(uvec3), kElementBuffer);
        json_["accessors"].push_back(
            {{"bufferView", indices}, {"componentType", kUnsignedInt}, {"count", 3 * mesh.triangles.size()}, {"type", "SCALAR"}});
        json_["meshes"].push_back(
            {{"name", mesh.name},
             {"primitives", {{{"attributes", attributes}, {"indices", json_["accessors"].size() - 1}, {"material", mesh.material}}}}});
        addNode({{"name", mesh.name}, {"mesh", json_["meshes"].size() - 1}});
    }
}

void append(std::vector<std::uint8_t>& file, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<std::uint8_t>(number >> shift));
}

std::vector<std::uint8_t> Document::glb() {
    json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    for (const std::string& extension : used_)
        json_["extensionsUsed"].push_back(extension);
    for (const char* list : {"extensionsUsed", "materials", "meshes", "accessors", "bufferViews", "buffers"})
        if (json_[list].empty() || (std::string_view(list) == "buffers" && bytes_.empty())) json_.erase(list); // an empty list is none
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');

    constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
    std::vector<std::uint8_t> file;
    append(file, kMagic), append(file, 2);
    const std::size_t length = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + bytes_.size());
    append(file, static_cast<std::uint32_t>(length));
    append(file, static_cast<std::uint32_t>(text.size())), append(file, kJsonChunk);
    file.insert(file.end(), text.begin(), text.end());
    if (!bytes_.empty()) {
        append(file, static_cast<std::uint32_t>(bytes_.size())), append(file, kBinaryChunk);
        file.insert(file.end(), bytes_.begin(), bytes_.end());
    }
    return file;
}

void writeGltf(const ExportJob& job) {
    Document document(job.scene);
    document.addCamera(job.size);
    document.addLights();
    document.addMaterials();
    document.addMeshes();
    image::writeWhole(job.folder / (job.stem + ".glb"), document.glb());
}

std::vector<std::string> leftOutOfGltf(const PlainScene& scene) {
    LeftOut list(scene);
    list.noAmbient();
    list.noBackground();
    list.noExposure();
    list.noCastsShadow();
    list.noReceivesShadow();
    list.lights([](const scene::Light& light) { return scene::hasArea(light); },
                "is a point at its centre (a rect a spot of half a turn), with the intensity that it has from afar; its surface is not there");
    list.soften("glTF leaves the curve of the soft edge to programs");
    list.materials([](const PlainMaterial& m) { return shines(m) && m.values.emits == scene::EmittingSides::front; },
                   "is not double-sided, so programs may show nothing from behind");
    list.materials(hasHighlight, "the highlight is that of a dielectric of the same width, which grows toward grazing angles");
    list.materials(
        [](const PlainMaterial& m) {
            return isMirror(m) && !isGlass(m) && m.values.reflectivity <= std::max({m.values.diffuse.x, m.values.diffuse.y, m.values.diffuse.z});
        },
        "is dull more than it mirrors, and mirrors as every dielectric does");
    list.materials(isGlass, "mirrors as its index of refraction says; nested media have no priority");
    list.materials(isBlurred, "mirrors and glass are rough, by the nearest width");
    return list.take();
}

std::string howToGltf(const PlainScene& scene, ivec2 size) {
    const std::string pixels = std::to_string(size.x) + "x" + std::to_string(size.y);
    const std::string light = scene.lights.empty() ? "" : lightOption(scene.lights.front().name);
    const std::string word = scene.lights.empty() ? "" : "-" + lightWords(scene.lights).front();
    return "A .glb file is read by Blender (File, Import), Godot, Unity and Unreal (by their importers), three.js (GLTFLoader), Babylon.js and others, and by "
           "Shadowlab itself:\n\n    shadowlab capture scene.glb --stage visibility -t ray-traced" +
           light + " --size " + pixels +
           " -o visibility" + word + ".png\n\n"
           "Choose the file's camera in the program; its vertical angle counts, and the picture is to have " + pixels +
           " pixels. Turn off antialiasing, tone mapping, bloom, ambient light and all lights but one, and let materials be seen from both sides. Draw once with "
           "shadows, once with the light's shadows turned off, and the calibration board with nothing else in the scene.\n";
}

} // namespace

const Format kGltf{"gltf", "programs that read glTF 2.0", "`scene.glb`, `calibration.glb`", "images of materials included", true, writeGltf, leftOutOfGltf, howToGltf};

} // namespace shadowlab::foreign
