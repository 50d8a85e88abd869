// Which triangles of a scene meet at which edges, by the primitive numbers of rays.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

class SurfaceEdges {
public:
    /// One triangle at an edge. `direction` is +1 where its corners run from the edge's first end to its second, else -1.
    struct Use {
        std::uint32_t primitive = 0;
        int direction = 0;
    };
    struct Edge {
        dvec3 firstCentred{0.0}, secondCentred{0.0};
        std::uint32_t firstUse = 0, useCount = 0;
    };

    SurfaceEdges() = default;
    /// Triangles of one object meet where their corners are at exactly the same place. Objects do not meet.
    SurfaceEdges(const scene::Scene& scene, const WorldTriangles& world);

    [[nodiscard]] const Edge& edge(std::uint32_t index) const { return edges_[index]; }
    [[nodiscard]] std::span<const Use> uses(const Edge& edge) const {
        return std::span(uses_).subspan(edge.firstUse, edge.useCount);
    }
    /// The three edges of a triangle.
    [[nodiscard]] const std::array<std::uint32_t, 3>& ofPrimitive(std::uint32_t primitive) const {
        return ofPrimitive_[primitive];
    }

private:
    std::vector<Edge> edges_;
    std::vector<Use> uses_;
    std::vector<std::array<std::uint32_t, 3>> ofPrimitive_;
};

} // namespace shadowlab::trace
