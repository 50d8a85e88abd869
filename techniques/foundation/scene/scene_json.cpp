// Reads a scene file from the top: camera, colours, then lights, materials and objects by their own readers.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/scene_json.h"

#include "techniques/foundation/scene/message_text.h"

namespace shadowlab::scene {

Camera readCamera(const SceneReading& reading, const JsonObject& camera) {
    Camera result;
    result.positionWorld = camera.vector("position", reading.anyNumber());
    result.targetWorld = camera.vector("target", reading.anyNumber());
    result.upWorld = camera.direction("up", reading.anyNumber(), result.upWorld);
    result.fovYDegrees = camera.number("fovYDegrees", Range::strictlyBetween(0.0, 180.0), result.fovYDegrees);
    result.near = camera.number("near", reading.aboveZero(), result.near);
    if (camera.find("far")) {
        result.far = camera.number("far", reading.aboveZero());
        if (!(result.far > result.near))
            camera.fail("far", "is " + numberText(result.far) + "; it must be larger than near, which is " +
                                   numberText(result.near));
    }
    const dvec3 view = result.targetWorld - result.positionWorld;
    if (!(glm::dot(view, view) > 0.0)) camera.fail("target", "is the camera's own position; move one of them");
    // Below a millionth of a radian, the direction "right" would be made of rounding errors.
    if (glm::length(glm::cross(glm::normalize(view), glm::normalize(result.upWorld))) < 1e-6)
        camera.fail("up", "is parallel to the view from position to target; choose another up, such as [0, 0, 1]");
    return result;
}

ReferredFile readReference(const SceneReading& reading, const JsonObject& object, std::string_view key) {
    const std::string reference = object.text(key);
    const std::string named = inQuotes(reference) + " ";
    const auto canonical = reading.folders.resolve(reference);
    if (!canonical) object.fail(key, named + std::string(kOutsideMessage));
    std::filesystem::path path = reading.file.parent_path() / reference;
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
        object.fail(key, named + "is a folder; name a file in it");
    if (const std::string fault = whyUnreadable(path); !fault.empty())
        object.fail(key,
                    named + fault + " (" + shownPath(path) + "); correct the path, it is relative to the scene file");
    return {std::move(path), *canonical};
}

std::shared_ptr<const Scene> parseSceneJson(const std::string& text, const std::filesystem::path& file,
                                            const LoadOptions& options) {
    const JsonDocument document(text, file, options.limits.jsonDepth);
    const JsonObject top(document, document.root(), "the scene",
                         {"camera", "ambient", "background", "exposure", "lights", "materials", "objects"});
    const auto scene = std::make_shared<Scene>();
    const AllowedFolders folders(file, options);
    const SceneReading reading{document, file, options, folders, *scene};

    scene->name = file.stem().string();
    const JsonValue& camera = top.require("camera", "{\"position\": [3, 2.5, 5], \"target\": [0, 0, 0]}");
    scene->camera = readCamera(reading, JsonObject(document, camera, "the camera",
                                                   {"position", "target", "up", "fovYDegrees", "near", "far"}));
    scene->ambient = top.color("ambient", reading.atLeastZero(), scene->ambient);
    scene->background = top.color("background", reading.atLeastZero(), scene->background);
    scene->exposure = static_cast<float>(top.number("exposure", reading.aboveZero(), scene->exposure));
    readLights(reading, top);
    readMaterials(reading, top);
    readObjects(reading, top);
    addEmitterSurfaces(*scene);
    return scene;
}

} // namespace shadowlab::scene
