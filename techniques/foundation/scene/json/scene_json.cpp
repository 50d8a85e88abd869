// Reads a scene file from the top: camera, colours, then lights, materials and objects by their own readers.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/json/scene_json.h"

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/query/hidden_lights.h"
#include "techniques/foundation/scene/query/unit_notes.h"
#include "techniques/foundation/scene/query/view/default_near.h"

namespace shadowlab::scene {

namespace {

JsonObject cameraKeys(const JsonDocument& document, const JsonValue& value, const std::string& what) {
    return {document, value, what, {"position", "target", "up", "fovYDegrees", "near", "far"}};
}

} // namespace

Camera readCamera(const NumberRanges& ranges, const JsonDocument& document, const JsonValue& value,
                  const std::string& what, const std::optional<Camera>& before) {
    const JsonObject camera = cameraKeys(document, value, what);
    const auto fallback = [&](const dvec3 Camera::*part) {
        return before ? std::optional((*before).*part) : std::nullopt;
    };
    Camera result = before.value_or(Camera{});
    result.positionWorld = camera.vector("position", ranges.anyNumber(), fallback(&Camera::positionWorld));
    result.targetWorld = camera.vector("target", ranges.anyNumber(), fallback(&Camera::targetWorld));
    result.upWorld = camera.direction("up", ranges.anyNumber(), result.upWorld);
    result.fovYDegrees = camera.number("fovYDegrees", Range::strictlyBetween(0.0, 180.0), result.fovYDegrees);
    result.near = camera.number("near", ranges.aboveZero(), result.near);
    if (camera.find("far")) result.far = camera.number("far", ranges.aboveZero());
    // A default is no reason to refuse what was written; a whole scene fits it to what is seen (default_near.h).
    if (!before && !camera.find("near") && result.far <= result.near) result.near = 0.1 * result.far;
    if (!(result.far > result.near))
        camera.fail("far", "is " + numberText(result.far) + "; it must be larger than near, which is " +
                               numberText(result.near));
    const dvec3 view = result.targetWorld - result.positionWorld;
    if (!(glm::dot(view, view) > 0.0)) camera.fail("target", "is the camera's own position; move one of them");
    if (!hasView(result))
        camera.fail("up", "is parallel to the view from position to target; choose another up, such as [0, 0, 1]");
    return result;
}

ReferredFile readReference(const SceneReading& reading, const JsonObject& object, std::string_view key) {
    std::string reference = object.text(key);
    const std::string named = inQuotes(reference) + " ";
    if (!reading.misnamed.isThere(reference))
        if (const auto found = reading.misnamed.find(reference)) {
            reading.misnamedNote.add(object.document().place(object.find(key)->offset), reference, *found);
            reference = *found;
        }
    const auto canonical = reading.folders.resolve(reference);
    if (!canonical) object.fail(key, named + std::string(kOutsideMessage));
    std::filesystem::path path = reading.file.parent_path() / reference;
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
        object.fail(key, named + "is a folder; name a file in it");
    if (const std::string fault = whyUnreadable(path); !fault.empty())
        object.fail(key, named + fault + reading.misnamed.severalAlike() + " (" + shownPath(path) +
                             "); correct the path, it is relative to the scene file");
    return {std::move(path), *canonical};
}

namespace {

/// Before exposure, pictures are half floats. With an exposure below 1/65504 their largest number is darker than white;
/// above 65504 the step between their smallest numbers, 6e-8, is visible as a level of 255.
bool isBeyondHalfFloats(float exposure) {
    constexpr float kLargest = 65504;
    return exposure < 1 / kLargest || exposure > kLargest;
}

/// Notes on the scene as a whole.
void addNotes(Scene& scene, const std::filesystem::path& file) {
    for (const std::string& note : notesOnHiddenLights(scene))
        scene.notes.push_back(shownPath(file) + ": " + note);
    if (const std::string note = noteOnUnits(scene); !note.empty())
        scene.notes.push_back(shownPath(file) + ": " + note);
}

/// Further cameras to choose from, by name.
void readViews(const SceneReading& reading, const JsonObject& top) {
    const JsonValue* views = top.find("views");
    if (!views) return;
    if (views->kind != JsonValue::Kind::object)
        top.fail("views", "is " + std::string(describe(views->kind)) + "; it must be an object {\"name\": { a camera }, ...}");
    for (const JsonMember& view : views->members)
        reading.scene.viewpoints.push_back(
            {view.key, readCamera(reading, reading.document, view.value, "the view '" + shown(view.key) + "'")});
}

/// A camera that names no near plane gets one that fits.
void fitNearPlanes(const SceneReading& reading, const JsonObject& top, const JsonValue& camera) {
    Scene& scene = reading.scene;
    if (!cameraKeys(reading.document, camera, "the camera").find("near")) scene.camera.near = defaultNear(scene, scene.camera);
    for (std::size_t i = 0; i < scene.viewpoints.size(); ++i)
        if (!cameraKeys(reading.document, top.find("views")->members[i].value, "a view").find("near"))
            scene.viewpoints[i].camera.near = defaultNear(scene, scene.viewpoints[i].camera);
}

} // namespace

std::shared_ptr<const Scene> parseSceneJson(const std::string& text, const std::filesystem::path& file,
                                            const LoadOptions& options) {
    const JsonDocument document(text, file, options.limits.jsonDepth);
    const JsonObject top(document, document.root(), "the scene",
                         {"camera", "views", "ambient", "background", "exposure", "lights", "materials", "objects"});
    const auto scene = std::make_shared<Scene>();
    const AllowedFolders folders(file, options);
    MisnamedFiles misnamed(folders);
    MisnamedFilesNote misnamedNote("the file");
    const SceneReading reading{
        {options.limits.coordinate}, document, file, options, folders, *scene, misnamed, misnamedNote};

    scene->name = file.stem().string();
    const JsonValue& camera = top.require("camera", "{\"position\": [3, 2.5, 5], \"target\": [0, 0, 0]}");
    scene->camera = readCamera(reading, document, camera, "the camera");
    readViews(reading, top);
    scene->ambient = top.color("ambient", reading.atLeastZero(), scene->ambient);
    scene->background = top.color("background", reading.atLeastZero(), scene->background);
    scene->exposure = static_cast<float>(top.number("exposure", reading.aboveZero(), scene->exposure));
    if (const JsonValue* exposure = top.find("exposure"); exposure && isBeyondHalfFloats(scene->exposure))
        scene->notes.push_back(document.place(exposure->offset) + ": \"exposure\" " + numberText(scene->exposure) +
                               " asks for brightnesses that pictures do not hold (half floats, 6e-8 to 65504); make it "
                               "a number from 1/65504 to 65504, and intensities as much smaller or larger");
    readLights(reading, top);
    readMaterials(reading, top);
    readObjects(reading, top);
    shineIntoRooms(reading, top);
    misnamedNote.appendTo(scene->notes);
    addEmitterSurfaces(*scene);
    fitNearPlanes(reading, top, camera);
    addNotes(*scene, file);
    scene->memory = memoryBudget(*scene, options.limits);
    return scene;
}

} // namespace shadowlab::scene
