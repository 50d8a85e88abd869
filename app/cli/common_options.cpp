// SPDX-License-Identifier: MIT
#include "app/cli/common_options.h"

#include <algorithm>

#include "app/context/assets.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/picture/limits.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/scene_file.h"
#include "techniques/foundation/scene/model/edit_scene.h"

namespace shadowlab::cli {

void describeScene(DescribedOptions& add) {
    add.option("SCENE", "", "a built-in name (`list scenes`), a .json scene or a mesh (.obj, .gltf, .glb)");
}

void describeView(DescribedOptions& add) {
    add.option("--view", "NAME", "one of the scene's views: a camera of a glTF file, or under \"views\" (`inspect` lists them)");
}

scene::Snapshot loadSeenFrom(const std::string& scene, const std::string& view, const scene::LoadOptions& loading) {
    const scene::Snapshot snapshot = scene::loadScene(scene, loading);
    if (view.empty()) return snapshot;
    std::vector<std::string> names;
    for (const scene::Viewpoint& viewpoint : snapshot->viewpoints) {
        if (viewpoint.name == view) return scene::seenFrom(snapshot, viewpoint);
        names.push_back(viewpoint.name);
    }
    throw Error(ExitStatus::usage, "--view: " + scene::inQuotes(view) + " is no view of " + scene::shown(scene) + "; " +
                                       (names.empty() ? "it has none beside its own camera: leave --view out" : suggestion(view, names)));
}

int lightWithShadows(const scene::Scene& scene, const std::string& asked, const std::string& name, const std::string& done) {
    if (scene.lights.empty())
        throw Error(ExitStatus::badInput, scene::shown(asked) + ": has no light whose shadows could be " + done + "; add one under \"lights\"");
    return name.empty() ? 0 : picture::lightIndex(scene, name);
}

void describeNormals(DescribedOptions& add) {
    add.option("--normals", "MODE", "of an .obj mesh: file, flat or smooth (default file: as it has them); scenes have a key for it");
}

std::optional<scene::NormalMode> normalsFrom(const GivenOptions& given, const std::string& scene) {
    if (!given.has("--normals")) return {};
    const std::vector<std::string> modes(scene::kNormalModes.begin(), scene::kNormalModes.end());
    const auto mode = static_cast<scene::NormalMode>(choiceFrom("--normals", given.text("--normals"), modes));
    if (!std::filesystem::path(scene).has_extension() || scene::fileKind(scene) == scene::FileKind::scene)
        refuseUsage("--normals: it is for a mesh, and '" + scene::shown(scene) +
                    "' is a scene; write \"normals\" in its objects instead");
    return mode;
}

void describeBackend(DescribedOptions& add) {
    add.option("--backend", "BACKEND", "auto, egl, osmesa or window (default auto: the first that works)");
}

context::Backend backendFrom(const GivenOptions& given) {
    return context::backendFromName(given.text("--backend", "auto"));
}

scene::LoadOptions loadOptions(std::vector<std::filesystem::path> allowed, std::optional<scene::NormalMode> normals) {
    return {.assetsRoot = context::assetsRoot(), .allowed = std::move(allowed), .limits = picture::limits(), .normals = normals};
}

void requireDriverDraws(ivec2 size) {
    const int limit = context::largestSide();
    if (std::max(size.x, size.y) > limit)
        throw Error(ExitStatus::overLimit, "this OpenGL driver draws pictures of up to " + std::to_string(limit) +
                                               " pixels on a side; choose a smaller --size");
}

} // namespace shadowlab::cli
