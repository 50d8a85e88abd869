// The meshes of a glTF file: origin, rounding to float, normals, shared vertices, a part for each primitive.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/gltf/gltf_primitives.h"
#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::scene {

struct GltfMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<int> materials; ///< of each part, in the file; -1: none
};

/// `primitives` are those of that mesh. The result is null where no triangle has an area. Throws Error (badInput).
GltfMesh gltfMesh(const GltfParts& parts, std::size_t mesh, const std::vector<GltfPrimitive>& primitives, NormalMode mode);

} // namespace shadowlab::scene
