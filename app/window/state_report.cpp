// SPDX-License-Identifier: MIT
#include "app/window/state_report.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/course/capture_arguments.h"
#include "app/window/gizmo.h"
#include "techniques/foundation/base/fnv.h"
#include "techniques/foundation/gl/handle.h"

namespace shadowlab::window {

namespace {

nlohmann::ordered_json numbers(const dvec3& v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json cameraJson(const scene::Camera& camera) {
    return {{"position", numbers(camera.positionWorld)}, {"target", numbers(camera.targetWorld)}};
}

std::string fingerprint(const gl::Texture2D& picture) {
    const image::Image pixels = picture::PictureEncoder::read(picture);
    return std::to_string(fnv(pixels.rgba.data(), pixels.rgba.size()));
}

} // namespace

nlohmann::ordered_json stateReport(WindowState& ui, const Screen& screen) {
    const lab::Document& document = ui.bench.document();
    nlohmann::ordered_json json;
    json["ran"] = screen.ran();
    json["settled"] = screen.isSettled();
    json["scene"] = document.sceneName;
    json["layout"] = course::layoutName(document.layout);
    json["split"] = document.split;
    json["active"] = document.active + 1;
    json["light"] = document.light;
    json["panes"] = nlohmann::ordered_json::array();
    for (int i = 0; i < lab::kPanes; ++i) {
        const lab::PaneState& state = document.panes[static_cast<std::size_t>(i)];
        const lab::Pane& pane = ui.bench.pane(i);
        nlohmann::ordered_json errors;
        if (const lab::PaneErrors* const known = screen.errors().errors(i))
            errors = {{"falseLit", known->counts.falseLit},
                      {"falseShadow", known->counts.falseShadow},
                      {"exact", known->exact}};
        json["panes"].push_back({{"technique", state.technique},
                                 {"stage", state.stage.text()},
                                 {"settings", state.values()},
                                 {"frameMs", pane.rendered().frameMs},
                                 {"errors", errors},
                                 {"fault", pane.failure()}});
    }
    json["camera"] = cameraJson(document.camera);
    json["outsideCamera"] = cameraJson(document.outsideCamera);
    json["volumes"] = picture::volumesText(document.outsideChoice, *document.scene);
    json["nearClip"] = document.outsideChoice.nearClipPyramid;
    const scene::Scene& scene = *ui.bench.shownScene();
    json["lights"] = nlohmann::ordered_json::array();
    for (const scene::Light& light : scene.lights)
        json["lights"].push_back({{"name", light.name},
                                  {"position", numbers(light.positionWorld)},
                                  {"direction", numbers(light.directionWorld)}});
    using Kind = lab::Selection::Kind;
    const auto index = static_cast<std::size_t>(ui.selection.index);
    // What is undone may take what is selected away.
    const bool isLight = ui.selection.kind == Kind::light && index < scene.lights.size();
    const bool isObject = ui.selection.kind == Kind::object && index < scene.objects.size();
    json["selection"] = isLight ? scene.lights[index].name : isObject ? scene.objects[index].name : std::string();
    const lab::PickedPixel& picked = ui.bench.pickedPixel();
    json["picked"] = nullptr;
    json["partner"] = nullptr;
    if (picked.askedFor.view.partner)
        json["partner"] = {picked.askedFor.view.partner->x, picked.askedFor.view.partner->y};
    if (picked.askedFor.view.picked)
        json["picked"] = {{"pixel", {picked.askedFor.view.picked->x, picked.askedFor.view.picked->y}},
                          {"technique", picked.askedFor.state.technique},
                          {"facts", picked.probe.facts.size()},
                          {"rays", picked.probe.tree.size()}};
    constexpr const char* kModes[] = {"explore", "steps", "lesson", "slides"};
    json["story"] = kModes[static_cast<int>(storyMode(ui))];
    json["lesson"] = nullptr;
    if (ui.lesson.now) {
        constexpr const char* kSteps[] = {"question", "reveal", "artefact", "mend"};
        json["lesson"] = {{"name", ui.lesson.now->text.name}, {"step", kSteps[static_cast<int>(ui.lesson.step)]}};
        if (ui.lesson.score)
            json["lesson"]["score"] = {ui.lesson.score->paintedRight(), ui.lesson.score->shadowFound()};
    }
    json["slide"] = nullptr;
    if (ui.slides.deck)
        json["slide"] = {{"deck", ui.slides.deck->name()}, {"name", ui.slides.slide.name}, {"picture", ui.slides.stop}};
    json["playing"] = ui.bench.animation().playing;
    json["moves"] = {{"lights", ui.bench.animation().lights},
                     {"camera", ui.bench.animation().camera},
                     {"objects", ui.bench.animation().objects}};
    json["speed"] = ui.bench.animation().speed;
    const Shown& shown = ui.shown;
    json["shown"] = {{"keys", shown.keys},           {"panel", shown.panel},
                     {"strip", shown.strip},         {"source", shown.source},
                     {"magnifier", shown.magnifier}, {"blink", shown.blink},
                     {"presenter", shown.presenter}, {"handles", shown.handles},
                     {"coarse", shown.coarse},       {"panelHasKeys", ui.panelHasKeys}};
    json["strip"] = nullptr;
    if (shown.strip) {
        const std::vector<lab::Thumbnail>& all = screen.strip().thumbnails();
        json["strip"] = {
            {"pictures", std::ranges::count_if(all, [](const lab::Thumbnail& one) { return bool(one.picture.texture); })},
            {"toCome", std::ranges::count_if(all, &lab::Thumbnail::isToCome)},
            {"percent", std::lround(100 * screen.strip().progress())}};
    }
    json["canUndo"] = ui.bench.history().canUndo();
    json["canRedo"] = ui.bench.history().canRedo();
    json["draft"] = ui.bench.draft();
    json["messages"] = nlohmann::ordered_json::array();
    for (const Message& message : screen.messages())
        json["messages"].push_back(message.text);
    json["handles"] = nlohmann::ordered_json::object();
    for (const ShownPane& pane : screen.shownPanes())
        for (const auto& [name, place] : handlePlaces(ui, pane, screen.theme()))
            json["handles"][name] = {std::lround(place.x), std::lround(place.y)};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    json["mouse"] =
        ImGui::IsMousePosValid(&mouse) ? nlohmann::ordered_json{mouse.x, mouse.y} : nlohmann::ordered_json();
    const ivec2 size = screen.framebuffer().size();
    json["size"] = {size.x, size.y};
    if (screen.isSettled()) json["picture"] = fingerprint(screen.picture());
    json["glObjects"] = gl::liveObjects;
    return json;
}

std::string stateLine(const nlohmann::ordered_json& report) {
    return report.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace shadowlab::window
