// The casters, with the triangles of most of them in one list, so that one draw call flattens all of these.
//
// Positions in the list are in caster space: world axes, the origin in the middle of its casters. So floats are nearly as
// exact as in mesh space, wherever the scene lies. Drawn one by one are objects with holes (each has its own mask), and
// objects so large or so far away that they would cost the others precision: a sky, a mountain on the horizon.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/gl/handle.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/planar/receivers/flat_faces.h"

namespace shadowlab::planar {

// A caster in the list is at most this many times its own size away from the middle of the list. Its vertices are then
// rounded to a 65,000th of its size, a hundredth of a pixel where it fills the picture.
constexpr double kFarthestInSizes = 256;

struct Caster {
    std::size_t object = 0;
    bool inList = false, hasHoles = false, mirrored = false;
    std::uint32_t firstTriangle = 0, triangleCount = 0; ///< in the list
    dmat4 worldFromMesh{1.0};
    dvec3 farthestCaster{0.0}, farthestMesh{0.0}; ///< largest absolute coordinates in either space, per axis
    /// Behind each of its back faces there is a front face (scene/query/topology/outward_parts.h), as seen from any point out of its box.
    bool outward = false;
    scene::Bounds boundsWorld;
};

/// True if the light (homogeneous) is in the caster's box, or outside by no more than rounding.
bool isWithin(const dvec4& lightWorld, const Caster& caster);

/// A triangle whose plane contains a light to within the precision of floats. Flattened it would be a line or rounding
/// noise, so it is not flattened.
struct NearTriangle {
    std::uint32_t triangle = 0;
    /// True if the light lies on the triangle itself, a rounding error to one side: then everything behind its plane is in
    /// shadow, and `planeWorld` is that plane, positive on the side of the light. Otherwise it casts no visible shadow.
    bool holdsLight = false;
    dvec4 planeWorld{0.0};
};

/// Those of one caster, in ascending order. The point is one of that light: what lies in the plane of a rect casts no shadow.
std::vector<NearTriangle> trianglesNear(const dvec4& lightWorld, const Caster& caster, const scene::Object& object,
                                        const scene::Light& light);

/// Rebuilt when geometry, transforms or holes change. Outward casters come first.
class Casters {
public:
    void update(const scene::Snapshot& snapshot);

    [[nodiscard]] const std::vector<Caster>& all() const { return casters_; }
    [[nodiscard]] const dmat4& worldFromCaster() const { return worldFromCaster_; }
    /// Largest absolute coordinates of the list, per axis.
    [[nodiscard]] const dvec3& farthestInList() const { return farthestInList_; }
    [[nodiscard]] const std::vector<vec3>& positionsCaster() const { return positionsCaster_; }
    /// Counter-clockwise from outside, also where the object is mirrored.
    [[nodiscard]] const std::vector<uvec3>& triangles() const { return triangles_; }

    /// Changes whenever the list of triangles does.
    [[nodiscard]] std::uint64_t listRevision() const { return listRevision_; }

private:
    void chooseList();
    void add(const scene::Object& object, Caster& caster);

    scene::Revisions made_{0, 0, 0, 0}; ///< the cache key; no scene has these numbers
    std::uint64_t listRevision_ = 0;
    std::vector<Caster> casters_;
    dmat4 worldFromCaster_{1.0};
    dvec3 farthestInList_{0.0};
    std::vector<vec3> positionsCaster_;
    std::vector<uvec3> triangles_;
};

/// Some of the casters in the list: the arguments of glMultiDrawElements.
struct DrawList {
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    /// Casters are to be added in their order: neighbours become one run.
    void add(const Caster& caster);
    [[nodiscard]] bool empty() const { return counts.empty(); }
};

class CasterBuffers {
public:
    /// Uploads what is new.
    void update(const Casters& casters);
    void draw(const DrawList& list) const;

private:
    std::uint64_t listRevision_ = 0;
    gl::BufferHandle positions_, indices_;
    gl::VertexArrayHandle vertexArray_;
};

} // namespace shadowlab::planar
