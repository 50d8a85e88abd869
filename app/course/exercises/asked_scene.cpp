// SPDX-License-Identifier: MIT
#include "app/course/exercises/asked_scene.h"

#include <nlohmann/json.hpp>

#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::course {

namespace {

using ExerciseJson = nlohmann::json;

// An odd number of pixels on each side, so that one of them has its centre in the middle.
constexpr ivec2 kPictureSize{641, 361};

ExerciseJson jsonOf(dvec3 v) { return ExerciseJson::array({v.x, v.y, v.z}); }

} // namespace

scene::Snapshot sceneFromText(const std::string& text) {
    return scene::parseSceneJson(text, "exercise.json", {.assetsRoot = {}, .allowed = {}, .limits = {}});
}

std::string plateText(const std::string& name, dvec3 centreWorld, dvec2 sizeXz) {
    return ExerciseJson{
        {"name", name}, {"shape", "quad"}, {"size", {sizeXz.x, sizeXz.y}}, {"translate", jsonOf(centreWorld)}}
        .dump();
}

std::string boxText(const std::string& name, dvec3 lowerWorld, dvec3 upperWorld) {
    return ExerciseJson{{"name", name},
                        {"shape", "box"},
                        {"size", jsonOf(upperWorld - lowerWorld)},
                        {"translate", jsonOf(0.5 * (lowerWorld + upperWorld))}}
        .dump();
}

std::string sceneText(const std::string& light, dvec3 eyeWorld, dvec3 targetWorld, const std::string& objects) {
    const ExerciseJson camera{{"position", jsonOf(eyeWorld)}, {"target", jsonOf(targetWorld)}, {"fovYDegrees", 40}};
    return "{\n  \"camera\": " + camera.dump() + ",\n  \"lights\": [" + light +
           "],\n  \"objects\": [\n    {\"name\": \"floor\", \"shape\": \"quad\", \"size\": [200, 200], "
           "\"castsShadow\": false},\n    " +
           objects + "\n  ]\n}\n";
}

std::string pointLightText(dvec3 positionWorld) {
    return ExerciseJson{{"name", "lamp"}, {"type", "point"}, {"position", jsonOf(positionWorld)}, {"intensity", 20}}
        .dump();
}

trace::SceneTracer tracerOf(const scene::Snapshot& scene) {
    trace::SceneTracer tracer;
    tracer.advance(scene, std::chrono::steady_clock::time_point::max());
    return tracer;
}

trace::SurfacePoint middlePoint(const trace::SceneTracer& tracer) {
    const scene::Camera& camera = tracer.scene().camera;
    return tracer.eyePoint(tracer.eyeRays(camera, kPictureSize), dvec2(kPictureSize) / 2.0);
}

Probe middleProbe(const scene::Snapshot& scene, const std::string& technique,
                  const std::vector<std::pair<std::string, std::string>>& settings) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    for (const auto& [parameter, value] : settings)
        params::setFromText(params::find(slot.params, parameter, technique), value, technique);
    View view;
    view.camera = scene->camera;
    view.size = kPictureSize;
    view.picked = kPictureSize / 2;
    return slot.technique->probe(scene, view, kPictureSize / 2, 0);
}

} // namespace shadowlab::course
