// Reads the lights: each type has its own keys, and a key of another type is an error, not ignored.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

constexpr std::array kTypes{LightType::point, LightType::directional, LightType::spot, LightType::rect,
                            LightType::sphere};

LightType readType(const JsonObject& light) {
    const JsonValue& value = light.require("type", "\"point\" (or directional, spot, rect, sphere)");
    const std::string text = light.text("type");
    std::vector<std::string> names;
    for (const LightType type : kTypes) {
        if (text == toText(type)) return type;
        names.emplace_back(toText(type));
    }
    light.document().fail(value.offset,
                          "\"type\" of " + light.what() + " is " + inQuotes(text) + "; " + suggestion(text, names));
}

/// The keys of this type alone; the object has been checked against all keys of all types before.
JsonObject restrictedTo(LightType type, const JsonObject& light) {
    const std::string what = light.what() + " (type " + std::string(toText(type)) + ")";
    const JsonDocument& document = light.document();
    const JsonValue& value = light.value();
    switch (type) {
    case LightType::point: return {document, value, what, {"name", "type", "color", "intensity", "position"}};
    case LightType::directional: return {document, value, what, {"name", "type", "color", "intensity", "direction"}};
    case LightType::spot:
        return {document,
                value,
                what,
                {"name", "type", "color", "intensity", "position", "direction", "coneDegrees", "edgeDegrees"}};
    case LightType::rect:
        return {document, value, what, {"name", "type", "color", "intensity", "position", "edgeU", "edgeV"}};
    case LightType::sphere:
        return {document, value, what, {"name", "type", "color", "intensity", "position", "radius"}};
    }
    return light;
}

/// Of length one. A direction that already has length one to within rounding is kept. Otherwise its last digits would
/// change each time the scene is saved and loaded.
dvec3 unit(const dvec3& direction) {
    constexpr double kRounding = 1e-15; // of the square of the length: a few units of the last place
    const bool isUnit = std::abs(glm::dot(direction, direction) - 1.0) <= kRounding;
    return isUnit ? direction : glm::normalize(direction);
}

/// The keys of a light that is already of its type. Keys that are left out keep the values of `light`; but the position of
/// a new light, or the direction of a new directional light, is required.
void readKeys(const NumberRanges& ranges, const JsonObject& keys, bool isNew, Light& light) {
    const auto unlessNew = [&](const dvec3& value) { return isNew ? std::nullopt : std::optional(value); };
    light.color = keys.color("color", ranges.atLeastZero(), light.color);
    light.intensity = keys.number("intensity", ranges.atLeastZero(), light.intensity);
    if (light.type != LightType::directional)
        light.positionWorld = keys.vector("position", ranges.anyNumber(), unlessNew(light.positionWorld));
    const bool newSun = isNew && light.type == LightType::directional;
    if (newSun || keys.find("direction")) light.directionWorld = unit(keys.direction("direction", ranges.anyNumber()));
    if (light.type == LightType::spot) {
        light.coneDegrees = keys.number("coneDegrees", Range::strictlyBetween(0.0, 180.0), light.coneDegrees);
        const Range band = Range::between(0.0, 0.5 * light.coneDegrees);
        light.edgeDegrees = keys.number("edgeDegrees", band, light.edgeDegrees);
        if (!band.contains(light.edgeDegrees))
            keys.fail("coneDegrees", "is " + numberText(light.coneDegrees) +
                                         "; it must be at least twice edgeDegrees, " + "which is " +
                                         numberText(light.edgeDegrees));
    }
    if (light.type == LightType::rect) {
        light.edgeUWorld = keys.direction("edgeU", ranges.anyNumber(), light.edgeUWorld);
        light.edgeVWorld = keys.direction("edgeV", ranges.anyNumber(), light.edgeVWorld);
        if (!edgesSpan(light)) keys.fail("edgeV", "is parallel to edgeU; the two must span a parallelogram");
    }
    if (light.type == LightType::sphere) light.radius = keys.number("radius", ranges.length(), light.radius);
}

Light readLight(const SceneReading& reading, const JsonValue& value, const std::string& what) {
    const JsonObject anyLight(reading.document, value, what,
                              {"name", "type", "position", "direction", "coneDegrees", "edgeDegrees", "edgeU", "edgeV",
                               "radius", "color", "intensity"});
    Light light;
    light.type = readType(anyLight);
    const JsonObject keys = restrictedTo(light.type, anyLight);
    light.name = keys.text("name", std::string());
    readKeys(reading, keys, true, light);
    return light;
}

} // namespace

Light readChangedLight(const NumberRanges& ranges, const JsonObject& changes, const Light& before) {
    Light light = before;
    readKeys(ranges, restrictedTo(light.type, changes), false, light);
    return light;
}

void readLights(const SceneReading& reading, const JsonObject& top) {
    const auto values = top.array("lights");
    if (values.size() > reading.options.limits.lights)
        top.fail("lights",
                 "are " + std::to_string(values.size()) + ", more than the limit of " +
                     std::to_string(reading.options.limits.lights) + "; remove some, or set --limit lights=VALUE",
                 ExitStatus::overLimit);
    std::map<std::string, std::size_t> offsetOfName;
    int unnamed = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Light light = readLight(reading, values[i], "light " + std::to_string(i + 1));
        std::size_t offset = values[i].offset;
        if (light.name.empty())
            light.name = "light" + std::to_string(++unnamed);
        else
            offset = std::ranges::find(values[i].members, "name", &JsonMember::key)->value.offset;
        const auto [earlier, isNew] = offsetOfName.emplace(light.name, offset);
        if (!isNew)
            reading.document.fail(offset, "two lights are named \"" + shown(light.name) + "\", the first at " +
                                              reading.document.place(earlier->second) + "; give them different names");
        reading.scene.lights.push_back(std::move(light));
    }
}

} // namespace shadowlab::scene
