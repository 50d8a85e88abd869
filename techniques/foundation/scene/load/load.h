// From a name or a path to a scene. Every fault is an Error that names file, line and remedy; a scene is loaded whole or
// not at all.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "techniques/foundation/scene/load/memory_estimate.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::scene {

/// What the loaders refuse to go beyond (exit status 6), shown by `list limits`.
struct Limits {
    std::uint64_t fileBytes = 2ull << 30; ///< one mesh
    std::uint64_t materialFileBytes = 16ull << 20;
    std::uint64_t lineBytes = 1ull << 20;        ///< one line of an OBJ or MTL file
    std::uint64_t triangles = 20'000'000;        ///< one scene
    std::uint64_t sceneFileBytes = 64ull << 20;  ///< one scene file
    std::uint64_t imageFileBytes = 256ull << 20; ///< one image, which has as many pixels on a side as
    std::uint32_t imageSide = 16384;             ///< a texture of Mesa's software renderers
    std::uint32_t polygonCorners = 10'000;       ///< one face of an OBJ file (triangulation is quadratic)
    std::uint32_t objects = 100'000;
    std::uint32_t lights = 64;
    std::uint32_t jsonDepth = 64;
    double coordinate = 1e15; ///< metres; beyond it squares overflow float and detail is lost even in double
    std::uint64_t memoryBytes = memoryToUse(); ///< scene and pictures together, as memory_estimate.h guesses them
    std::uint64_t pictureBytes = 0;            ///< the part of it that the requested pictures will need
    std::uint64_t texels = 0;                  ///< of the images that the scene has so far
};

struct LoadOptions {
    std::filesystem::path assetsRoot;           ///< built-in scenes are assetsRoot/scenes/NAME.json
    std::vector<std::filesystem::path> allowed; ///< further folders a scene may take meshes from
    Limits limits;
    std::optional<NormalMode> normals = {}; ///< of a mesh that is staged; none: as the file has them
};

/// SCENE as the command line takes it: a `.json` or `.obj` path, else the name of a built-in scene.
/// An `.obj` is staged. Throws Error (badInput, overLimit).
std::shared_ptr<const Scene> loadScene(const std::string& nameOrPath, const LoadOptions& options);

/// Names of the built-in scenes, sorted.
std::vector<std::string> builtInScenes(const std::filesystem::path& assetsRoot);

/// Scene JSON (docs/scene_format.md) from `text`; `file` is named in errors and is what mesh paths are relative to.
std::shared_ptr<const Scene> parseSceneJson(const std::string& text, const std::filesystem::path& file,
                                            const LoadOptions& options);

/// A Wavefront OBJ with its materials. The text is validated line by line before tinyobjloader sees it.
struct ObjFile {
    Mesh mesh;                       ///< normals as `mode` asks
    std::vector<Mesh> furtherPieces; ///< of a mesh too wide for its detail: what floats about one origin do not hold (obj/mesh_pieces.h)
    std::vector<Material> materials; ///< of the MTL files, named as MeshPart::materialName
    std::vector<std::string> notes;
};
/// Which material has a name: the first of `materials`. A map, because a mesh may have thousands of parts and materials.
/// The keys refer to the names in `materials`, which must not change.
using MaterialsByName = std::unordered_map<std::string_view, std::uint32_t>;
MaterialsByName materialsByName(const std::vector<Material>& materials);

ObjFile loadObj(const std::filesystem::path& file, NormalMode mode, const LoadOptions& options);

/// A scene around a bare mesh: a floor, one key light, and a camera that frames it.
std::shared_ptr<const Scene> stageObj(const std::filesystem::path& file, const LoadOptions& options);

/// Adds, for every rect and sphere light, the surface that eye rays see (it blocks no light itself).
void addEmitterSurfaces(Scene& scene);

/// The scene with its lights replaced by as many of the same types, in the same order. The surfaces of area lights follow.
/// Revisions are new for what differs, and for nothing else; where no light differs, it is the same snapshot.
Snapshot withLights(const Snapshot& snapshot, std::vector<Light> lights);

} // namespace shadowlab::scene
