// SPDX-License-Identifier: MIT
#include "app/course/slide_file.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/course/capture_arguments.h"
#include "app/course/deck.h"
#include "app/picture/derived_stages.h"
#include "app/picture/limits.h"
#include "app/picture/steps/stepping.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/json/json_value.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::course {

namespace {

using Json = nlohmann::ordered_json;

Json numbers(const dvec3& v) { return {v.x, v.y, v.z}; }

/// All of it: what is left out is taken from the scene's own camera.
Json cameraJson(const scene::Camera& camera) {
    Json json{{"position", numbers(camera.positionWorld)},
              {"target", numbers(camera.targetWorld)},
              {"up", numbers(camera.upWorld)},
              {"fovYDegrees", camera.fovYDegrees},
              {"near", camera.near}};
    if (std::isfinite(camera.far)) json["far"] = camera.far;
    return json;
}

/// The panes that the layout shows, in order.
std::vector<const lab::PaneState*> shownStates(const lab::Document& document) {
    if (document.layout == picture::Layout::single) return {&document.panes[static_cast<std::size_t>(document.active)]};
    std::vector<const lab::PaneState*> states;
    for (int i = 0; i < lab::shownPanes(document.layout); ++i)
        states.push_back(&document.panes[static_cast<std::size_t>(i)]);
    return states;
}

std::string stageCaption(const lab::PaneState& state) {
    if (state.stage.isPass) return "after the step " + state.stage.id;
    return picture::captionOf(findTechnique(state.technique), state.stage.id);
}

/// "still-life-2": of small letters, digits and -, and neither a slide nor a file is called so.
std::string freeName(const std::string& sceneName, const std::vector<std::string>& taken,
                     const std::filesystem::path& folder) {
    constexpr std::size_t kLongestStem = 50;
    std::string stem;
    for (const char c : sceneName.substr(0, kLongestStem)) {
        const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool isPlain = (small >= 'a' && small <= 'z') || (small >= '0' && small <= '9');
        stem += isPlain ? small : '-';
    }
    for (int number = 1;; ++number) {
        std::string name = stem + "-" + std::to_string(number);
        std::error_code ignored;
        if (std::ranges::find(taken, name) == taken.end() &&
            !std::filesystem::exists(folder / (name + ".json"), ignored))
            return name;
    }
}

/// Is the scene that the built-in name means just as it is shown, its camera aside?
bool isBuiltIn(const scene::Scene& shown, const std::string& name, const std::filesystem::path& folder,
               const scene::LoadOptions& loading) {
    const std::vector<std::string> known = scene::builtInScenes(loading.assetsRoot);
    if (std::ranges::find(known, name) == known.end()) return false;
    const scene::Snapshot fresh = scene::loadScene(name, loading);
    return scene::sceneText(*fresh, fresh->camera, folder) == scene::sceneText(shown, fresh->camera, folder);
}

/// One past the last character of an array's last element, where the text has its opening bracket at `begin`.
std::size_t endOfLastElement(const std::string& text, std::size_t begin) {
    int depth = 0;
    std::size_t last = begin;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '/' && text[i + 1] == '/') {
            i = std::min(text.find('\n', i), text.size());
        } else if (c == '/' && text[i + 1] == '*') {
            i = text.find("*/", i + 2) + 1;
        } else if (c == '"') {
            for (++i; text[i] != '"'; ++i)
                if (text[i] == '\\') ++i;
            last = i;
        } else {
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
            if (depth == 0) break;
            if (std::string_view(" \t\r\n").find(c) == std::string_view::npos) last = i;
        }
    }
    return last + 1;
}

} // namespace

std::string slideText(const lab::Document& document, const std::string& scene, const std::string& name) {
    const std::vector<const lab::PaneState*> states = shownStates(document);
    Json slide{{"name", name}};
    std::string techniques, stages;
    Json slots = Json::array(), settings = Json::array();
    bool isOutside = false;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const lab::PaneState& state = *states[i];
        const std::string title(findTechnique(state.technique).title);
        if (techniques.find(title) == std::string::npos) techniques += (techniques.empty() ? "" : ", ") + title;
        if (const std::string caption = stageCaption(state); !caption.empty())
            stages += (stages.empty() ? "" : "; ") + caption;
        Json slot{{"technique", state.technique}};
        if (state.stage.isPass)
            slot["step"] = state.stage.idAndLight();
        else if (!state.stage.isPicture())
            slot["stage"] = state.stage.text();
        slots.push_back(std::move(slot));
        const std::string place = states.size() == 1 ? "" : std::to_string(i + 1) + ":";
        for (const auto& [param, value] : state.values())
            settings.push_back(place + state.technique + "." + param + "=" + value);
        isOutside = isOutside || state.stage.isOutside();
    }
    slide["title"] = techniques;
    slide["scene"] = scene;
    slide["camera"] = cameraJson(document.camera);
    slide["layout"] = layoutName(document.layout);
    if (document.layout == picture::Layout::split) slide["split"] = document.split;
    const auto& lights = document.scene->lights;
    if (document.light > 0 && document.light < static_cast<int>(lights.size()))
        slide["light"] = lights[static_cast<std::size_t>(document.light)].name;
    slide["slots"] = std::move(slots);
    if (!settings.empty()) slide["set"] = std::move(settings);
    if (document.picked) slide["pixel"] = {document.picked->x, document.picked->y};
    if (document.partner) slide["partner"] = {document.partner->x, document.partner->y};
    if (isOutside) {
        slide["outside"] = cameraJson(document.outsideCamera);
        const std::string volumes = picture::volumesText(document.outsideChoice, *document.scene);
        if (!volumes.empty()) slide["volumes"] = volumes;
        if (document.outsideChoice.nearClipPyramid) slide["near-clip"] = true;
    }
    std::string what = document.scene->name + ", drawn by " + techniques;
    constexpr std::size_t kLongest = 280; // a caption's
    if (!stages.empty() && what.size() + stages.size() + 2 <= kLongest) what += ": " + stages;
    slide["caption"] = what;
    slide["alt"] = what;
    std::string text; // a line for each key, as people write decks
    for (const auto& [key, value] : slide.items())
        text += (text.empty() ? "{\n  \"" : ",\n  \"") + key +
                "\": " + value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text + "\n}";
}

std::string withSlide(const std::string& deck, const std::filesystem::path& file, const std::string& slide) {
    const scene::JsonDocument document(deck, file, picture::limits().jsonDepth, "a deck, starting with {");
    const auto& members = document.root().members;
    const auto slides = std::ranges::find(members, "slides", &scene::JsonMember::key);
    if (slides == members.end()) document.fail(document.root().offset, "the deck has no \"slides\"; write a list");
    const std::string& text = document.text();
    std::string indented;
    for (const char c : slide) {
        indented += c;
        if (c == '\n') indented += "    ";
    }
    const std::size_t end = endOfLastElement(text, slides->value.offset);
    return text.substr(0, end) + (slides->value.items.empty() ? "" : ",") + "\n    " + indented + text.substr(end);
}

SavedSlide saveSlide(const lab::Document& document, const scene::Scene& shown, const std::filesystem::path& folder,
                     const scene::LoadOptions& loading) {
    SavedSlide saved{folder / kSavedDeck, {}, {}};
    std::string text = "{\n  \"title\": \"Slides\",\n  \"slides\": [\n  ]\n}\n";
    std::vector<std::string> names;
    const image::FolderLock alone(folder); // another window may add to it as well
    std::error_code ignored;
    if (std::filesystem::exists(saved.deck, ignored)) {
        names = Deck(saved.deck.string(), loading).slides();
        text = scene::readFile(saved.deck, picture::limits().sceneFileBytes, "scene-file");
    }
    saved.name = freeName(shown.name, names, folder);
    std::string reference = document.sceneName;
    if (!isBuiltIn(shown, document.sceneName, folder, loading)) {
        reference = saved.name + ".json";
        saved.sceneFile = folder / reference;
        image::writeWhole(saved.sceneFile, scene::sceneText(shown, document.camera, folder));
    }
    image::writeWhole(saved.deck, withSlide(text, saved.deck, slideText(document, reference, saved.name)));
    return saved;
}

std::filesystem::path currentFolder() {
    std::error_code failed;
    std::filesystem::path folder = std::filesystem::current_path(failed);
    if (failed)
        throw Error(ExitStatus::cannotWrite, "the folder that the program was started in is gone; start it in another");
    return folder;
}

} // namespace shadowlab::course
