// Reads the objects: a built-in shape or a mesh file, its placement and its materials. Objects that show the same
// shape or file share one mesh.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <span>

#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/json/scene_json_mesh_files.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::scene {

namespace {

class ObjectReader {
public:
    explicit ObjectReader(const SceneReading& reading) : reading_(reading), files_(reading) {
        for (std::uint32_t i = 0; i < reading.scene.materials.size(); ++i)
            sceneMaterials_[reading.scene.materials[i].name] = i;
    }

    /// Counts the triangles of all shapes before the first is built. Faulty shapes are skipped; read() reports them.
    void countShapes(std::span<const JsonValue> values);
    void read(const JsonValue& value, const std::string& what);

private:
    JsonObject checkedKeys(const JsonValue& value, const std::string& what) const;
    std::vector<LoadedMesh> meshesOf(const JsonObject& keys);
    void add(const JsonObject& keys, LoadedMesh loaded, const std::string& name);
    LoadedMesh shape(const JsonObject& keys, NormalMode mode);
    std::uint32_t materialIndex(const JsonObject& keys) const;
    dvec3 scaleOf(const JsonObject& keys) const;
    void checkTriangles(const JsonObject& keys, std::uint64_t more) const;
    std::string uniqueName(const std::string& wish);

    const SceneReading& reading_;
    MeshFiles files_;
    std::map<std::string, std::uint32_t> sceneMaterials_; ///< those of the scene file, which `material` may name
    std::map<std::pair<std::string, NormalMode>, std::shared_ptr<const Mesh>> shapes_; ///< by ShapeRequest::id
    std::set<std::string> names_;
    std::map<std::string, int> lastNumber_; ///< of the names made up for unnamed objects: box, box2, box3 ...
    std::uint64_t triangles_ = 0;
};

/// The object with exactly the keys its kind has.
JsonObject ObjectReader::checkedKeys(const JsonValue& value, const std::string& what) const {
    const JsonDocument& document = reading_.document;
    const JsonObject all(document, value, what,
                         {"name", "shape", "mesh", "node", "size", "radius", "radii", "segments", "material", "scale",
                          "rotateDegrees", "translate", "normals", "castsShadow", "receivesShadow", "velocity"});
    const bool hasMesh = all.find("mesh") != nullptr, hasShape = all.find("shape") != nullptr;
    if (hasMesh && hasShape) all.fail("mesh", "stands beside \"shape\"; keep one of the two");
    if (!hasMesh && !hasShape)
        document.fail(value.offset, what + " has neither \"mesh\" nor \"shape\"; add \"mesh\": \"FILE.obj\" (or .gltf, .glb) or "
                                           "\"shape\": \"quad\" (or box, sphere, torus)");
    if (hasMesh)
        return {document,
                value,
                what + " (a mesh)",
                {"name", "mesh", "node", "material", "scale", "rotateDegrees", "translate", "normals", "castsShadow",
                 "receivesShadow", "velocity"}};
    const std::string shape = all.text("shape");
    const std::string named = what + " (a " + shown(shape) + ")";
    if (shape == "quad" || shape == "box")
        return {document,
                value,
                named,
                {"name", "shape", "size", "material", "scale", "rotateDegrees", "translate", "normals", "castsShadow",
                 "receivesShadow", "velocity"}};
    if (shape == "sphere")
        return {document,
                value,
                named,
                {"name", "shape", "radius", "segments", "material", "scale", "rotateDegrees", "translate", "normals",
                 "castsShadow", "receivesShadow", "velocity"}};
    if (shape == "torus")
        return {document,
                value,
                named,
                {"name", "shape", "radii", "segments", "material", "scale", "rotateDegrees", "translate", "normals",
                 "castsShadow", "receivesShadow", "velocity"}};
    const std::vector<std::string> shapes{"quad", "box", "sphere", "torus"};
    all.fail("shape", "is " + inQuotes(shape) + "; " + suggestion(shape, shapes));
}

void ObjectReader::checkTriangles(const JsonObject& keys, std::uint64_t more) const {
    const std::uint64_t triangles = triangles_ + more;
    const auto refuse = [&](const std::string& why, const char* limit) {
        reading_.document.fail(keys.value().offset,
                               keys.what() + " brings the scene to " + counted(triangles, "triangle") + ", " + why +
                                   "; simplify or remove objects, or set --limit " + limit + "=VALUE",
                               ExitStatus::overLimit);
    };
    if (triangles > files_.limits().triangles)
        refuse("more than the limit of " + std::to_string(files_.limits().triangles), "triangles");
    if (const std::uint64_t needed = memoryForTriangles(triangles, files_.limits()); needed > files_.limits().memoryBytes)
        refuse("for which " + beyondMemory(needed, files_.limits().memoryBytes), "memory");
}

LoadedMesh ObjectReader::shape(const JsonObject& keys, NormalMode mode) {
    const ShapeRequest request = readShape(reading_, keys);
    checkTriangles(keys, request.triangles); // before anything is built
    std::shared_ptr<const Mesh>& mesh = shapes_[{request.id, mode}];
    if (!mesh) mesh = sharedMesh(withNormals(request.make(), mode));
    return {{{mesh, {kWhite}}}, request.id, {}};
}

void ObjectReader::countShapes(std::span<const JsonValue> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        try {
            const JsonObject keys = checkedKeys(values[i], "object " + std::to_string(i + 1));
            if (!keys.find("shape")) continue;
            const std::uint64_t more = readShape(reading_, keys).triangles;
            checkTriangles(keys, more);
            triangles_ += more;
        } catch (const Error& fault) {
            if (fault.status() == ExitStatus::overLimit) throw;
        }
    }
    triangles_ = 0;
}

std::vector<LoadedMesh> ObjectReader::meshesOf(const JsonObject& keys) {
    NormalMode mode = NormalMode::file; // for a shape: as it is built, smooth or flat
    if (keys.find("normals")) {
        const std::string text = keys.text("normals");
        const std::vector<std::string> modes(kNormalModes.begin(), kNormalModes.end());
        const auto found = std::ranges::find(modes, text);
        if (found == modes.end()) keys.fail("normals", "is " + inQuotes(text) + "; " + suggestion(text, modes));
        mode = static_cast<NormalMode>(found - modes.begin());
    }
    std::vector<LoadedMesh> meshes = keys.find("mesh") ? files_.named(keys, mode) : std::vector{shape(keys, mode)};
    if (!keys.find("material")) return meshes;
    const Material& material = reading_.scene.materials[materialIndex(keys)];
    for (LoadedMesh& loaded : meshes)
        for (LoadedPiece& piece : loaded.pieces) {
            std::ranges::fill(piece.partMaterials, materialIndex(keys));
            for (const MeshPart& part : piece.mesh->parts)
                if (const std::string note = noteOnWholePart(material, part); !note.empty())
                    reading_.scene.notes.push_back(keys.what() + ": " + note);
        }
    return meshes;
}

std::uint32_t ObjectReader::materialIndex(const JsonObject& keys) const {
    const std::string name = keys.text("material");
    if (const auto found = sceneMaterials_.find(name); found != sceneMaterials_.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, index] : sceneMaterials_)
        names.push_back(known);
    keys.fail("material", "is " + inQuotes(name) + ", which \"materials\" does not define; " + suggestion(name, names));
}

dvec3 ObjectReader::scaleOf(const JsonObject& keys) const {
    const JsonValue* value = keys.find("scale");
    if (!value) return dvec3(1.0);
    const dvec3 scale = value->kind == JsonValue::Kind::array ? keys.vector("scale", reading_.anyNumber())
                                                              : dvec3(keys.number("scale", reading_.anyNumber()));
    for (int axis = 0; axis < 3; ++axis)
        if (!reading_.length().contains(std::abs(scale[axis])))
            keys.fail("scale", "is " + numberText(scale[axis]) + " along " + "xyz"[axis] +
                                   "; it must not be zero (or next to it)");
    return scale;
}

std::string ObjectReader::uniqueName(const std::string& wish) {
    int& number = lastNumber_.try_emplace(wish, 0).first->second;
    std::string name;
    do {
        ++number;
        name = wish + (number == 1 ? "" : std::to_string(number));
    } while (!names_.insert(name).second);
    return name;
}

void ObjectReader::read(const JsonValue& value, const std::string& what) {
    const JsonObject keys = checkedKeys(value, what);
    std::vector<LoadedMesh> meshes = meshesOf(keys);
    const std::string kind =
        keys.find("shape") ? keys.text("shape") : std::filesystem::path(reading_.misnamed.asFound(keys.text("mesh"))).stem().string();
    if (meshes.size() == 1) {
        const std::string name = keys.find("name") ? keys.text("name") : uniqueName(keys.find("node") ? meshes.front().node : kind);
        if (!keys.find("node")) meshes.front().node.clear();
        add(keys, std::move(meshes.front()), name);
        return;
    }
    if (reading_.scene.objects.size() + meshes.size() > files_.limits().objects)
        reading_.document.fail(value.offset, keys.what() + " brings the scene beyond the limit of " + std::to_string(files_.limits().objects) +
                                                 " objects; remove some, or set --limit objects=VALUE", ExitStatus::overLimit);
    const std::string before = keys.find("name") ? keys.text("name") + " " : "";
    for (LoadedMesh& loaded : meshes) {
        const std::string name = uniqueName(before + loaded.node);
        add(keys, std::move(loaded), name);
    }
}

void ObjectReader::add(const JsonObject& keys, LoadedMesh loaded, const std::string& name) {
    std::uint64_t triangles = 0;
    for (const LoadedPiece& piece : loaded.pieces)
        triangles += piece.mesh->triangles.size();
    checkTriangles(keys, triangles);
    triangles_ += triangles;

    Object object;
    object.name = name;
    names_.insert(object.name);
    object.source = {.shape = loaded.shape,
                     .mesh = loaded.file,
                     .node = loaded.node,
                     .material = keys.find("material") ? keys.text("material") : "",
                     .normals = keys.find("normals") ? keys.text("normals") : "",
                     .scale = scaleOf(keys),
                     .rotateDegrees = keys.vector("rotateDegrees", reading_.anyNumber(), dvec3(0)),
                     .translateWorld = keys.vector("translate", reading_.anyNumber(), dvec3(0)),
                     .objectFromNode = loaded.objectFromNode};
    object.worldFromObject = worldFromObjectOf(object.source);
    object.castsShadow = keys.boolean("castsShadow", true);
    object.receivesShadow = keys.boolean("receivesShadow", true);
    object.velocityWorld = keys.vector("velocity", reading_.anyNumber(), dvec3(0));

    const std::size_t first = reading_.scene.objects.size();
    Bounds bounds;
    for (LoadedPiece& piece : loaded.pieces) {
        object.mesh = std::move(piece.mesh);
        object.partMaterials = std::move(piece.partMaterials);
        object.isFurtherPiece = reading_.scene.objects.size() > first;
        bounds.include(boundsWorld(object));
        reading_.scene.objects.push_back(object);
    }
    const dvec3 farthest = glm::max(glm::abs(bounds.lowerWorld), glm::abs(bounds.upperWorld));
    const double limit = reading_.options.limits.coordinate;
    if (!(glm::max(farthest.x, glm::max(farthest.y, farthest.z)) <= limit))
        reading_.document.fail(keys.value().offset, keys.what() + " reaches beyond " + numberText(limit) +
                                                 " m from the origin; reduce its scale or translate");
}

} // namespace

void readObjects(const SceneReading& reading, const JsonObject& top) {
    const auto values = top.array("objects");
    if (values.size() > reading.options.limits.objects)
        top.fail("objects",
                 "are " + std::to_string(values.size()) + ", more than the limit of " +
                     std::to_string(reading.options.limits.objects) + "; remove some, or set --limit objects=VALUE",
                 ExitStatus::overLimit);
    ObjectReader reader(reading);
    reader.countShapes(values);
    for (std::size_t i = 0; i < values.size(); ++i)
        reader.read(values[i], "object " + std::to_string(i + 1));
}

} // namespace shadowlab::scene
