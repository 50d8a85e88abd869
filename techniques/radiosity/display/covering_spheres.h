// Directions to a mesh of many triangles: into spheres that cover it.
//
// A ray that shall find such a mesh need not aim at one of its triangles. It is enough to choose a direction into a sphere around the mesh, all of them
// equally likely (C. Wang, "Physically Correct Direct Lighting for Distribution Ray Tracing", Graphics Gems III, 1992), and to see what it meets. A sphere
// fits a ball, and most other bodies fill a good part of theirs. What is long, as a neon tube, is covered by a row of them: then one is chosen first, by the
// area of its triangles, and the density of a direction is the sum over all spheres that it enters.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::radiosity {

class CoveringSpheres {
public:
    /// Covers nothing.
    CoveringSpheres() = default;
    /// Every triangle lies within one of them.
    explicit CoveringSpheres(const scene::Object& object);

    [[nodiscard]] bool isEmpty() const { return spheres_.empty(); }
    /// Does the place lie within one of them? Then not all of the mesh can be found from there.
    [[nodiscard]] bool hold(const dvec3& positionWorld) const;
    /// A unit vector into one of them; nothing if the place lies within the chosen one. `which` and `where`: of the unit interval and the unit square, evenly
    /// distributed.
    [[nodiscard]] std::optional<dvec3> direction(const dvec3& fromWorld, double which, const dvec2& where) const;
    /// The density with which that unit vector is chosen, 1/sr.
    [[nodiscard]] double density(const dvec3& fromWorld, const dvec3& direction) const;
    [[nodiscard]] std::size_t count() const { return spheres_.size(); }
    /// The area of the discs that one sees of them from far away, m^2.
    [[nodiscard]] double discs() const;

private:
    struct Sphere {
        dvec3 centreWorld{0.0};
        double radius = 0, share = 0; ///< share: of the area
    };
    struct Facet {
        dvec3 cornersWorld[3];
        double area;
        [[nodiscard]] dvec3 middle() const { return (cornersWorld[0] + cornersWorld[1] + cornersWorld[2]) / 3.0; }
    };
    static Sphere around(std::span<const Facet> facets);
    void cover(std::span<Facet> facets, const Sphere& sphere, int divisions);

    std::vector<Sphere> spheres_;
};

} // namespace shadowlab::radiosity
