// SPDX-License-Identifier: MIT
#include "app/cli/common_options.h"

#include <algorithm>

#include "app/context/assets.h"
#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/edit_scene.h"

namespace shadowlab::cli {

void describeScene(DescribedOptions& add) {
    add.option("SCENE", "", "a built-in name (`list scenes`), a .json scene or a mesh (.obj, .gltf, .glb)");
}

void describeView(DescribedOptions& add) {
    add.option("--view", "NAME", "one of the scene's views: a camera of a glTF file, or under \"views\" (`inspect` lists them)");
}

scene::Snapshot loadSeenFrom(const std::string& scene, const std::string& view, const std::vector<std::filesystem::path>& allowed) {
    const scene::Snapshot snapshot = scene::loadScene(scene, loadOptions(allowed));
    if (view.empty()) return snapshot;
    std::vector<std::string> names;
    for (const scene::Viewpoint& viewpoint : snapshot->viewpoints) {
        if (viewpoint.name == view) return scene::seenFrom(snapshot, viewpoint);
        names.push_back(viewpoint.name);
    }
    throw Error(ExitStatus::usage, "--view: " + scene::inQuotes(view) + " is no view of " + scene::shown(scene) + "; " +
                                       (names.empty() ? "it has none beside its own camera: leave --view out" : suggestion(view, names)));
}

void describeBackend(DescribedOptions& add) {
    add.option("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
}

context::Backend backendFrom(const GivenOptions& given) {
    return context::backendFromName(given.text("--backend", "auto"));
}

scene::LoadOptions loadOptions(std::vector<std::filesystem::path> allowed) {
    return {.assetsRoot = context::assetsRoot(), .allowed = std::move(allowed), .limits = picture::limits()};
}

void requireDriverDraws(ivec2 size) {
    const int limit = context::largestSide();
    if (std::max(size.x, size.y) > limit)
        throw Error(ExitStatus::overLimit, "this OpenGL driver draws pictures of up to " + std::to_string(limit) +
                                               " pixels on a side; choose a smaller --size");
}

} // namespace shadowlab::cli
