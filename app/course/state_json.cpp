// SPDX-License-Identifier: MIT
#include "app/course/state_json.h"

#include <algorithm>
#include <initializer_list>

#include "app/course/capture_arguments.h"
#include "app/course/lessons/lesson_parts.h"
#include "app/film/light_changes.h"
#include "app/lab/settings.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/scene_file.h"

namespace shadowlab::course {

using scene::JsonObject;
using scene::JsonValue;

namespace {

/// The innermost level that has one of the keys; without one the outermost, which then says that it is missing.
const JsonObject& having(std::span<const JsonObject* const> levels, std::initializer_list<std::string_view> keys) {
    for (std::size_t i = levels.size(); i-- > 0;)
        for (const std::string_view key : keys)
            if (levels[i]->find(key)) return *levels[i];
    return *levels.front();
}
bool hasStage(const JsonObject& object) { return object.find("stage") || object.find("step"); }

} // namespace

ShownState StateReader::read(std::span<const JsonObject* const> levels) {
    ShownState state;
    loadScene(having(levels, {"scene"}), state);
    state.camera = state.scene->camera;
    std::vector<scene::Light> lights = state.scene->lights;
    for (const JsonObject* level : levels) {
        if (const JsonValue* camera = level->find("camera"))
            state.camera = scene::readCamera(scene::NumberRanges{}, document_, *camera,
                                             "the camera of " + level->what(), state.camera);
        film::readLightChanges(*level, lights);
    }
    state.scene = scene::withLights(state.scene, lights);
    if (const JsonObject& lightOf = having(levels, {"light"}); lightOf.find("light")) {
        std::vector<std::string> names;
        for (const scene::Light& light : state.scene->lights)
            names.push_back(light.name);
        state.light = oneOf(lightOf, "light", lightOf.text("light"), names);
    }
    // A stage of all slots is that of slots further out, or beside them; slots further in have their own.
    const JsonObject& slotsAt = having(levels, {"slots", "technique"});
    const JsonObject& stageAt = having(levels, {"stage", "step"});
    const bool isOfThem =
        hasStage(stageAt) && std::ranges::find(levels, &stageAt) >= std::ranges::find(levels, &slotsAt);
    const JsonObject* const stageOf = isOfThem ? &stageAt : nullptr;
    const lab::OldSpelling spelledNow = spelling(slotsAt, stageOf, levels);
    readSlots(slotsAt, stageOf, spelledNow, state);
    const JsonObject& layoutOf = having(levels, {"layout"});
    std::vector<std::string> layouts;
    using enum picture::Layout;
    for (const picture::Layout layout : {single, side, split, grid, diff})
        layouts.emplace_back(layoutName(layout));
    state.layout = static_cast<picture::Layout>(
        oneOf(layoutOf, "layout", layoutOf.text("layout", state.slots.size() == 1 ? "single" : "side"), layouts));
    const int shown = state.layout == picture::Layout::grid ? lab::kPanes : lab::shownPanes(state.layout);
    if (static_cast<int>(state.slots.size()) != shown)
        layoutOf.fail("layout", "shows " + scene::counted(static_cast<std::uint64_t>(shown), "technique") + ", and " +
                                    std::to_string(state.slots.size()) + " are under \"slots\"; write as many");
    if (const JsonObject& splitOf = having(levels, {"split"}); splitOf.find("split")) {
        if (state.layout != picture::Layout::split)
            splitOf.fail("split", R"(is the share of the left one of two in "layout": "split"; leave it out)");
        state.split = splitOf.number("split", scene::Range::between(0, 1));
    }
    readSettings(levels, spelledNow, state);
    return state;
}

/// As `capture --stage` takes it; a step is the pass of that name.
picture::StageRef StateReader::readStage(const JsonObject& object, const TechniqueInfo& info, const ShownState& state) {
    if (!hasStage(object)) return {};
    const char* const key = object.find("step") ? "step" : "stage";
    if (object.find("stage") && object.find("step"))
        object.fail("step", "is a pass, and \"stage\" what to show in its place; write either");
    const std::string text = object.text(key);
    const picture::StageRef stage =
        object.find("step") ? picture::StageRef::parsePass(text) : picture::StageRef::parse(text);
    saidAt(document_, object.require(key, "").offset,
           [&] { return picture::resolve(stage, info, *state.scene, state.light); });
    return stage;
}

void StateReader::loadScene(const JsonObject& object, ShownState& state) {
    const std::string reference = object.text("scene");
    state.sceneName = reference;
    if (scene::fileKind(reference) != scene::FileKind::none) {
        const auto found = scene::AllowedFolders(file_, options_).resolve(reference);
        if (!found) object.fail("scene", scene::inQuotes(reference) + " " + std::string(scene::kOutsideMessage));
        state.sceneName = (file_.parent_path() / reference).string();
        if (const std::string fault = scene::whyUnreadable(state.sceneName); !fault.empty())
            object.fail("scene",
                        scene::inQuotes(reference) + " " + fault + "; correct the path, it is relative to this file");
    } else {
        oneOf(object, "scene", reference, scene::builtInScenes(options_.assetsRoot));
    }
    if (loaded_.first != state.sceneName) loaded_ = {state.sceneName, scene::loadScene(state.sceneName, options_)};
    state.scene = loaded_.second;
}

/// What the picture's techniques, stages and settings mean, which were perhaps written for an earlier version.
lab::OldSpelling StateReader::spelling(const JsonObject& slotsAt, const JsonObject* stageOf,
                                       std::span<const JsonObject* const> levels) const {
    std::vector<std::string> techniques, stages, settings;
    const auto add = [&](const JsonObject& slot) {
        const JsonObject& stageAt = stageOf ? *stageOf : slot;
        techniques.push_back(slot.text("technique"));
        stages.push_back(stageAt.find("stage") ? picture::StageRef::parse(stageAt.text("stage")).id : "");
    };
    if (slotsAt.find("technique")) {
        add(slotsAt);
    } else {
        for (const JsonValue& value : slotsAt.array("slots"))
            add(slotObject(value, techniques.size() + 1));
    }
    for (const JsonObject* level : levels)
        for (const auto& [setting, offset] : texts(*level, "set"))
            settings.push_back(setting);
    return {std::move(techniques), stages, settings};
}

JsonObject StateReader::slotObject(const JsonValue& value, std::size_t number) const {
    return {document_, value, "slot " + std::to_string(number), {"technique", "stage", "step"}};
}

void StateReader::readSlots(const JsonObject& object, const JsonObject* stageOf, const lab::OldSpelling& spelling,
                            ShownState& state) {
    if (object.find("technique")) {
        readSlot(object, stageOf, spelling, state);
        return;
    }
    for (const JsonValue& value : object.array("slots"))
        readSlot(slotObject(value, state.slots.size() + 1), stageOf, spelling, state);
    if (state.slots.empty())
        object.fail("slots", R"(is missing or empty; write for example [{"technique": "shadow-map"}])");
    if (state.slots.size() > lab::kPanes)
        object.fail("slots", "has more techniques than the " + std::to_string(lab::kPanes) +
                                 " that the window shows; leave some out");
}

void StateReader::readSlot(const JsonObject& slot, const JsonObject* stageOf, const lab::OldSpelling& spelling,
                           ShownState& state) {
    lab::PaneState pane;
    pane.technique = spelling.techniques()[state.slots.size()];
    const TechniqueInfo& info = saidAt(document_, slot.require("technique", "\"shadow-map\"").offset,
                                       [&]() -> const TechniqueInfo& { return findTechnique(pane.technique); });
    pane.stage = readStage(stageOf ? *stageOf : slot, info, state);
    state.slots.push_back(std::move(pane));
}

/// Settings are checked by slots like those of a capture, and written down as the panes keep them.
void StateReader::readSettings(std::span<const JsonObject* const> levels, const lab::OldSpelling& spelling,
                               ShownState& state) {
    std::vector<picture::Slot> slots = slotsOf(state.slots);
    for (const JsonObject* level : levels)
        for (const auto& [setting, offset] : texts(*level, "set")) {
            saidAt(document_, offset, [&] {
                lab::applySettings(slots, spelling.today(setting));
                return 0;
            });
            if (level == levels.back()) state.settings.push_back(setting);
        }
    for (std::size_t i = 0; i < slots.size(); ++i)
        state.slots[i].settings = settingsOf(slots[i]);
}

} // namespace shadowlab::course
