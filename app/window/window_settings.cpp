// SPDX-License-Identifier: MIT
#include "app/window/window_settings.h"

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "app/window/window_state.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::window {

void applyMemory(WindowState& ui, const WindowMemory& memory) {
    ui.shown.panel = memory.panel;
    ui.shown.strip = memory.strip;
    ui.shown.handles = memory.handles;
    ui.shown.coarse = memory.coarse;
    if (memory.presenter) togglePresenter(ui);
}

WindowMemory memoryOf(const WindowState& ui, ivec2 windowSize) {
    WindowMemory memory;
    memory.size = windowSize;
    memory.panel = ui.shown.source      ? ui.panelBesideSource
                   : ui.shown.presenter ? ui.panelOutsidePresenter
                                        : ui.shown.panel;
    memory.strip = ui.shown.strip;
    memory.handles = ui.shown.handles;
    memory.coarse = ui.shown.coarse;
    memory.presenter = ui.shown.presenter;
    return memory;
}

std::filesystem::path windowMemoryFile() {
    const auto folder = [](const char* name) -> std::filesystem::path {
        const char* value = std::getenv(name);
        return value && *value ? value : "";
    };
    std::filesystem::path config = folder("XDG_CONFIG_HOME");
    if (config.empty() && !folder("HOME").empty()) config = folder("HOME") / ".config";
    return config.empty() ? config : config / "shadowlab" / "window.json";
}

WindowMemory readWindowMemory(const std::filesystem::path& file) {
    WindowMemory memory;
    constexpr std::uint64_t kLargest = 65536; // bytes; it has seven numbers
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(scene::readFile(file, kLargest), nullptr, false);
    } catch (const Error&) {
        // Not there yet, or nothing that this program wrote: the window begins as for the first time.
    }
    if (!json.is_object()) return memory;
    const auto flag = [&](const char* key, bool& value) {
        if (json.contains(key) && json[key].is_boolean()) value = json[key].get<bool>();
    };
    flag("panel", memory.panel);
    flag("strip", memory.strip);
    flag("presenter", memory.presenter);
    flag("handles", memory.handles);
    flag("coarse", memory.coarse);
    const auto length = [&](const char* key, int& value) {
        // A window may be no smaller than its widgets, and no larger than any screen.
        if (json.contains(key) && json[key].is_number_integer())
            value = static_cast<int>(std::clamp<long long>(json[key].get<long long>(), 320, 7680));
    };
    length("width", memory.size.x);
    length("height", memory.size.y);
    return memory;
}

void writeWindowMemory(const std::filesystem::path& file, const WindowMemory& memory) {
    image::makeFolders(file.parent_path());
    const nlohmann::ordered_json json = {
        {"width", memory.size.x},        {"height", memory.size.y},   {"panel", memory.panel},  {"strip", memory.strip},
        {"presenter", memory.presenter}, {"handles", memory.handles}, {"coarse", memory.coarse}};
    image::writeWhole(file, json.dump(2) + "\n");
}

} // namespace shadowlab::window
