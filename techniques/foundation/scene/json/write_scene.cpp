// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/write_scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/query/view/default_near.h"

namespace shadowlab::scene {

namespace {

/// JSON readers read "-0" as the integer 0 and lose the sign.
std::string signedZero(double value) { return std::signbit(value) ? "-0.0" : "0"; }

std::string numberText(double value) { return value == 0 ? signedZero(value) : scene::numberText(value); }

/// Colours are floats: their own shortest digits, not those of the doubles they become.
std::string numberText(float value) {
    if (value == 0) return signedZero(value);
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} ? std::string(text.data(), end) : std::string("0");
}

std::string inJson(const std::string& text) { return textInJson(text); }

/// Keys and values of one JSON object, in one line.
class Line {
public:
    Line& raw(std::string_view key, const std::string& value) {
        text_ += (text_.empty() ? "" : ", ") + inJson(std::string(key)) + ": " + value;
        return *this;
    }
    Line& text(std::string_view key, const std::string& value) { return raw(key, inJson(value)); }
    Line& number(std::string_view key, double value) { return raw(key, numberText(value)); }
    template <typename Vector>
    Line& vector(std::string_view key, const Vector& value) {
        return raw(key, list(value));
    }
    /// Writes the key only if the value is not the default of the reader.
    template <typename Value>
    Line& unless(std::string_view key, const Value& value, const Value& standard) {
        if (value == standard) return *this;
        if constexpr (std::is_same_v<Value, bool>)
            return raw(key, value ? "true" : "false");
        else if constexpr (std::is_same_v<Value, float>)
            return raw(key, numberText(value));
        else if constexpr (std::is_arithmetic_v<Value>)
            return number(key, static_cast<double>(value));
        else
            return vector(key, value);
    }
    [[nodiscard]] std::string json() const { return "{" + text_ + "}"; }

    static std::string list(const dvec3& v) {
        return "[" + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + "]";
    }
    static std::string list(const vec3& v) {
        return "[" + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + "]";
    }

private:
    std::string text_;
};

std::string cameraJson(const Scene& scene, const Camera& camera) {
    Camera standard;
    standard.near = defaultNear(scene, camera);
    Line line;
    line.vector("position", camera.positionWorld)
        .vector("target", camera.targetWorld)
        .unless("up", camera.upWorld, standard.upWorld)
        .unless("fovYDegrees", camera.fovYDegrees, standard.fovYDegrees)
        .unless("near", camera.near, standard.near);
    if (std::isfinite(camera.far)) line.number("far", camera.far);
    return line.json();
}

std::string lightJson(const Light& light) {
    const Light standard;
    Line line;
    line.text("name", light.name).text("type", std::string(toText(light.type)));
    if (light.type != LightType::directional) line.vector("position", light.positionWorld);
    if (light.type == LightType::directional || light.type == LightType::spot)
        line.vector("direction", light.directionWorld);
    if (light.type == LightType::spot)
        line.number("coneDegrees", light.coneDegrees).unless("edgeDegrees", light.edgeDegrees, standard.edgeDegrees);
    if (light.type == LightType::rect) line.vector("edgeU", light.edgeUWorld).vector("edgeV", light.edgeVWorld);
    if (light.type == LightType::sphere) line.number("radius", light.radius);
    line.unless("color", light.color, standard.color).unless("intensity", light.intensity, standard.intensity);
    return line.json();
}

std::string relativeName(const std::filesystem::path& file, const std::filesystem::path& folder) {
    std::error_code ignored;
    const std::filesystem::path base = std::filesystem::weakly_canonical(folder, ignored);
    const std::filesystem::path relative = file.lexically_relative(base);
    return (relative.empty() ? file : relative).generic_string();
}

std::string materialJson(const Material& material, const std::filesystem::path& folder) {
    const Material standard;
    Line line;
    line.unless("diffuse", material.diffuse, standard.diffuse)
        .unless("specular", material.specular, standard.specular)
        .unless("shininess", material.shininess, standard.shininess)
        .unless("reflectivity", material.reflectivity, standard.reflectivity)
        .unless("transparency", material.transparency, standard.transparency)
        .unless("ior", material.ior, standard.ior)
        .unless("priority", material.priority, standard.priority)
        .unless("glossDegrees", material.glossDegrees, standard.glossDegrees)
        .unless("translucencyDegrees", material.translucencyDegrees, standard.translucencyDegrees)
        .unless("emission", material.emission, standard.emission);
    if (material.emits != standard.emits) line.text("emits", std::string(toText(material.emits)));
    if (!material.alphaMap.empty()) line.text("alphaMap", relativeName(material.alphaMap, folder));
    if (!material.diffuseMap.empty()) line.text("diffuseMap", relativeName(material.diffuseMap, folder));
    return line.json();
}

/// "torus 1 0.3 64 32" as keys of the scene format.
void addShape(Line& line, const std::string& shape) {
    std::istringstream words(shape);
    std::string kind;
    words >> kind;
    std::vector<std::string> numbers;
    for (std::string number; words >> number;)
        numbers.push_back(number);
    const auto list = [&](std::size_t from, std::size_t to) {
        std::string text = "[";
        for (std::size_t i = from; i < to; ++i)
            text += (i > from ? ", " : "") + numbers[i];
        return text + "]";
    };
    line.text("shape", kind);
    if (kind == "sphere")
        line.raw("radius", numbers[0]).raw("segments", numbers[1]);
    else if (kind == "torus")
        line.raw("radii", list(0, 2)).raw("segments", list(2, 4));
    else
        line.raw("size", list(0, numbers.size()));
}

std::string objectJson(const Object& object, const std::filesystem::path& folder) {
    const ObjectSource& source = object.source;
    Line line;
    line.text("name", object.name);
    if (source.shape.empty())
        line.text("mesh", relativeName(source.mesh, folder));
    else
        addShape(line, source.shape);
    if (!source.node.empty()) line.text("node", source.node);
    if (!source.material.empty()) line.text("material", source.material);
    if (!source.normals.empty()) line.text("normals", source.normals);
    line.unless("scale", source.scale, dvec3(1.0))
        .unless("rotateDegrees", source.rotateDegrees, dvec3(0.0))
        .unless("translate", source.translateWorld, dvec3(0.0))
        .unless("castsShadow", object.castsShadow, true)
        .unless("receivesShadow", object.receivesShadow, true)
        .unless("velocity", object.velocityWorld, dvec3(0.0));
    return line.json();
}

/// The materials of emitter surfaces, which the reader makes again from the lights.
std::set<std::size_t> materialsOfLights(const Scene& scene) {
    std::set<std::size_t> indices;
    for (const Object& object : scene.objects)
        if (object.emitterOfLight >= 0) indices.insert(object.partMaterials.begin(), object.partMaterials.end());
    return indices;
}

/// What the scene's "white" is: the material of parts of a mesh that have none of their own. In a staged mesh that is clay.
const Material& whiteOf(const Scene& scene) {
    for (const Object& object : scene.objects)
        if (!object.source.mesh.empty() && object.source.material.empty())
            for (const std::uint32_t index : object.partMaterials)
                if (!scene.materials[index].ofMesh) return scene.materials[index];
    return scene.materials.front();
}

/// `"key": [ ... ]` or `"key": { ... }`, one entry a line.
std::string block(const std::string& key, char open, char close, const std::vector<std::string>& entries) {
    std::string text = "  \"" + key + "\": " + open;
    for (std::size_t i = 0; i < entries.size(); ++i)
        text += (i ? "," : "") + std::string("\n    ") + entries[i];
    return text + (entries.empty() ? "" : "\n  ") + close;
}

} // namespace

std::string textInJson(const std::string& text) {
    // A file's name may hold bytes that are no UTF-8; JSON may not.
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string sceneText(const Scene& scene, const Camera& camera, const std::filesystem::path& folder) {
    std::vector<std::string> views, lights, materials, objects;
    for (const Viewpoint& view : scene.viewpoints)
        views.push_back(inJson(view.name) + ": " + cameraJson(scene, view.camera));
    for (const Light& light : scene.lights)
        lights.push_back(lightJson(light));
    const std::set<std::size_t> ofLights = materialsOfLights(scene);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        if (material.ofMesh || ofLights.contains(i)) continue;
        const std::string json = materialJson(i == 0 ? whiteOf(scene) : material, folder);
        if (json != "{}" || material.name != Material{}.name) materials.push_back(inJson(material.name) + ": " + json);
    }
    for (const Object& object : scene.objects)
        if (object.emitterOfLight < 0 && !object.isFurtherPiece) objects.push_back(objectJson(object, folder));

    std::string text = "{\n  \"camera\": " + cameraJson(scene, camera) + ",\n";
    if (!views.empty()) text += block("views", '{', '}', views) + ",\n";
    text += "  \"ambient\": " + Line::list(scene.ambient) + ",\n";
    text += "  \"background\": " + Line::list(scene.background) + ",\n";
    if (scene.exposure != 1.0f) text += "  \"exposure\": " + numberText(scene.exposure) + ",\n";
    text += block("lights", '[', ']', lights) + ",\n";
    if (!materials.empty()) text += block("materials", '{', '}', materials) + ",\n";
    return text + block("objects", '[', ']', objects) + "\n}\n";
}

std::vector<std::filesystem::path> foldersToAllow(const Scene& scene, const std::filesystem::path& folder,
                                                  const std::filesystem::path& assetsRoot) {
    std::set<std::filesystem::path> folders;
    const auto isBelow = [](const std::filesystem::path& file, const std::filesystem::path& base) {
        std::error_code ignored;
        const auto relative = file.lexically_relative(std::filesystem::weakly_canonical(base, ignored));
        return !relative.empty() && *relative.begin() != "..";
    };
    const auto include = [&](const std::filesystem::path& file) {
        if (!file.empty() && !isBelow(file, folder) && !isBelow(file, assetsRoot)) folders.insert(file.parent_path());
    };
    for (const Object& object : scene.objects)
        include(object.source.mesh);
    for (const Material& material : scene.materials)
        if (!material.ofMesh) include(material.alphaMap), include(material.diffuseMap);
    return {folders.begin(), folders.end()};
}

} // namespace shadowlab::scene
