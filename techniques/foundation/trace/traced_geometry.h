// The triangles of one scene with their tree, shared by all tracers of the scene: those of the techniques in both halves of
// the window, and that of the judge on its own thread. The first builds it, all use it.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

struct TracedGeometry {
    /// What it depends on: meshes and where they are, not lights and materials.
    struct Revisions {
        std::uint64_t geometry = 0, transforms = 0;
        friend bool operator==(const Revisions&, const Revisions&) = default;
    } revisions;
    WorldTriangles world;
    Bvh bvh;
};

TracedGeometry::Revisions revisionsOf(const scene::Scene& scene);

// From any thread.

/// The geometry that was shared last, if it belongs to this scene and is still in use; else none.
std::shared_ptr<const TracedGeometry> sharedGeometry(const scene::Scene& scene);

/// Lets others find it, in place of what was shared before. Returns it.
std::shared_ptr<const TracedGeometry> share(std::shared_ptr<const TracedGeometry> geometry);

} // namespace shadowlab::trace
