// What an MTL file says of a material beside its colours, and what becomes of it here: mirrors, glass, metal and rough surfaces.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/obj/mtl_map.h"

namespace shadowlab::scene {

/// Of one material, what tinyobjloader does not pass on, or not in a way in which it can be told from what was left out.
struct MtlStatements {
    std::optional<MtlMap> diffuseMap, alphaMap;
    std::optional<int> illum;
    std::optional<dvec3> transmission;        ///< Tf: the share of light that passes, per colour
    std::optional<double> metallic, roughness; ///< Pm and Pr, 0..1
    std::optional<double> opacity;            ///< d
    std::optional<double> see;                ///< Tr
    bool hasDiffuse = false, hasShininess = false;
};

/// Turns the statements into the material's shares of mirrored and transmitted light and its highlight, as follows.
///
///  - `illum 1`: no highlight. 3 and 5: a mirror that reflects the mean of Ks. 4: the same, beside what `d` lets pass.
///  - 6 and 7: glass. Tf, or else 1 - d, or else all of the light passes, and it mirrors what glass of that Ni does head-on.
///  - Pr: the width of the highlight, where there is no Ns: exponent 2 / Pr^4 - 2 (B. Karis, "Real Shading in Unreal Engine 4", 2013).
///  - Pm: that share of Kd is reflected as a highlight and not by diffuse reflection.
///
/// Simplified: one share for all colours, and the same at all angles (no Fresnel equations).
void applyOptics(const MtlStatements& statements, Material& material);

} // namespace shadowlab::scene
