// The nodes of a glTF file that its scene shows, with their places in the world.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/gltf/gltf_model.h"

namespace shadowlab::scene {

struct GltfNode {
    std::size_t index; ///< in the file
    std::string name;  ///< its own, or that of what it shows, or "node 3"; each node another one
    dmat4 worldFromNode{1.0};
};

/// All nodes of the scene that is shown, parents before their children, siblings in the order of the file. Throws Error (badInput)
/// where nodes are no trees, or stand where double has no numbers.
std::vector<GltfNode> gltfNodes(GltfSource& source, const tinygltf::Model& model);

} // namespace shadowlab::scene
