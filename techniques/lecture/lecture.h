// The lecture's own algorithms, one in each file of this folder. Start with any of them: none needs another. Their titles, steps and
// pseudocode for the window are in words/; in parts/ is what their pages take for granted, such as finding what a ray meets.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "techniques/lecture/parts/patches.h"
#include "techniques/technique.h"

namespace shadowlab::lecture {

const TechniqueInfo& planar();     // planar.cpp: direct projection method
const TechniqueInfo& shadowMap();  // shadow_map.cpp: shadow map method
const TechniqueInfo& zPass();      // zpass.cpp: shadow volumes, counted between eye and point
const TechniqueInfo& zFail();      // zfail.cpp: shadow volumes, counted behind the point
const TechniqueInfo& rayTracing(); // ray_tracing.cpp: ray casting and the binary ray-tracing tree
const TechniqueInfo& radiosity();  // radiosity.cpp: patches, form factors, radiosity equations

// --- ray_tracing.cpp, as far as its tests ask for it

/// R for a ray of unit direction u that meets a surface with unit normal N, u.N < 0.
dvec3 reflected(const dvec3& u, const dvec3& N);
/// T behind that surface, by Snell's law; nothing in total reflection. `eta`: index of refraction before it / behind it.
std::optional<dvec3> refracted(const dvec3& u, const dvec3& N, double eta);

// --- radiosity.cpp, likewise

/// Fills in what patch j and all patches after it send each other.
void addFormFactors(const RayScene& rays, const std::vector<Patch>& patches, std::size_t j, FormFactors& F);

} // namespace shadowlab::lecture
