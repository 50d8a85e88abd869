// The edges of each mesh, found once.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::shadow_map {

class Topologies {
public:
    const scene::MeshTopology& of(const std::shared_ptr<const scene::Mesh>& mesh) {
        const auto known = topologies_.find(mesh);
        return known != topologies_.end() ? known->second
                                          : topologies_.emplace(mesh, scene::buildTopology(*mesh)).first->second;
    }
    /// Those of meshes that nobody else has any more.
    void forgetUnused() {
        std::erase_if(topologies_, [](const auto& entry) { return entry.first.use_count() == 1; });
    }

private:
    std::map<std::shared_ptr<const scene::Mesh>, scene::MeshTopology> topologies_;
};

} // namespace shadowlab::shadow_map
