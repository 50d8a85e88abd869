// SPDX-License-Identifier: MIT
#include "app/foreign/export/plain_scene_json.h"

#include <nlohmann/json.hpp>

#include "app/drawing/markup.h"
#include "app/foreign/export/light_words.h"
#include "app/foreign/export/numbers.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::foreign {

namespace {

using Json = nlohmann::ordered_json;

Json listOf(const dvec3& v) { return {v.x, v.y, v.z}; }

/// Of float numbers no more digits than they have.
Json listOf(const vec3& v) { return Json::parse("[" + text(v) + "]"); }

template <typename Vector>
std::string joined(const std::vector<Vector>& vectors) {
    std::string list;
    list.reserve(vectors.size() * 30);
    for (const Vector& vector : vectors)
        appendAll(list, std::span(&vector[0], static_cast<std::size_t>(Vector::length())));
    if (!list.empty()) list.pop_back();
    return list;
}

Json eyeJson(const PlainEye& eye) {
    return {{"position", listOf(eye.position)}, {"right", listOf(eye.right)},     {"up", listOf(eye.up)}, {"back", listOf(eye.back)},
            {"fovYDegrees", eye.fovYDegrees},   {"near", eye.near}, {"far", eye.far}};
}

Json lightJson(const scene::Light& light, const std::string& word) {
    Json json{{"name", light.name}, {"word", word}, {"type", scene::toText(light.type)}, {"color", listOf(light.color)}, {"intensity", light.intensity}};
    if (light.type != scene::LightType::directional) json["position"] = listOf(light.positionWorld);
    if (light.type == scene::LightType::directional || light.type == scene::LightType::spot)
        json["direction"] = listOf(light.directionWorld);
    if (light.type == scene::LightType::spot) json["coneDegrees"] = light.coneDegrees, json["edgeDegrees"] = light.edgeDegrees;
    if (light.type == scene::LightType::rect) json["normal"] = listOf(scene::rectNormalWorld(light));
    if (scene::hasArea(light)) json["pointIntensity"] = scene::pointIntensity(light); // of the point at its centre, W/sr
    return json;
}

Json materialJson(const PlainMaterial& plain) {
    const scene::Material& m = plain.values;
    Json json{{"name", m.name}, {"diffuse", listOf(m.diffuse)}};
    if (m.specular != vec3(0)) json["specular"] = listOf(m.specular), json["shininess"] = m.shininess;
    if (m.emission != vec3(0)) json["emission"] = listOf(m.emission), json["emits"] = scene::toText(m.emits);
    if (m.reflectivity > 0) json["reflectivity"] = m.reflectivity, json["glossDegrees"] = m.glossDegrees;
    if (m.transparency > 0)
        json["transparency"] = m.transparency, json["ior"] = m.ior, json["translucencyDegrees"] = m.translucencyDegrees;
    if (plain.image >= 0) {
        json["image"] = plain.image;
        json["holes"] = plain.hasHoles, json["colors"] = plain.hasColors, json["clamped"] = plain.clamped;
    }
    return json;
}

Json meshJson(const PlainMesh& mesh) {
    Json json{{"name", mesh.name},
              {"material", mesh.material},
              {"castsShadow", mesh.castsShadow},
              {"receivesShadow", mesh.receivesShadow},
              {"emitterOfLight", mesh.emitterOfLight},
              {"closed", mesh.isClosed}};
    return json;
}

void addNumbers(Json& json, const PlainMesh& mesh) {
    json["positions"] = joined(mesh.positions);
    json["normals"] = joined(mesh.normals);
    json["triangles"] = joined(mesh.triangles);
    if (!mesh.texcoords.empty()) json["texcoords"] = joined(mesh.texcoords);
    if (!mesh.colors.empty()) json["colors"] = joined(mesh.colors);
}

} // namespace

std::string meshFile(const std::string& stem, std::size_t mesh) { return "meshes/" + stem + "-" + std::to_string(mesh + 1) + ".ply"; }

std::string plainSceneJson(const PlainScene& scene, ivec2 size, ImagesAs images, MeshesAs meshes) {
    Json json{{"name", scene.name},
              {"size", {size.x, size.y}},
              {"camera", eyeJson(scene.eye)},
              {"ambient", listOf(scene.ambient)},
              {"background", listOf(scene.background)},
              {"exposure", scene.exposure},
              {"lower", listOf(scene.lower)},
              {"upper", listOf(scene.upper)}};
    for (const char* list : {"lights", "materials", "images", "meshes"})
        json[list] = Json::array();
    const std::vector<std::string> words = lightWords(scene.lights);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        json["lights"].push_back(lightJson(scene.lights[i], words[i]));
        json["lights"].back()["casters"] = scene.usefulCasters[i];
    }
    for (const PlainMaterial& material : scene.materials)
        json["materials"].push_back(materialJson(material));
    for (const PlainImage& image : scene.images)
        json["images"].push_back(images == ImagesAs::files
                                     ? image.file
                                     : "data:image/png;base64," + drawing::base64(image::encodePng(image.image, {.opaque = false, .text = {}})));
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        json["meshes"].push_back(meshJson(scene.meshes[i]));
        if (meshes == MeshesAs::numbers)
            addNumbers(json["meshes"].back(), scene.meshes[i]);
        else
            json["meshes"].back()["file"] = meshFile("scene", i);
    }
    std::string written = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    for (std::size_t at = written.find('<'); at != std::string::npos; at = written.find('<', at))
        written.replace(at, 1, "\\u003c");
    return written;
}

} // namespace shadowlab::foreign
