// The parts of the scene reader, one file each. Every reader takes its piece of JSON and adds to the scene being built.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "techniques/foundation/scene/json/json_object.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The numbers that keys take, by what they stand for.
struct NumberRanges {
    double coordinate = Limits{}.coordinate;

    [[nodiscard]] Range anyNumber() const { return Range::any(coordinate); }
    [[nodiscard]] Range atLeastZero() const { return Range::atLeast(0.0, coordinate); }
    [[nodiscard]] Range aboveZero() const { return Range::above(0.0, coordinate); }
    /// Lengths that have to survive being rounded to float and squared.
    [[nodiscard]] Range length() const { return Range::above(1.0 / coordinate, coordinate); }
};

/// What all readers of a scene file share.
struct SceneReading : NumberRanges {
    const JsonDocument& document;
    const std::filesystem::path& file;
    const LoadOptions& options;
    const AllowedFolders& folders;
    Scene& scene;
    MisnamedFiles& misnamed;         ///< finds files whose names are written as on another computer
    MisnamedFilesNote& misnamedNote; ///< about those that it found
};

/// The camera that `value` describes, its keys checked against each other. A key that is left out keeps what `before`
/// has; without `before`, position and target are required and the rest has its defaults.
Camera readCamera(const NumberRanges& ranges, const JsonDocument& document, const JsonValue& value,
                  const std::string& what, const std::optional<Camera>& before = {});

/// A light of a scene, changed: the keys that `changes` has, checked as in a scene file, the rest as before.
/// `changes` may have any key of any light; one that does not fit the light's type is refused here.
Light readChangedLight(const NumberRanges& ranges, const JsonObject& changes, const Light& before);

void readLights(const SceneReading& reading, const JsonObject& top);

/// Material 0 is always `white`, the file's or the default one.
void readMaterials(const SceneReading& reading, const JsonObject& top);

/// Needs the materials.
void readObjects(const SceneReading& reading, const JsonObject& top);

/// A closed body in which an eye stands is a room, and its emitters shine into it as well, where their materials do not say which side
/// shines ("emits"). Outside and inside exchange no light, so nothing else changes. Needs cameras and objects.
void shineIntoRooms(const SceneReading& reading, const JsonObject& top);

/// A built-in shape as asked for, not built yet.
struct ShapeRequest {
    std::string id;              ///< kind and numbers: requests with equal ids make equal meshes
    std::uint64_t triangles = 0; ///< how many it will have
    std::function<Mesh()> make;
};
ShapeRequest readShape(const SceneReading& reading, const JsonObject& keys);

/// The file a key refers to: inside the allowed folders and a readable regular file, else an error at the key. A file of a name that is
/// written otherwise is taken, and noted.
/// Returns the path as opened: the scene's folder and the reference, not normalised.
struct ReferredFile {
    std::filesystem::path path;      ///< to open, and to name in messages
    std::filesystem::path canonical; ///< to tell files apart
};
ReferredFile readReference(const SceneReading& reading, const JsonObject& object, std::string_view key);

/// worldFromObject = translate * Rz * Ry * Rx * scale. Multiples of 90 degrees turn exactly.
dmat4 worldFromObjectOf(const dvec3& scale, const dvec3& rotateDegrees, const dvec3& translate);

} // namespace shadowlab::scene
