// Reads a path with the readers of the scene file: the same keys, the same ranges, the same words.
// SPDX-License-Identifier: MIT
#include "app/film/light_changes.h"
#include "app/film/path.h"
#include "app/picture/limits.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::film {

namespace {

using scene::JsonDocument;
using scene::JsonObject;
using scene::JsonValue;

/// Half way between unit vectors within a millionth of a radian of opposite, there is nothing but rounding errors.
bool areOpposite(const dvec3& a, const dvec3& b) { return glm::length(glm::normalize(a) + glm::normalize(b)) < 1e-6; }

/// Refuses, at the key that ends it, a way that cannot be gone.
void checkWay(const JsonDocument& document, std::size_t offset, const PathKey& from, const PathKey& to) {
    const std::string way = "from frame " + std::to_string(from.frame) + " to frame " + std::to_string(to.frame) + ", ";
    const std::string remedy = "; add a key in between";
    if (areOpposite(from.state.camera.upWorld, to.state.camera.upWorld))
        document.fail(offset,
                      way + "\"up\" of the camera turns to its opposite, with no telling over which side" + remedy);
    for (std::size_t i = 0; i < to.state.lights.size(); ++i)
        if (areOpposite(from.state.lights[i].directionWorld, to.state.lights[i].directionWorld))
            document.fail(offset, way + "\"direction\" of light " + scene::inQuotes(to.state.lights[i].name) +
                                      " turns to its opposite, with no telling over which side" + remedy);

    const Path path({from, to});
    for (int frame = from.frame + 1; frame < to.frame; ++frame) {
        const CameraAndLights state = path.at(frame);
        const std::string at = way + "at frame " + std::to_string(frame) + ", ";
        if (!scene::hasView(state.camera))
            document.fail(offset, at + "the camera comes to its own target, or looks along its \"up\"" + remedy);
        for (const scene::Light& light : state.lights)
            if (!scene::edgesSpan(light))
                document.fail(offset,
                              at + "the edges of light " + scene::inQuotes(light.name) + " are parallel" + remedy);
    }
}

} // namespace

Path parsePath(const std::string& text, const std::filesystem::path& file, const scene::Scene& scene) {
    const std::string example = R"([{"frame": 1, "camera": {"position": [3, 2, 5]}}, ...])";
    const JsonDocument document(text, file, picture::limits().jsonDepth, "a path, as " + example);
    const JsonValue& list = document.root();
    if (list.kind != JsonValue::Kind::array)
        document.fail(list.offset, "a path is a list, and this is " + std::string(scene::describe(list.kind)) +
                                       "; write " + example);
    if (list.items.empty()) document.fail(list.offset, "the path has no keys; write " + example);

    std::vector<PathKey> keys;
    CameraAndLights state{scene.camera, scene.lights};
    for (const JsonValue& value : list.items) {
        const JsonObject key(document, value, "key " + std::to_string(keys.size() + 1), {"frame", "camera", "lights"});
        const int frame = key.integer("frame", 1, picture::kMostFrames);
        if (!keys.empty() && frame <= keys.back().frame)
            key.fail("frame", "is " + std::to_string(frame) + ", and that of the key before is " +
                                  std::to_string(keys.back().frame) + "; write the keys in the order of their frames");
        if (const JsonValue* camera = key.find("camera"))
            state.camera = scene::readCamera(scene::NumberRanges{}, document, *camera, "the camera of " + key.what(),
                                             state.camera);
        readLightChanges(key, state.lights);
        keys.push_back({frame, state});
        if (keys.size() > 1) checkWay(document, value.offset, keys[keys.size() - 2], keys.back());
    }
    return Path(std::move(keys));
}

Path loadPath(const std::filesystem::path& file, const scene::Scene& scene) {
    const std::string text = scene::readFile(file, picture::limits().sceneFileBytes, "scene-file");
    image::keepInput(file);
    return parsePath(text, file, scene);
}

} // namespace shadowlab::film
