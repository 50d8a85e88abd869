// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/unit_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/foundation/scene/query/rough_number.h"

namespace shadowlab::scene {

namespace {

constexpr double kSmall = 0.5, kLarge = 10; ///< metres, of the longest side: of a thing on a table, and of a large room
constexpr double kFarOff = 1000; ///< times as bright, or as dark, as white: beyond all eight bits of a picture

/// Does anything shine beside the lights? It may be meant to light what they do not reach.
bool hasEmitters(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [&](const Object& object) {
        return object.emitterOfLight < 0 && std::ranges::any_of(object.partMaterials, [&](std::uint32_t material) {
            return scene.materials[material].emission != vec3(0.0f);
        });
    });
}

struct Unit {
    const char* name;
    double metres;
};
constexpr std::array kUnits{Unit{"millimetres", 0.001}, Unit{"centimetres", 0.01}, Unit{"inches", 0.0254},
                            Unit{"feet", 0.3048}, Unit{"kilometres", 1000.0}};

/// Irradiance of a surface that faces the light, at the place in the box that is nearest to it, or farthest from it.
struct Irradiance {
    double least, most;
};
Irradiance irradianceIn(const Bounds& box, const Light& light) {
    const dvec3 nearest = glm::clamp(light.positionWorld, box.lowerWorld, box.upperWorld) - light.positionWorld;
    const dvec3 farthest =
        glm::max(glm::abs(box.lowerWorld - light.positionWorld), glm::abs(box.upperWorld - light.positionWorld));
    const double intensity = pointIntensity(light) * std::max({light.color.r, light.color.g, light.color.b});
    return {intensity / glm::dot(farthest, farthest), intensity / glm::dot(nearest, nearest)};
}

/// The unit with which the light comes closest to white.
const Unit& unitFor(double irradiance) {
    return *std::ranges::min_element(
        kUnits, {}, [&](const Unit& unit) { return std::abs(std::log(irradiance / (unit.metres * unit.metres))); });
}

} // namespace

std::string noteOnUnits(const Scene& scene) {
    const Bounds things = thingsBounds(scene);
    if (things.isEmpty()) return {};
    const dvec3 extent = things.upperWorld - things.lowerWorld;
    const double size = std::max({extent.x, extent.y, extent.z});
    if (size >= kSmall && size <= kLarge) return {};
    double least = std::numeric_limits<double>::infinity(), most = 0; // over all places, of the strongest light there
    bool any = false;
    for (const Light& light : scene.lights) {
        if (!(light.intensity > 0) || !(std::max({light.color.r, light.color.g, light.color.b}) > 0)) continue;
        if (light.type == LightType::directional) return {}; // as bright in any unit: nothing is proved
        const Irradiance irradiance = irradianceIn(things, light);
        least = any ? std::max(least, irradiance.least) : irradiance.least;
        most = std::max(most, irradiance.most);
        any = true;
    }
    if (!any) return {};
    least *= scene.exposure, most *= scene.exposure;
    const bool tooSmall = size < kSmall && least > kFarOff, tooLarge = size > kLarge && most < 1 / kFarOff && !hasEmitters(scene);
    if (!tooSmall && !tooLarge) return {};
    const Unit& unit = unitFor(tooSmall ? least : most);
    return "the scene is " + roughNumber(size) + " m across, and its lights are " + (tooSmall ? "brighter" : "darker") +
           " there than white by a factor of " + roughNumber(tooSmall ? least : 1 / most) +
           " at least; was it made in " + unit.name + "? Multiply its positions and sizes by " +
           numberText(unit.metres) + ", or the lights' \"intensity\" by " +
           roughNumber(tooSmall ? 1 / least : 1 / most);
}

} // namespace shadowlab::scene
