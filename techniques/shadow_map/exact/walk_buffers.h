// A scene's triangles for a shader that walks from one to the next (shaders/shadow_map/walk.glsl).
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>

#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

/// The edges of each mesh, found once.
class Topologies {
public:
    const scene::MeshTopology& of(const std::shared_ptr<const scene::Mesh>& mesh) {
        const auto known = topologies_.find(mesh);
        return known != topologies_.end() ? known->second
                                          : topologies_.emplace(mesh, scene::buildTopology(*mesh)).first->second;
    }
    /// Drops those of meshes that no scene uses any more.
    void forgetUnused() {
        std::erase_if(topologies_, [](const auto& entry) { return entry.first.use_count() == 1; });
    }

private:
    std::map<std::shared_ptr<const scene::Mesh>, scene::MeshTopology> topologies_;
};

/// A triangle beyond an edge that is not there, or that more than one shares.
constexpr std::uint32_t kNoNeighbour = ~std::uint32_t{0};

/// Two texels for each triangle of all objects, counted through: the numbers of its corners and 1 if it may have a hole, and
/// the numbers of the triangles beyond the edges that follow the corners.
gl::TableTexture walkTriangles(const scene::Scene& scene, Topologies& topologies);

/// Where the corners of all objects are, relative to a light, in the same order.
gl::TableTexture walkPositions(const scene::Scene& scene, const LightMaps& maps);

} // namespace shadowlab::shadow_map
