// The scene: what there is to see and what lights it. Immutable, in double precision, free of any graphics API.
// SPDX-License-Identifier: MIT
#pragma once
#include <cassert>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/model/camera.h"
#include "techniques/foundation/scene/model/image_placement.h"
#include "techniques/foundation/scene/model/light.h"
#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

class AlphaMask;
class ColorImage;

/// The sides of a surface from which its emission leaves. The front is the side that sees the corners counter-clockwise.
enum class EmittingSides : std::uint8_t { front, both };

/// The name scene files use.
std::string_view toText(EmittingSides sides);

/// Colours are linear RGB. The lower half only matters to ray tracing and radiosity.
struct Material {
    std::string name = "white";
    vec3 diffuse{0.8f};
    vec3 specular{0.0f};
    float shininess = 32.0f; ///< Blinn-Phong exponent
    vec3 emission{0.0f};     ///< radiance
    EmittingSides emits = EmittingSides::front;
    double reflectivity = 0.0;
    double transparency = 0.0;
    double ior = 1.5;
    int priority = 0;
    double glossDegrees = 0.0;
    double translucencyDegrees = 0.0;
    std::string alphaMap;                       ///< resolved path of the image that cuts holes; empty: none
    std::shared_ptr<const AlphaMask> alphaMask; ///< the mask from alphaMap; null exactly if that is empty
    ImagePlacement alphaPlacement;
    std::string diffuseMap;                       ///< resolved path of the image that `diffuse` is multiplied with; empty: none
    std::shared_ptr<const ColorImage> colorImage; ///< the image from diffuseMap; null exactly if that is empty
    ImagePlacement colorPlacement;
    bool ofMesh = false; ///< it comes with a mesh file, and not from the scene's own list
};

/// Does anything shine from that side of a surface of this material?
inline bool shinesFrom(const Material& material, bool isFront) {
    return material.emission != vec3(0.0f) && (isFront || material.emits == EmittingSides::both);
}

/// Where an object comes from, so that it can be written to a scene file (write_scene.h).
struct ObjectSource {
    std::string shape;          ///< kind and numbers, "box 1 2 1"; empty: a mesh file
    std::filesystem::path mesh; ///< canonical path of that file
    std::string node;           ///< which of the things in that file, by name; empty: there is but one
    std::string material;       ///< the scene's material it was given; empty: none
    std::string normals;        ///< "file", "flat" or "smooth"; empty: not said
    dvec3 scale{1.0}, rotateDegrees{0.0}, translateWorld{0.0};
    dmat4 objectFromNode{1.0}; ///< where the file itself puts it, before all that
};

/// Scale, then rotate about world x, then y, then z, then translate, applied to the thing where its file puts it.
dmat4 worldFromObjectOf(const ObjectSource& source);

struct Scene;

/// One thing in the scene.
struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    dmat4 worldFromObject{1.0};
    std::vector<std::uint32_t> partMaterials; ///< index into Scene::materials, one per mesh part
    bool castsShadow = true;
    bool receivesShadow = true;
    dvec3 velocityWorld{0.0}; ///< metres per unit of shutter time
    ObjectSource source;
    int emitterOfLight = -1; ///< index of the light whose surface this object is; -1: an ordinary object
    bool isFurtherPiece = false; ///< of the object before it in the scene: one thing in several meshes (object_pieces.h)
};

/// Mesh space (what the vertex buffers hold) to world space.
dmat4 worldFromMesh(const Object& object);

/// True if the matrix of the object mirrors it (negative determinant), which turns counter-clockwise into clockwise.
bool isMirrored(const Object& object);

/// The material of a triangle, by its number within the object's mesh.
const Material& materialOfTriangle(const Scene& scene, const Object& object, std::uint32_t triangle);

/// Axis-aligned box in world space; empty when lower > upper.
struct Bounds {
    dvec3 lowerWorld{1e300};
    dvec3 upperWorld{-1e300};
    void include(const dvec3& positionWorld) {
        lowerWorld = glm::min(lowerWorld, positionWorld);
        upperWorld = glm::max(upperWorld, positionWorld);
    }
    void include(const Bounds& other) {
        lowerWorld = glm::min(lowerWorld, other.lowerWorld);
        upperWorld = glm::max(upperWorld, other.upperWorld);
    }
    [[nodiscard]] bool isEmpty() const { return lowerWorld.x > upperWorld.x; }
    [[nodiscard]] dvec3 corner(int i) const { ///< i = 0..7
        return {(i & 1) ? upperWorld.x : lowerWorld.x, (i & 2) ? upperWorld.y : lowerWorld.y,
                (i & 4) ? upperWorld.z : lowerWorld.z};
    }
};

/// Box around every vertex of the object (exact, not the box of a box).
Bounds boundsWorld(const Object& object);

/// The boxes of all objects, in their order. Looks at every vertex: once per change of the scene, not per frame.
std::vector<Bounds> objectBounds(const Scene& scene);

/// A process-wide unique revision id.
std::uint64_t newRevision();

/// What changed since a cached result was made: equal ids mean equal content, even in different scenes. A copy of a scene
/// keeps the ids; code that changes a part of the copy gives that part a new id.
struct Revisions {
    std::uint64_t geometry = newRevision();   ///< meshes, and which objects exist
    std::uint64_t transforms = newRevision(); ///< where objects are
    std::uint64_t lights = newRevision();
    std::uint64_t materials = newRevision();
    friend bool operator==(const Revisions&, const Revisions&) = default;
};

/// The estimated memory of the scene, from when it was loaded, and the limit for the scene with everything made from it.
struct MemoryBudget {
    std::uint64_t takenBytes = 0, limitBytes = ~std::uint64_t{0};
};

struct Scene {
    std::string name; ///< "colonnade", or the file's name without its ending
    Camera camera;
    std::vector<Viewpoint> viewpoints; ///< cameras to choose from, each of another name
    vec3 ambient{0.0f};
    vec3 background{0.0f};
    float exposure = 1.0f;
    std::vector<Light> lights;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<std::string> notes; ///< one-line remarks for stderr (missing .mtl, dropped triangles ...)
    MemoryBudget memory;
    Revisions revisions;

    /// The light of that index, as techniques and stages count lights.
    [[nodiscard]] const Light& light(int index) const {
        assert(index >= 0 && static_cast<std::size_t>(index) < lights.size());
        return lights[static_cast<std::size_t>(index)];
    }
};

/// Number of triangles of all objects together.
std::uint64_t triangleCount(const Scene& scene);

/// An immutable scene: what techniques and worker threads work on.
using Snapshot = std::shared_ptr<const Scene>;

} // namespace shadowlab::scene
