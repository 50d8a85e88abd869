// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/mtl_optics.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::scene {

namespace {

double mean(const dvec3& color) { return (color.x + color.y + color.z) / 3.0; }

/// The share that a surface between air and a medium of this refractive index reflects head-on (A. Fresnel, 1823).
double headOnReflectance(double ior) {
    const double ratio = (ior - 1.0) / (ior + 1.0);
    return ratio * ratio;
}

} // namespace

void applyOptics(const MtlStatements& statements, Material& material) {
    if (statements.roughness && !statements.hasShininess) {
        constexpr double kSharpest = 1e6; // as for shininess in scene files
        const double squared = *statements.roughness * *statements.roughness;
        material.shininess = static_cast<float>(std::clamp(2.0 / std::max(squared * squared, 1e-6) - 2.0, 0.0, kSharpest));
    }
    if (statements.metallic) {
        const auto metallic = static_cast<float>(*statements.metallic);
        material.specular = glm::mix(material.specular, material.diffuse, metallic);
        material.diffuse *= 1.0f - metallic;
    }
    const int illum = statements.illum.value_or(2);
    if (illum == 1) material.specular = vec3(0.0f);
    const bool isGlass = illum == 6 || illum == 7, mirrors = illum == 3 || illum == 4 || illum == 5;
    if (isGlass && statements.transmission)
        material.transparency = mean(*statements.transmission);
    else if (isGlass && material.transparency == 0)
        material.transparency = 1.0;
    const double mirrored = isGlass ? headOnReflectance(material.ior) : mirrors ? mean(dvec3(material.specular)) : 0.0;
    material.reflectivity = std::min(mirrored, 1.0 - material.transparency); // no more than all of the light
}

} // namespace shadowlab::scene
