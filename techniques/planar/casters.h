// What is flattened: the casting objects, without the triangles that the light sees edge-on.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/scene.h"
#include "techniques/planar/flat_faces.h"

namespace shadowlab::planar {

struct Caster {
    std::size_t object = 0;
    dvec3 farthestMesh{0.0}; ///< largest absolute coordinates, per axis
    /// The triangles that can block the light. One whose plane holds the light blocks nothing; flattened it is a line, but
    /// where a corner is the light itself, rounding would make a face of it.
    std::vector<TriangleRun> blocking;
};

/// The casters of every light, remade when geometry, places or lights change.
class Casters {
public:
    /// Handles one more light; true when all are done.
    bool buildNext(const scene::Snapshot& snapshot);
    [[nodiscard]] const std::vector<Caster>& of(int light) const { return perLight_[static_cast<std::size_t>(light)]; }

private:
    scene::Revisions made_{0, 0, 0, 0}; ///< for these; no scene has them
    std::vector<std::vector<Caster>> perLight_;
};

} // namespace shadowlab::planar
