// The materials of a glTF file as this program shades them.
//
// glTF describes a surface by its base colour, how metallic it is (m) and how rough (r); its reflection is a microfacet model of width
// alpha = r^2. Here a surface has a Lambert part and a normalised Blinn-Phong highlight, and rays may mirror. So:
//
//  - highlight: exponent 2 / alpha^2 - 2, the Blinn-Phong lobe of the same width (B. Karis, "Real Shading in Unreal Engine 4", 2013);
//    its colour is F0 = ((ior - 1) / (ior + 1))^2, 0.04 for an ior of 1.5, where the surface is no metal, and the base colour where it is.
//  - the reflection of a metal is shared out by alpha: a smooth one mirrors (highlight and `reflectivity`), a wholly rough one
//    reflects as Lambert's law has it, and its base colour counts as diffuse. Without that, a rough metal would be black in all that
//    knows no mirror images, as in radiosity, and its image unseen. So diffuse = base (1 - m (1 - alpha)).
//  - a mirror that is not smooth spreads its rays as the highlight is wide (`glossDegrees`).
//
// Simplified: no Fresnel equations, no masking by microfacets, the same reflection at all angles.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/gltf/gltf_textures.h"

namespace shadowlab::scene {

struct GltfMaterial {
    Material material;
    int texcoordSet = 0;      ///< that its images lie on
    bool isInvisible = false; ///< its alpha is less than its cutoff everywhere
};

/// All materials of the file, in its order, each under a name of its own. What is not shown of them is noted.
std::vector<GltfMaterial> gltfMaterials(GltfSource& source, const tinygltf::Model& model, GltfTextures& textures);

} // namespace shadowlab::scene
