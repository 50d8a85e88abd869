// Reads what pictures show: scene, camera, lights, layout, techniques with their stages and parameters. Lessons and decks
// write it alike (docs/lessons.md, docs/decks.md), with the keys, ranges and words of scene files and of the command line.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "app/course/shown_state.h"
#include "app/lab/old_spelling.h"
#include "techniques/foundation/scene/json/json_object.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::course {

class StateReader {
public:
    /// `file` is the one that is read: scenes are looked for beside it.
    StateReader(const scene::JsonDocument& document, const std::filesystem::path& file,
                const scene::LoadOptions& options)
        : document_(document), file_(file), options_(options) {}

    /// The state that the levels say, from what is common to all pictures to what is this one's own: of scene, layout, light and
    /// slots the last that is there counts; cameras, lights and settings are changed one level after another. `stage` is
    /// that of all slots; `step` names a pass in its place; `technique` means a single slot.
    /// Throws Error (badInput) with FILE:LINE:COLUMN, and all that loading a scene throws.
    ShownState read(std::span<const scene::JsonObject* const> levels);

private:
    void loadScene(const scene::JsonObject& object, ShownState& state);
    lab::OldSpelling spelling(const scene::JsonObject& slotsAt, const scene::JsonObject* stageOf,
                              std::span<const scene::JsonObject* const> levels) const;
    scene::JsonObject slotObject(const scene::JsonValue& value, std::size_t number) const;
    void readSlots(const scene::JsonObject& object, const scene::JsonObject* stageOf, const lab::OldSpelling& spelling,
                   ShownState& state);
    void readSlot(const scene::JsonObject& slot, const scene::JsonObject* stageOf, const lab::OldSpelling& spelling,
                  ShownState& state);
    picture::StageRef readStage(const scene::JsonObject& object, const TechniqueInfo& info, const ShownState& state);
    void readSettings(std::span<const scene::JsonObject* const> levels, const lab::OldSpelling& spelling, ShownState& state);

    const scene::JsonDocument& document_;
    const std::filesystem::path& file_;
    scene::LoadOptions options_;
    std::pair<std::string, scene::Snapshot> loaded_; ///< the scene that was loaded last, and its name
};

} // namespace shadowlab::course
