// Reads the materials. Colours and shares of light stay within 0..1, so that no surface reflects more light than it
// receives; only `emission` adds light.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/image_files.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

/// The image that `key` names, made by `make(path)`; its path goes to `path`.
template <typename Make>
auto readImage(const SceneReading& reading, const JsonObject& keys, const char* key, std::string& path, const Make& make) {
    const std::filesystem::path file = readReference(reading, keys, key).canonical;
    path = file.string();
    try {
        return make(file);
    } catch (const Error& error) {
        keys.fail(key, "is " + inQuotes(keys.text(key)) + ", " + error.what(), error.status());
    }
}

EmittingSides readEmits(const JsonObject& keys) {
    for (const EmittingSides sides : {EmittingSides::front, EmittingSides::both})
        if (keys.text("emits") == toText(sides)) return sides;
    keys.fail("emits", "is " + inQuotes(keys.text("emits")) + R"(; it must be "front" or "both")");
}

Material readMaterial(const SceneReading& reading, const JsonMember& member, ImageFiles& images) {
    const JsonObject keys(reading.document, member.value, "material '" + shown(member.key) + "'",
                          {"diffuse", "specular", "shininess", "reflectivity", "transparency", "ior", "priority",
                           "glossDegrees", "translucencyDegrees", "emission", "emits", "alphaMap", "diffuseMap"});
    const Range share = Range::between(0.0, 1.0);
    const Range angle = Range::between(0.0, 90.0);
    Material material;
    material.name = member.key;
    material.diffuse = keys.color("diffuse", share, material.diffuse);
    material.specular = keys.color("specular", share, material.specular);
    // A million is a highlight of 0.1 degrees; beyond it the power underflows float everywhere.
    material.shininess = static_cast<float>(keys.number("shininess", Range::between(0.0, 1e6), material.shininess));
    material.reflectivity = keys.number("reflectivity", share, material.reflectivity);
    material.transparency = keys.number("transparency", share, material.transparency);
    // Nothing transparent refracts more than 4; below 1 the outside is the denser medium.
    material.ior = keys.number("ior", Range::between(0.1, 10.0), material.ior);
    material.priority = keys.integer("priority", -1000000, 1000000, material.priority);
    material.glossDegrees = keys.number("glossDegrees", angle, material.glossDegrees);
    material.translucencyDegrees = keys.number("translucencyDegrees", angle, material.translucencyDegrees);
    material.emission = keys.color("emission", reading.atLeastZero(), material.emission);
    if (keys.find("emits")) material.emits = readEmits(keys);
    const Limits& limits = reading.options.limits;
    if (keys.find("alphaMap"))
        material.alphaMask = readImage(reading, keys, "alphaMap", material.alphaMap,
                                       [&](const auto& file) { return images.mask(file, {}, limits); });
    if (keys.find("diffuseMap"))
        material.colorImage = readImage(reading, keys, "diffuseMap", material.diffuseMap,
                                        [&](const auto& file) { return images.colors(file, {}, limits); });
    return material;
}

/// Does the file say which side of that material shines?
bool namesSides(const SceneReading& reading, const JsonObject& top, const Material& material) {
    const JsonValue* materials = top.find("materials");
    if (!materials) return false;
    const auto member = std::ranges::find(materials->members, material.name, &JsonMember::key);
    if (member == materials->members.end()) return false;
    const auto& keys = member->value.members;
    return std::ranges::find(keys, "emits", &JsonMember::key) != keys.end();
}

bool holdsAnEye(const Scene& scene, const Bounds& bounds) {
    const auto isWithin = [&](const Camera& camera) {
        const dvec3& eye = camera.positionWorld;
        return glm::all(glm::greaterThan(eye, bounds.lowerWorld)) && glm::all(glm::lessThan(eye, bounds.upperWorld));
    };
    return isWithin(scene.camera) || std::ranges::any_of(scene.viewpoints, isWithin, &Viewpoint::camera);
}

} // namespace

void shineIntoRooms(const SceneReading& reading, const JsonObject& top) {
    Scene& scene = reading.scene;
    const std::vector<Bounds> bounds = objectBounds(scene);
    std::vector<std::uint32_t*> ofRooms, ofOthers; // the materials of their parts
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const bool isRoom = scene.objects[o].mesh->outward && holdsAnEye(scene, bounds[o]);
        for (std::uint32_t& number : scene.objects[o].partMaterials)
            (isRoom ? ofRooms : ofOthers).push_back(&number);
    }
    const auto uses = [](std::uint32_t number) { return [number](const std::uint32_t* used) { return *used == number; }; };
    for (std::uint32_t number = 0, count = static_cast<std::uint32_t>(scene.materials.size()); number < count; ++number) {
        Material material = scene.materials[number];
        if (material.emission == vec3(0.0f) || material.emits == EmittingSides::both || namesSides(reading, top, material)) continue;
        if (std::ranges::none_of(ofRooms, uses(number))) continue;
        material.emits = EmittingSides::both;
        if (std::ranges::none_of(ofOthers, uses(number))) {
            scene.materials[number] = std::move(material);
            continue;
        }
        material.name += " of a room";
        for (std::uint32_t* const used : ofRooms)
            if (*used == number) *used = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(std::move(material));
    }
}

void readMaterials(const SceneReading& reading, const JsonObject& top) {
    std::vector<Material>& materials = reading.scene.materials;
    materials.assign(1, Material{});
    const JsonValue* value = top.find("materials");
    if (!value) return;
    if (value->kind != JsonValue::Kind::object)
        top.fail("materials",
                 "is " + std::string(describe(value->kind)) + "; it must be an object {\"name\": { ... }, ...}");
    ImageFiles images;
    for (const JsonMember& member : value->members) {
        Material material = readMaterial(reading, member, images);
        if (member.key == "white")
            materials.front() = std::move(material);
        else
            materials.push_back(std::move(material));
    }
}

} // namespace shadowlab::scene
