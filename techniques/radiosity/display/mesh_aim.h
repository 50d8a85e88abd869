// Rays to a mesh of many triangles, whichever of them they meet.
//
// What fills the spheres that cover it, as a ball or an egg does, is aimed at by directions into these: nearly all meet it. A tube, a ring or a basket leaves them
// mostly empty. There points of the triangles are chosen, all of the surface alike, and count if the ray arrives; half of them lie on sides that are turned away.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "techniques/radiosity/display/covering_spheres.h"

namespace shadowlab::radiosity {

class MeshAim {
public:
    explicit MeshAim(const scene::Object& object);

    /// By directions into spheres, or else by points?
    [[nodiscard]] bool usesSpheres() const { return upTo_.empty(); }
    /// May all of it that is seen from there be found?
    [[nodiscard]] bool isFoundFrom(const dvec3& placeWorld) const { return !usesSpheres() || !spheres_.hold(placeWorld); }

    struct Way {
        dvec3 direction{0.0}; ///< unit
        double distance = 0;  ///< to the chosen point, metres; 0: the mesh may be met anywhere on the way
        double density = 0;   ///< 1/sr
    };
    /// Nothing if the place lies within the chosen sphere, or in the plane of the chosen triangle. `which` and `where`: of the unit interval and the unit square,
    /// evenly distributed.
    [[nodiscard]] std::optional<Way> choose(const dvec3& fromWorld, double which, const dvec2& where) const;
    /// The density with which that unit vector is chosen, such that the mesh is met so far away and at an angle with that cosine, 1/sr.
    [[nodiscard]] double density(const dvec3& fromWorld, const dvec3& direction, double distance, double cosineThere) const;

private:
    CoveringSpheres spheres_;
    using Triangle = std::array<dvec3, 3>; ///< corners, world
    std::vector<Triangle> triangles_;      ///< empty where spheres are used
    std::vector<double> upTo_;             ///< the area of each and those before it, m^2
};

} // namespace shadowlab::radiosity
