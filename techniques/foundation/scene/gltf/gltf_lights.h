// Lights (KHR_lights_punctual) and cameras of a glTF file, where its nodes put them.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/gltf/gltf_nodes.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Named as their nodes are. Intensities are kept number for number: candela becomes the radiant intensity of a point or spot light,
/// lux the irradiance of a directional one. A white surface under 3 lux is then as bright as under an irradiance of 3.
std::vector<Light> gltfLights(GltfSource& source, const tinygltf::Model& model, const std::vector<GltfNode>& nodes);

/// Named as their nodes are. Each looks at the point in the middle of its picture that is as far away as the middle of `bounds`.
std::vector<Viewpoint> gltfCameras(GltfSource& source, const tinygltf::Model& model, const std::vector<GltfNode>& nodes,
                                   const Bounds& bounds);

} // namespace shadowlab::scene
