// Rays, and the surfaces that they meet: for ray tracing, and for the lines of sight between the patches of radiosity.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

namespace shadowlab::lecture {

struct Triangle {
    dvec3 aWorld, bWorld, cWorld;           ///< counter-clockwise seen from the front, unless the object is mirrored
    std::uint32_t object, inObject, number; ///< its place in the object's mesh, and among all triangles of the scene
    std::uint32_t material;
};

/// A surface nearer than this, in metres, touches the one on which a ray starts, and is not met: a million metres from the world's
/// origin a double is rounded to some 1e-10 m.
constexpr double kContact = 1e-9;

struct Ray {
    dvec3 startWorld, u;                         ///< u: unit vector in ray direction
    double nearest = kContact, farthest = 1e300; ///< metres; what is met lies between
    const Triangle* leaves = nullptr;            ///< it starts on this one, and so does not meet it
};

/// Where a ray meets a triangle, if at all: (1 - b - c) A + b B + c C.
struct Hit {
    const Triangle* triangle = nullptr;
    double distance = 0, b = 0, c = 0; ///< metres
};

/// What a ray meets first.
struct Surface {
    dvec3 positionWorld;
    dvec3 N; ///< surface normal, unit, interpolated between the corners, on the side that the ray comes from
    const scene::Material* material;
    dvec3 diffuse; ///< reflectance: the material's, or that of an image or of the vertices there
    const Triangle* triangle;
    double distance; ///< metres along the ray
    bool onFront;    ///< the ray comes from the front of the triangle
};

inline Ray rayFrom(const Surface& surface, const dvec3& u) {
    Ray ray{surface.positionWorld, u};
    ray.leaves = surface.triangle;
    return ray;
}

/// A box around triangles; where they are many, it holds two smaller ones.
struct BoundingVolume {
    scene::Bounds box;
    std::span<const Triangle*> triangles;
    std::unique_ptr<BoundingVolume> first{}, second{};
};

/// All triangles of a scene in world space, and the tree of volumes around them.
class RayScene {
public:
    RayScene() = default;
    explicit RayScene(const scene::Snapshot& snapshot);
    [[nodiscard]] const scene::Scene& scene() const { return *snapshot_; }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
    [[nodiscard]] const scene::Object& objectOf(const Triangle& t) const { return scene().objects[t.object]; }

    /// Which side of the triangle the light is on (scene/facing.h): 1 its front, -1 its back, 0 neither.
    [[nodiscard]] int lightSide(const Triangle& t, int light) const {
        return facing_[static_cast<std::size_t>(light)][t.number];
    }
    /// Of the surface itself, toward the ray's origin: most emitters shine from their front alone.
    [[nodiscard]] vec3 emissionAt(const Surface& surface) const;

    [[nodiscard]] std::optional<Surface> firstSurface(const Ray& ray) const;
    /// Does anything that casts shadows stand on the ray? `light`: it goes to that light, so what lies in the light's plane is only
    /// touched; -1: to none.
    [[nodiscard]] bool isBlocked(const Ray& ray, int light = -1) const;
    /// Does nothing that casts shadows stand between a point of a triangle and another place?
    [[nodiscard]] bool isFree(const Triangle& from, const dvec3& fromWorld, const dvec3& toWorld) const;

private:
    [[nodiscard]] Surface surfaceAt(const Ray& ray, const Hit& hit) const;
    [[nodiscard]] Hit seenInPlaceOf(const Hit& nearest, const Ray& ray) const;
    [[nodiscard]] bool isFront(const Triangle& t, const Ray& ray) const;
    [[nodiscard]] bool isLeft(const Triangle& t, const Ray& ray) const;
    [[nodiscard]] scene::SideRank rankOf(const Triangle& t, const Ray& ray) const;
    scene::Snapshot snapshot_;
    std::vector<std::vector<std::int8_t>> facing_; ///< per light and triangle
    std::shared_ptr<const scene::CoincidentFaces> coincident_;
    std::vector<Triangle> triangles_;     ///< in the order of the scene
    std::vector<const Triangle*> sorted_; ///< as they lie in the tree
    std::unique_ptr<BoundingVolume> all_;
};

} // namespace shadowlab::lecture
