// Surface patches: what a scene is divided into for radiosity.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/lecture/parts/rays.h"

namespace shadowlab::lecture {

/// A small piece dA of a surface, and where it is.
struct SurfacePoint {
    dvec3 positionWorld, N; ///< N: unit normal of the front
    double area;            ///< m^2
    const Triangle* triangle = nullptr;
};

/// A piece of a surface that has one radiosity on each of its two sides.
struct Patch {
    std::vector<SurfacePoint> points; ///< evenly on it; their areas add up to the patch's
    double area = 0;                  ///< m^2
    const scene::Material* material = nullptr;
    dvec3 diffuse{0.0}; ///< reflectance, the mean over its points
};

/// What a side of it emits, as a radiance. Sides as in FormFactors.
inline dvec3 emittedBySide(const Patch& patch, std::size_t side) {
    return scene::shinesFrom(*patch.material, side % 2 == 0) ? dvec3(patch.material->emission) : dvec3(0.0);
}

/// Where the patches of a triangle are: m x m of equal size from number `first` on, or all of it in patch `first` (m = 1). m = 0: it
/// has none.
struct Division {
    std::size_t first = 0;
    int m = 0;
};

struct DividedSurfaces {
    std::vector<Patch> patches;
    std::vector<Division> divisions; ///< of each triangle of the scene
};

/// F_ik: which share of what side i sends reaches side k. Sides of patch p are 2 p, its front, and 2 p + 1, its back.
struct FormFactors {
    std::size_t n = 0;      ///< sides
    std::vector<float> all; ///< row after row
    [[nodiscard]] float& at(std::size_t i, std::size_t k) { return all[i * n + k]; }
    [[nodiscard]] float at(std::size_t i, std::size_t k) const { return all[i * n + k]; }
};

/// Patches of one size, as small as a number of at most `most` allows. Throws Error (overLimit) where no size does.
DividedSurfaces divideSurfaces(const RayScene& rays, std::size_t most);

} // namespace shadowlab::lecture
