// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/pack/pack_scene.h"

#include <algorithm>
#include <array>

#include "techniques/foundation/scene/json/json_value.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/scene_file.h"
#include "techniques/foundation/scene/pack/pack_mesh.h"
#include "techniques/foundation/scene/pack/replaced_text.h"

namespace shadowlab::scene {

namespace {

/// Keys whose value is the path of a file: of an object, and of a material.
constexpr std::array<std::string_view, 1> kMeshKeys{"mesh"};
constexpr std::array<std::string_view, 2> kImageKeys{"alphaMap", "diffuseMap"};

const JsonValue* memberOf(const JsonValue& object, std::string_view key) {
    const auto found = std::ranges::find(object.members, key, &JsonMember::key);
    return found == object.members.end() ? nullptr : &found->value;
}

/// A scene file that was read before without a fault.
class ScenePacker {
public:
    ScenePacker(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files,
                const std::function<void()>& pause)
        : options_(options), folders_(file, options), misnamed_(folders_), base_(file.parent_path()), files_(files), pause_(pause),
          document_(readFile(file, options.limits.sceneFileBytes, "scene-file"), file, options.limits.jsonDepth) {
        // As for a mesh in a scene: its own references may use the scene's folder too.
        options_.allowed.push_back(base_.empty() ? "." : base_);
    }

    std::string text() {
        if (const JsonValue* materials = memberOf(document_.root(), "materials"))
            for (const JsonMember& material : materials->members)
                for (const std::string_view key : kImageKeys)
                    if (const JsonValue* image = memberOf(material.value, key)) addImage(*image);
        if (const JsonValue* objects = memberOf(document_.root(), "objects"))
            for (const JsonValue& object : objects->items)
                for (const std::string_view key : kMeshKeys)
                    if (const JsonValue* mesh = memberOf(object, key)) addMesh(*mesh);
        std::ranges::sort(places_, {}, [](const Place& place) { return place.value->offset; });
        ReplacedText replaced(document_.text());
        for (const Place& place : places_)
            replaced.replace(ReplacedText::tokenAt(document_.text(), place.value->offset), textInJson(place.path.generic_string()));
        return std::move(replaced).finish();
    }

private:
    struct Place {
        const JsonValue* value; ///< which named the source
        std::filesystem::path path;
    };

    void addImage(const JsonValue& reference) {
        pause_();
        const std::string found = misnamed_.asFound(reference.string);
        const std::filesystem::path source = base_ / found;
        places_.push_back({&reference, files_.add(folders_.resolve(found).value_or(source), "textures",
                                                  source.filename().string(), [&](const std::filesystem::path&) {
                                                      return readFile(source, options_.limits.imageFileBytes);
                                                  })});
    }

    void addMesh(const JsonValue& reference) {
        pause_();
        places_.push_back({&reference, packMesh(base_ / misnamed_.asFound(reference.string), options_, files_)});
    }

    LoadOptions options_;
    AllowedFolders folders_;
    MisnamedFiles misnamed_;
    std::filesystem::path base_;
    PackedFiles& files_;
    const std::function<void()>& pause_;
    JsonDocument document_;
    std::vector<Place> places_;
};

/// A bare mesh as it is staged, with the place of its copy.
std::string stagedText(const Scene& staged, const std::filesystem::path& folder, const std::filesystem::path& mesh) {
    Scene scene = staged;
    for (Object& object : scene.objects)
        if (!object.source.mesh.empty()) object.source.mesh = std::filesystem::weakly_canonical(folder) / mesh;
    return sceneText(scene, scene.camera, folder);
}

} // namespace

PackedScene packScene(const std::string& nameOrPath, const Scene& scene, const LoadOptions& options,
                      const std::filesystem::path& folder, const std::function<void()>& pause) {
    PackedFiles files(folder);
    const std::filesystem::path name = scene.name + ".json";
    const std::filesystem::path source = sceneFile(nameOrPath, options);
    if (fileKind(source) == FileKind::scene)
        files.write(name, ScenePacker(source, options, files, pause).text());
    else
        files.write(name, stagedText(scene, folder, packMesh(source, options, files)));
    pause();
    return {name, files.count()};
}

} // namespace shadowlab::scene
