// SPDX-License-Identifier: MIT
#include "app/film/light_changes.h"

#include <algorithm>
#include <map>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::film {

namespace {

using scene::JsonObject;
using scene::JsonValue;

/// The light that `changes` names.
std::size_t lightNamed(const JsonObject& changes, const std::vector<scene::Light>& lights) {
    const std::string name = changes.text("name");
    const auto found = std::ranges::find(lights, name, &scene::Light::name);
    if (found != lights.end()) return static_cast<std::size_t>(found - lights.begin());
    std::vector<std::string> known;
    for (const scene::Light& light : lights)
        known.push_back(light.name);
    changes.fail("name", "is " + scene::inQuotes(name) + ", and the scene has no such light; " +
                             (known.empty() ? "it has no lights" : suggestion(name, known)));
}

} // namespace

void readLightChanges(const JsonObject& key, std::vector<scene::Light>& lights) {
    std::map<std::size_t, std::size_t> offsetOfLight;
    int count = 0;
    for (const JsonValue& value : key.array("lights")) {
        const JsonObject changes(key.document(), value, "light " + std::to_string(++count) + " of " + key.what(),
                                 {"name", "position", "direction", "coneDegrees", "edgeDegrees", "edgeU", "edgeV",
                                  "radius", "color", "intensity"});
        const std::size_t light = lightNamed(changes, lights);
        const auto [earlier, isNew] = offsetOfLight.emplace(light, value.offset);
        if (!isNew)
            changes.fail("name", "is " + scene::inQuotes(lights[light].name) + " again, first at " +
                                     key.document().place(earlier->second) + "; write the light once in a key");
        lights[light] = scene::readChangedLight(scene::NumberRanges{}, changes, lights[light]);
    }
}

} // namespace shadowlab::film
