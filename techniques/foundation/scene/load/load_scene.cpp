// SCENE on the command line: a `.json`, an `.obj`, a `.gltf` or `.glb`, or the name of a built-in scene.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/gltf/load_gltf.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/scene_file.h"

namespace shadowlab::scene {

namespace {

std::shared_ptr<const Scene> loadJson(const std::filesystem::path& file, const LoadOptions& options) {
    const auto scene = parseSceneJson(readFile(file, options.limits.sceneFileBytes, "scene-file"), file, options);
    image::keepInput(file);
    return scene;
}

} // namespace

std::vector<std::string> builtInScenes(const std::filesystem::path& assetsRoot) {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(assetsRoot / "scenes", error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() == ".json") names.push_back(entry->path().stem().string());
    std::ranges::sort(names); // directories are listed in no defined order
    return names;
}

FileKind fileKind(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return ending == ".json"                       ? FileKind::scene
           : ending == ".obj"                      ? FileKind::obj
           : ending == ".gltf" || ending == ".glb" ? FileKind::gltf
                                                   : FileKind::none;
}

std::filesystem::path sceneFile(const std::string& nameOrPath, const LoadOptions& options) {
    const std::filesystem::path path(nameOrPath);
    if (fileKind(path) != FileKind::none) return path;

    const std::vector<std::string> names = builtInScenes(options.assetsRoot);
    if (std::ranges::find(names, nameOrPath) != names.end())
        return options.assetsRoot / "scenes" / (nameOrPath + ".json");
    std::error_code ignored;
    if (nameOrPath.find('/') != std::string::npos || path.has_extension() || std::filesystem::exists(path, ignored))
        throw Error(ExitStatus::badInput, shownPath(path) + ": is neither a .json scene nor a mesh (.obj, .gltf, .glb); " +
                                              "give a file with one of these endings");
    throw Error(ExitStatus::badInput,
                "there is no built-in scene '" + shown(nameOrPath) + "'; " +
                    (names.empty() ? "none was found in " + shownPath(options.assetsRoot / "scenes")
                                   : suggestion(nameOrPath, names)));
}

std::shared_ptr<const Scene> loadScene(const std::string& nameOrPath, const LoadOptions& options) {
    const std::filesystem::path file = sceneFile(nameOrPath, options);
    switch (fileKind(file)) {
    case FileKind::scene: return loadJson(file, options);
    case FileKind::gltf: return stagedGltf(loadGltf(file, options.normals.value_or(NormalMode::file), options), file, options);
    default: return stageObj(file, options);
    }
}

} // namespace shadowlab::scene
