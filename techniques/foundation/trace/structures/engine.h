// Acceleration structures behind one small interface, so that they can be compared.
//
// All but Embree give the same hits to the last bit: they differ in which triangles they try, but try them with the same
// test (ray_triangle.h), and of equally near ones take the lowest. Embree (Wald and others, "Embree: A Kernel Framework
// for Efficient CPU Ray Tracing", SIGGRAPH 2014) answers in float and is built in only where it is installed: a second
// opinion that shares no line with ours, and a measure of speed.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

/// Which triangles a ray may hit; by default all, as a whole.
struct MayHit {
    std::uint32_t except = kNoPrimitive; ///< not this one
    /// none, or: neither what lies in one plane with `except`, but for rounding (scene/query/coincident/coincident_faces.h)
    const scene::CoincidentFaces* coincident = nullptr;
    const std::function<bool(std::uint32_t)>* only = nullptr; ///< none: all; else those for which it says true
    const std::uint8_t* flags = nullptr; ///< none: all; else only those with a flag that is not 0
    const Holes* holes = nullptr;        ///< none: no triangle has holes
    bool operator()(std::uint32_t primitive) const {
        return primitive != except && (flags == nullptr || flags[primitive] != 0) &&
               (coincident == nullptr || !coincident->areTogether(except, primitive)) && (only == nullptr || (*only)(primitive));
    }
    [[nodiscard]] bool inHole(std::uint32_t primitive, const dvec3& barycentric) const {
        return holes != nullptr && (*holes)(primitive, barycentric);
    }
};

/// A ball or a box of a structure, to be shown.
struct StructurePart {
    bool isBall = false;
    int level = 0;                              ///< 0: nothing is around it
    dvec3 lowerCentred{0.0}, upperCentred{0.0}; ///< of the box
    dvec3 centreCentred{0.0};                   ///< of the ball
    double radius = 0;
    int parent = -1; ///< of a tree: the part around it, by its place among the parts; -1: none
    /// Of a grid's cell the triangles that it lists; of the volume around one object that object's first.
    std::vector<std::uint32_t> primitives{};
};

/// The cells of a grid, as a whole.
struct StructureCells {
    dvec3 lowerCentred{0.0}, upperCentred{0.0};
    glm::ivec3 counts{0};
};

class Engine {
public:
    using Deadline = std::chrono::steady_clock::time_point;
    virtual ~Engine() = default;

    /// Goes on building until it is finished (true) or the time has come (false), but always a bit.
    virtual bool advance(Deadline) { return true; }
    /// Share of the building that is done, 0..1.
    [[nodiscard]] virtual double done() const { return 1.0; }

    // From here on: after advance() has returned true. From any thread.

    /// The nearest hit; t, primitive, and the weights of the corners.
    [[nodiscard]] virtual RayHit closest(const Ray& ray, const MayHit& mayHit = {}) const = 0;
    /// Some hit before ray.farthest, or kNoPrimitive: stops at the first it finds, which may be another in each structure.
    [[nodiscard]] virtual std::uint32_t any(const Ray& ray, const MayHit& mayHit = {}) const = 0;
    /// The same two, adding to `tests` what they tried.
    [[nodiscard]] virtual RayHit closest(const Ray& ray, const MayHit& mayHit, RayTests& tests) const = 0;
    [[nodiscard]] virtual std::uint32_t any(const Ray& ray, const MayHit& mayHit, RayTests& tests) const = 0;
    /// True if it counts its tests; Embree does not report them.
    [[nodiscard]] virtual bool counts() const { return true; }

    /// Memory beside the triangles themselves; 0: not known.
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }
    /// Its parts, to be shown: whole levels from the outermost in, as long as no level has more than `most` of them.
    [[nodiscard]] virtual std::vector<StructurePart> parts(std::size_t /*most*/) const { return {}; }
    /// Those that a ray touches before ray.farthest, of parts() or, in a grid, of all cells: of these in order.
    [[nodiscard]] virtual std::vector<StructurePart> passed(const Ray& ray, std::size_t most) const;
    /// Of a grid.
    [[nodiscard]] virtual std::optional<StructureCells> cells() const { return std::nullopt; }
};

/// What an engine is built over. The triangles must outlive it; a primitive's id is its place among them. Those with a
/// corner that is not finite are never hit.
struct EngineInput {
    std::span<const Triangle> triangles;
    std::span<const std::uint32_t> firstOfObject; ///< number of each object's first triangle, rising
};

/// The names of them are those of the parameter `structure`.
enum class Structure { none, objectSpheres, objectBoxes, groups, sphereTree, bvh, grid, embree };
inline constexpr int kStructureCount = 8;

/// Nothing where the program was built without it: Embree alone. To be built by advance().
std::unique_ptr<Engine> makeEngine(Structure structure, const EngineInput& input);

/// A tree that exists already, and outlives the engine.
std::unique_ptr<Engine> makeBvhEngine(const Bvh& bvh);

/// `exact`: the hit is computed once more in double, so that t and weights equal those of the other structures.
std::unique_ptr<Engine> makeEmbreeEngine(std::span<const Triangle> triangles, bool exact = false);

std::unique_ptr<Engine> makeUnstructured(const EngineInput& input);
std::unique_ptr<Engine> makeObjectSpheres(const EngineInput& input);
std::unique_ptr<Engine> makeObjectBoxes(const EngineInput& input);
std::unique_ptr<Engine> makeGroups(const EngineInput& input);
std::unique_ptr<Engine> makeSphereTree(const EngineInput& input);
std::unique_ptr<Engine> makeBvhEngine(const EngineInput& input);
std::unique_ptr<Engine> makeGrid(const EngineInput& input);

} // namespace shadowlab::trace
