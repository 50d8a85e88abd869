// What rays are traced through, of one scene. Several may ask it at once: techniques in each half of the window, and the
// judge on its thread. All see the same triangles, so it is built by the first and used by all.
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

/// What was last shared, if it is of this scene and somebody still holds it; else none.
std::shared_ptr<const TracedGeometry> sharedGeometry(const scene::Scene& scene);

/// Lets others find it, in place of what was shared before. Returns it.
std::shared_ptr<const TracedGeometry> share(std::shared_ptr<const TracedGeometry> geometry);

} // namespace shadowlab::trace
