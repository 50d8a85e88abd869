// What is flattened: the triangles of all casting objects in one list, so that one call draws the shadows of all of them.
//
// Positions are in caster space: world axes, the origin in the middle of the casters. So they are as exact as floats can
// have them, wherever the scene lies. Objects with holes are not in the list: they are drawn one by one, with their masks.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::planar {

struct Caster {
    std::size_t object = 0;
    std::uint32_t firstTriangle = 0, triangleCount = 0; ///< in the list; with holes: of the object's own mesh
    bool hasHoles = false;
    dmat4 worldFromCaster{1.0}; ///< with holes: world space from mesh space
    dvec3 farthest{0.0};        ///< largest absolute coordinates in caster space, per axis; with holes: in mesh space
    /// Behind each of its back faces there is a front face (scene/outward_parts.h), as seen from any point out of its box.
    bool outward = false;
    scene::Bounds boundsWorld;
};

/// Is the light, homogeneous, in the caster's box, or so near that rounding may have put it out?
bool isWithin(const dvec4& lightWorld, const Caster& caster);

/// Made anew when geometry, places, holes or (for the triangles left out) lights change. Outward casters come first.
class Casters {
public:
    /// Handles one more light; true when all are done.
    bool buildNext(const scene::Snapshot& snapshot);

    [[nodiscard]] const std::vector<Caster>& all() const { return casters_; }
    /// Of those without holes.
    [[nodiscard]] const dmat4& worldFromCaster() const { return worldFromCaster_; }
    [[nodiscard]] const std::vector<vec3>& positionsCaster() const { return positionsCaster_; }
    /// Counter-clockwise from outside, also where the object is mirrored.
    [[nodiscard]] const std::vector<uvec3>& triangles() const { return triangles_; }
    /// The triangles whose plane holds the light's centre, of casters in whose box it is. They block nothing; flattened each is
    /// a line, but where a corner is the light itself, rounding would make a face of it.
    [[nodiscard]] const std::vector<std::uint32_t>& edgeOn(int light) const;

    /// Changes whenever the list of triangles does.
    [[nodiscard]] std::uint64_t listRevision() const { return listRevision_; }

private:
    void list(const scene::Scene& scene);
    void add(const scene::Object& object, Caster& caster);

    scene::Revisions made_{0, 0, 0, 0}; ///< for these; no scene has them
    std::uint64_t listRevision_ = 0;
    std::vector<Caster> casters_;
    dmat4 worldFromCaster_{1.0};
    std::vector<vec3> positionsCaster_;
    std::vector<uvec3> triangles_;
    std::vector<std::vector<std::uint32_t>> edgeOn_; ///< per light
};

} // namespace shadowlab::planar
